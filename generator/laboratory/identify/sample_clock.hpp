// SPDX-License-Identifier: GPL-2.0-or-later
// The times at which the samples of a log were taken, as its stamps and its readings tell them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "laboratory/identify/log_layout.hpp"

namespace flatdyn {

struct SampleClock {
  enum class Kind : std::uint8_t {
    even,     // stamps are dt apart
    counted,  // samples were taken dt apart, and their stamps, such as times of arrival, are not even
    stamped,  // samples were taken at their stamps, which are not even: they are interpolated
  };
  Kind kind = Kind::even;
  double dt = 0;      // time between samples, s: the median of an even clock, else the mean
  double jitter = 0;  // standard deviation of the time between stamps, divided by dt; gaps do not count
  double drift = 0;   // the largest change of the time between stamps, as the mean of a second, divided by dt
  double held = 1;    // how many lines all readings stay the same for, on average; 1: they change at every line

  bool is_interpolated() const { return kind == Kind::stamped; }
  // Whether lines that repeat the one before are left out.
  bool leaves_out_repeats() const { return held > 1; }
};

// The kind to take; `automatic`: that in which positions are smoother, where stamps are uneven by more than 2 %.
enum class ClockChoice : std::uint8_t { automatic, stamped, counted };

// Consecutive samples of a log: the channels of each.
using SampleRun = std::vector<std::vector<double>>;

// `runs`: some runs of a log, the first of which has two samples at least.
SampleClock sample_clock(const LogLayout& layout, const std::vector<SampleRun>& runs,
                         ClockChoice choice = ClockChoice::automatic);

// A sentence on what the clock is like and what is done about it; empty for one that is even. longest: the longest time
// between samples that is bridged by interpolation, s; band: the filter's, Hz.
std::string clock_text(const SampleClock& clock, double longest, double band);

// Tells lines that repeat all readings of the one before, where a clock leaves them out.
class RepeatFilter {
 public:
  // longest: lines are left out for no longer than this, s; readings that stay the same for longer do not change.
  RepeatFilter(const SampleClock& clock, int channels, double longest)
      : clock_(clock), longest_(longest), last_(static_cast<std::size_t>(channels)) {}

  // Whether the sample is to be left out.
  bool is_repeat(const double* channels);
  void restart() { has_last_ = false; }

 private:
  const SampleClock& clock_;
  double longest_;
  std::vector<double> last_;  // the last sample that was not left out
  bool has_last_ = false;
};

}  // namespace flatdyn
