// SPDX-License-Identifier: GPL-2.0-or-later
// Log → motion: q, q̇, q̈, τ (and the tip force) at the samples that are used. What the log does not have is derived from
// what it has; then every signal passes the same zero-phase low-pass filter, and every N-th sample is used.
#pragma once

#include <compare>
#include <filesystem>
#include <functional>
#include <optional>

#include "identify/block_shares.hpp"
#include "identify/log_layout.hpp"

namespace flatdyn {

// Arrays of n numbers (tau; h_e: of 6; null where the log has none), SI; they hold during the call.
struct MeasuredMotion {
  double time = 0;
  const double *q = nullptr, *qd = nullptr, *qdd = nullptr, *tau = nullptr, *h_e = nullptr;
};
using MotionSink = std::function<void(const MeasuredMotion&)>;

struct StreamOptions {
  // Edge of the filter's pass band, Hz. None: 10 Hz, or an eighth of the sampling rate if that is less, where
  // derivatives are missing; no filter where the log has them all.
  std::optional<double> band = std::nullopt;
  // Every N-th sample is used. None: all without filter; with it, so many that filtered noise is nearly white, a
  // rate of three bands.
  std::optional<int> decimate = std::nullopt;
  // The log must have torques. If not, they are not read.
  bool torques = true;
  // Of the lines of all logs, those of part k of N, k = 1 … N.
  int part = 1, parts = 1;
};

// From samples as they were logged to those that are used.
struct SampleFilter {
  double dt = 0;     // s from sample to sample of the log, median
  double band = 0;   // Hz; 0: no filter
  int decimate = 1;  // every so many-th sample is used

  // Samples that are lost at either end.
  int half_window() const;
  // What is left of white noise after the filter is not quite white: so many samples that are used tell as much as one
  // of white noise of the same size. At least 1.
  double correlation() const;

  auto operator<=>(const SampleFilter&) const = default;
};

// How a log is read, decided from its heading and its first lines.
struct StreamPlan {
  LogHeading heading;
  double jitter = 0;  // standard deviation of the time between samples, over dt
  SampleFilter filter;

  const LogLayout& layout() const { return heading.layout; }
};

// What was read. Samples of other parts do not count.
struct StreamCount {
  long lines = 0, used = 0, gaps = 0;
};

// Reads the first lines. What they tell of wrong units for certain is an error: positions far outside the joint limits,
// q̇ and q̈ that are degrees. The time between samples, where it is uneven or long, is a warning.
StreamPlan plan_stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamOptions& options,
                       Diagnostics& diagnostics);

// All samples of a part that are used, in order. A gap in time starts the filter anew. Wrong units are told by q
// against the joint limits, by speeds that no robot has, and by q̇ and q̈ against the change of q, over all samples that
// are read: errors, or warnings where they may be right. A position far outside the limits is the end.
StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   BlockShares& shares, const MotionSink& sink, Diagnostics& diagnostics);
// All samples of the log.
StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   const MotionSink& sink, Diagnostics& diagnostics);

}  // namespace flatdyn
