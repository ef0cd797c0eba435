// SPDX-License-Identifier: GPL-2.0-or-later
// Text of a robot file → the mechanism that it is read as, compared with the one that it was written from.
#pragma once

#include <string>

#include "functions/load/loaded_robot.hpp"

namespace flatdyn {

struct RoundTrip {
  bool is_exact = true;
  std::string where;   // the first number that differs: "joint \"elbow\", inertia"
  double largest = 0;  // the largest difference of torques at random states, over the largest torque, in 50 digits
};

// Reads `text` as the file `path`, with the usual options. Throws Failure(unsupported) if it cannot be read, or is read
// as a mechanism with other joints.
RoundTrip round_trip(const std::string& text, const std::string& path, const LoadedRobot& model);

}  // namespace flatdyn
