// SPDX-License-Identifier: GPL-2.0-or-later
// Positions that a joint cannot have tell that a log's unit is another one: degrees, millimetres.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "identify/log_layout.hpp"

namespace flatdyn {

class PositionCheck {
 public:
  PositionCheck(const Mechanism& mechanism, const LogHeading& heading);

  // A position of this sample is outside what its joint is expected to do. Cheap: asked of every sample.
  bool is_odd(const double* channels) const {
    for (std::size_t i = 0; i < largest_.size(); ++i) {
      if (std::abs(channels[static_cast<std::size_t>(LogLayout::q()) + i]) > largest_[i]) return true;
    }
    return false;
  }
  // False after an error: far outside the limits. A joint without limits that turns many times is a warning, once.
  bool accepts(const double* channels, const Place& place, Diagnostics& diagnostics);

 private:
  const Mechanism& mechanism_;
  std::vector<std::string> names_;  // of the channels
  std::vector<double> largest_;     // magnitudes
  std::vector<bool> limited_;
};

}  // namespace flatdyn
