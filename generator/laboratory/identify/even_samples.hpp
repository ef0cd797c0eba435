// SPDX-License-Identifier: GPL-2.0-or-later
// Samples of a log → samples that are dt apart. Missing ones, and those of a clock that is interpolated, are taken from
// the cubic through the two samples before and the two behind them.
#pragma once

#include <deque>
#include <vector>

#include "laboratory/identify/motion_stream.hpp"

namespace flatdyn {

// The longest time between two samples that is bridged, s: three samples may be missing, and more where a cubic is off
// by no more than 0.5 % of a signal at the edge of the band.
double longest_bridge(const SampleFilter& filter);

class EvenSamples {
 public:
  // A sample depends on no more samples than these before and behind it.
  static constexpr int kReach = 2;

  // Passes samples on late, by one of those that it takes. Without a filter it passes them on as they are.
  EvenSamples(const StreamPlan& plan, SampleReceiver& receiver);

  // From the last sample to one at this time, s. A gap is too long to be bridged, or time goes back.
  struct Step {
    bool is_gap = false;
    int missing = 0;
  };
  Step step_to(double time);
  // The next sample, before which so many are missing.
  void add(const RawSample& sample, int missing);
  // Passes on what is held back, and begins anew.
  void restart();

 private:
  struct Held {
    std::vector<double> channels;
    RawSample sample;
    int missing = 0;
  };

  bool is_next(double step) const;
  // Passes on what is between the sample `at` and the one before it, and that sample itself.
  void pass_on(std::size_t at);
  void pass_on_grid(std::size_t at);
  // The sample at time t, from all that are held; its line is that of `next`.
  void interpolate(double t, long index, const Held& next);
  long index_of(double time) const;

  const StreamPlan& plan_;
  SampleReceiver& receiver_;
  double dt_, longest_;
  std::vector<int> quaternions_;  // channels with which they begin
  std::deque<Held> held_;         // up to four
  std::vector<double> between_;
  bool has_last_ = false;
  double last_ = 0;  // time of the last sample, s
  double due_ = 0;   // where stamps are not those of samples: the time at which it was due, s
};

}  // namespace flatdyn
