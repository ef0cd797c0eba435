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

// How many samples are missing before one, and whether they are too many.
class StepCheck {
 public:
  explicit StepCheck(const StreamPlan& plan);

  struct Step {
    bool is_gap = false;  // too long to be bridged, or time goes back
    int missing = 0;
  };
  // From the last sample to one at this time, s. Without a filter times may be any.
  Step step_to(double time);
  void restart() { has_last_ = false; }

 private:
  bool is_next(double step) const;

  const StreamPlan& plan_;
  double dt_, longest_;
  bool has_last_ = false;
  double last_ = 0;  // time of the last sample, s
  double due_ = 0;   // where stamps are not those of samples: the time at which it was due, s
};

class EvenSamples : public SampleReceiver {
 public:
  // A sample depends on no more samples than these before and behind it.
  static constexpr int kReach = 2;

  // Passes samples on late, by one of those that it takes.
  EvenSamples(const StreamPlan& plan, SampleReceiver& receiver);

  // The sample, before which RawSample::missing are missing.
  void sample(const RawSample& raw) override;
  // Passes on what is held back, and begins anew.
  void restart() override;

 private:
  struct Held {
    std::vector<double> channels;
    RawSample sample;
  };

  // Joins the sample with the last one, where their stamps are so close that a cubic through both means nothing.
  bool join(const RawSample& raw);
  // Passes on what is between the sample `at` and the one before it, and that sample itself.
  void pass_on(std::size_t at);
  void pass_on_grid(std::size_t at);
  // The sample at time t, from all that are held; its line is that of `next`.
  void interpolate(double t, long index, const Held& next);

  const StreamPlan& plan_;
  SampleReceiver& receiver_;
  double dt_;
  std::vector<int> quaternions_;  // channels with which they begin
  std::deque<Held> held_;         // up to four
  std::vector<double> between_;
};

}  // namespace flatdyn
