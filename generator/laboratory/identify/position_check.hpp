// SPDX-License-Identifier: GPL-2.0-or-later
// Detects a log's wrong unit, degrees or millimetres, by positions that a joint cannot have.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "laboratory/identify/log_layout.hpp"

namespace flatdyn {

class PositionCheck {
 public:
  PositionCheck(const Mechanism& mechanism, const LogHeading& heading);

  // Whether a position of this sample is outside its expected range. Cheap: it is called for every sample.
  bool is_odd(const double* channels) const {
    for (std::size_t i = 0; i < largest_.size(); ++i) {
      if (std::abs(channels[static_cast<std::size_t>(LogLayout::q()) + i]) > largest_[i]) return true;
    }
    return false;
  }
  // Returns false after an error: a position far outside the limits. A joint without limits that turns many times
  // causes one warning.
  bool accepts(const double* channels, const Place& place, Diagnostics& diagnostics);

 private:
  const Mechanism& mechanism_;
  std::vector<std::string> names_;  // names of the channels
  std::vector<double> largest_;     // largest plausible magnitudes
  std::vector<bool> limited_;
};

}  // namespace flatdyn
