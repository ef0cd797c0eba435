// SPDX-License-Identifier: GPL-2.0-or-later
// Rates that are not those of what they belong to, and angles that jump, tell that a log's unit is another one, or that
// an angle was wound up by whole turns. Every sample is looked at: a robot may stand still for long before it moves.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "identify/log_layout.hpp"

namespace flatdyn {

class RateCheck {
 public:
  // dt: what usually passes from sample to sample, s.
  RateCheck(const Mechanism& mechanism, const LogHeading& heading, double dt);

  // The next sample. Its place is asked for where an angle jumps, which is a warning, once for each joint.
  template <class PlaceOf>
  void add(const double* channels, const PlaceOf& place, Diagnostics& diagnostics) {
    if (samples_++ > 0) {
      const double step = channels[0] - last_[0];
      if (step < 2 * dt_) {  // else a gap
        for (RatePair& pair : pairs_) pair.add(last_.data(), channels);
      }
      const double farthest = kFastest * std::max(step, dt_ / 2);  // times that jitter make no speed
      const auto jumps = [&](int q) { return std::abs(channels[q] - last_[static_cast<std::size_t>(q)]) > farthest; };
      const auto jump = std::find_if(angles_.begin(), angles_.end(), jumps);
      if (jump != angles_.end()) {
        complain_about_jump(*jump, channels, place(), diagnostics);
        angles_.erase(jump);
      }
    }
    last_.assign(channels, channels + last_.size());
  }
  // The next sample does not follow the last one.
  void restart() { samples_ = 0; }
  // Rates that are 57.3 times too large or too small are errors, others that are far off are warnings. Nothing is said
  // of poses that are far apart: their rates do not tell what happens between them.
  void finish(const Place& place, Diagnostics& diagnostics) const;
  // The unit, "ms", "us" or "ns", in which times would agree with all rates; nullptr if there is none, or no motion.
  const char* unit_of_times() const;

 private:
  // No robot's joint turns so fast, but many degrees pass in a second.
  static constexpr double kFastest = 100;  // rad/s

  // A channel, and one that should be its rate of change.
  struct RatePair {
    int channel, rate;
    std::string name, rate_name;
    double products = 0, squares = 0;

    void add(const double* before, const double* after) {
      const double expected = (after[rate] + before[rate]) / 2 * (after[0] - before[0]);
      products += (after[channel] - before[channel]) * expected;
      squares += expected * expected;
    }
    // Of the differences of one channel over the mean of the other: 1 if that is its derivative.
    double slope() const { return products / squares; }
    void finish(const Place& place, Diagnostics& diagnostics) const;
  };

  void complain_about_jump(int channel, const double* channels, const Place& place, Diagnostics& diagnostics) const;

  double dt_;
  std::vector<std::string> names_;  // of the channels
  std::vector<RatePair> pairs_;
  std::vector<int> angles_;  // channels of those that have not jumped
  std::vector<double> last_;
  long samples_ = 0;
};

}  // namespace flatdyn
