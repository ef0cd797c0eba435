// SPDX-License-Identifier: GPL-2.0-or-later
// From log to motion: the samples of a log in order, checked, without gaps in time between restarts.
#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "laboratory/identify/base_motion.hpp"
#include "laboratory/identify/block_partition.hpp"
#include "laboratory/identify/channel_noise.hpp"
#include "laboratory/identify/log_layout.hpp"
#include "laboratory/identify/sample_clock.hpp"
#include "laboratory/identify/sample_filter.hpp"

namespace flatdyn {

struct StreamOptions {
  // The edge of the filter's pass band, Hz. None: no filter if the log has all derivatives; else 10 Hz, or an eighth of
  // the sampling rate if that is less, or less again for a motion so slow that its accelerations would be mostly noise.
  std::optional<double> band = std::nullopt;
  // The equations of every N-th sample are used. None: all samples without a filter; with one, at a rate of three
  // bands, so that filtered noise is nearly white.
  std::optional<int> decimate = std::nullopt;
  // A joint that is slower rests, rad/s or m/s: one number for all joints, or one for each. Empty: estimated.
  std::vector<double> rest_speed{};
  // The torques are those of this time before, s: they are late.
  double delay = 0;
  // Whether the log must have torques, and temperatures of the joints. If false, they are not read.
  bool torques = true, temperatures = false;
  ClockChoice clock = ClockChoice::automatic;
  // Samples a second of a log without times. None: its times are read.
  std::optional<double> rate = std::nullopt;
  // The link of a floating base whose frame is that of the inertial measurement unit; empty: the base's.
  std::string imu{};
  // The part k of N, k = 1 … N, whose lines are used.
  int part = 1, parts = 1;
};

// The way to read a log, decided from its heading, its first lines and some lines of the rest.
struct StreamPlan {
  LogHeading heading;
  SampleClock clock;
  double start = 0;  // time of the first sample, s
  SampleFilter filter;
  double delay = 0;   // StreamOptions::delay
  bool moves = true;  // false for logs of poses: all rates are zero
  // By entry of q̇: slower than this a joint may stand still, rad/s or m/s; 0 for a floating base, and for logs of
  // poses, in which no joint moves.
  std::vector<double> rest_speed;
  std::vector<ChannelNoise> noise;      // by channel
  std::vector<ChannelNoise> tau_noise;  // by entry of τ, where friction may jump; empty without torques
  BaseSensors sensors{};                // of a floating base

  const LogLayout& layout() const { return heading.layout; }
  // A time in steps of dt since the first sample, rounded.
  long index_of(double time) const { return std::lround((time - start) / filter.dt); }
  // The lines of the log that so many even samples take, at most.
  int lines_of(int samples) const {
    const double share = clock.is_interpolated() ? 1 + 2 * clock.drift : 1;
    return static_cast<int>(std::ceil(samples * share * clock.held));
  }
  const ChannelNoise& q_noise(int position) const { return noise[static_cast<std::size_t>(LogLayout::q() + position)]; }
};

// Counts of what was read, without the samples of other parts.
struct StreamCount {
  long lines = 0, used = 0, gaps = 0;
  long interpolated = 0;  // missing samples that were put in
  long lost = 0;          // blocks of readings that are frozen or zero, SignalCheck
  long repeated = 0;      // lines that repeat the one before, and were left out

  void add(const StreamCount& other) {
    lines += other.lines;
    used += other.used;
    gaps += other.gaps;
    interpolated += other.interpolated;
    lost += other.lost;
    repeated += other.repeated;
  }
};

// A sample of a log: its channels, the line that it comes from (counted from 0), and its time in steps of dt, rounded.
// A sample that was put in has the line of the next one.
struct RawSample {
  const double* channels = nullptr;
  long line = 0, index = 0;
  int file_line = 0;  // of the file, counted from 1, for messages
  int missing = 0;    // samples that are missing before it
};

// Receives the samples of a log. Between two restarts they are dt apart.
class SampleReceiver {
 public:
  virtual ~SampleReceiver() = default;
  virtual void restart() = 0;
  virtual void sample(const RawSample& sample) = 0;
};

// Reads the first lines, and looks at others. Certain signs of wrong units are errors: positions far outside the joint
// limits, q̇ and q̈ in degrees. Uneven or long times between samples are a warning.
StreamPlan plan_stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamOptions& options,
                       Diagnostics& diagnostics);

// Passes the samples to `receiver` that the lines of a part and the filter's window about them need. Where there is a
// filter they are made even (EvenSamples), and up to three positions in a row that are far from their neighbours are
// interpolated; a gap that is too long to be bridged restarts. Wrong units are detected over all samples
// read: by q against the joint limits, by speeds that no robot has, and by q̇ and q̈ against the change of q. They are
// errors, or warnings if they may be right. A position far outside the limits ends the reading. The count has no `used`
// yet.
StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   BlockPartition& shares, SampleReceiver& receiver, Diagnostics& diagnostics);
// Passes the channels of all samples on.
StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   const std::function<void(const double* channels)>& sink, Diagnostics& diagnostics);

}  // namespace flatdyn
