// SPDX-License-Identifier: GPL-2.0-or-later
// Detects a log's wrong units by rates that do not match the change of their channel, and angles that jump by whole
// turns. Every sample is examined: a robot may stand still for long before it moves.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "laboratory/identify/log_layout.hpp"

namespace flatdyn {

class RateCheck {
 public:
  // dt: the usual time between samples, s. moves: false for logs of poses, whose lines may be anywhere.
  RateCheck(const Mechanism& mechanism, const LogHeading& heading, double dt, bool moves);

  // Adds the next sample. `place` is called if an angle jumps, which causes one warning per joint.
  template <class PlaceOf>
  void add(const double* channels, const PlaceOf& place, Diagnostics& diagnostics) {
    if (samples_++ > 0) {
      const double step = channels[0] - last_[0];
      if (step < 2 * dt_) {  // else there is a gap
        for (RatePair& pair : pairs_) pair.add(last_.data(), channels);
      }
      const double farthest = kFastest * std::max(step, dt_ / 2);  // jitter of the time stamps makes no speed
      const auto jumps = [&](int q) { return std::abs(channels[q] - last_[static_cast<std::size_t>(q)]) > farthest; };
      const auto jump = std::find_if(angles_.begin(), angles_.end(), jumps);
      if (jump != angles_.end()) {
        report_jump(*jump, channels, place(), diagnostics);
        angles_.erase(jump);
      }
    }
    last_.assign(channels, channels + last_.size());
  }
  // Tells that the next sample does not follow the last one.
  void restart() { samples_ = 0; }
  // Rates that are 57.3 times too large or too small are errors; others that are far off are warnings, and so are those
  // that noise hides. Joints that are held are not judged. Poses that are
  // far apart are not judged: their rates do not show what happens between them.
  void finish(const Place& place, Diagnostics& diagnostics) const;
  // The unit of time, "ms", "us" or "ns", that would agree with all rates; nullptr if no unit does, or nothing moves.
  const char* unit_of_times() const;

 private:
  // A speed that no robot's joint reaches in rad/s, but that is common in deg/s.
  static constexpr double kFastest = 100;  // rad/s

  // A channel and the one that should be its rate of change.
  struct RatePair {
    int channel, rate;
    std::string name, rate_name;
    double products = 0, squares = 0, changes = 0, rates = 0, count = 0;

    void add(const double* before, const double* after) {
      const double mean = (after[rate] + before[rate]) / 2, expected = mean * (after[0] - before[0]);
      const double change = after[channel] - before[channel];
      products += change * expected;
      squares += expected * expected;
      changes += change * change;
      rates += mean * mean;
      ++count;
    }
    // The squared correlation of the channel's differences with the mean of its rate.
    double likeness() const { return changes > 0 ? products * products / (squares * changes) : 0; }
    // Whether the rate is hardly more than the flicker of a reading that is held, 1e-3 rad/s or m/s.
    bool is_held() const { return rates < 1e-6 * count; }
    // The slope of a channel's differences against the mean of its rate: 1 if that is its derivative.
    double slope() const { return products / squares; }
    void finish(const Place& place, Diagnostics& diagnostics) const;
  };

  void report_jump(int channel, const double* channels, const Place& place, Diagnostics& diagnostics) const;

  double dt_;
  std::vector<std::string> names_;  // names of the channels
  std::vector<RatePair> pairs_;
  std::vector<int> angles_;  // channels of the angles that have not jumped
  std::vector<double> last_;
  long samples_ = 0;
};

}  // namespace flatdyn
