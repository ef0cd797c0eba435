// SPDX-License-Identifier: GPL-2.0-or-later
// Detects wrong units of what tells a floating base's motion, and an accelerometer that gravity was taken off.
#pragma once

#include "identify/log_layout.hpp"

namespace flatdyn {

class BaseCheck {
 public:
  // gravity: the size of g_0, m/s².
  BaseCheck(const LogHeading& heading, double gravity) : heading_(heading), gravity_(gravity) {}

  void add(const double* channels);
  // Warnings, once for each kind.
  void finish(const Place& place, Diagnostics& diagnostics) const;

 private:
  const LogHeading& heading_;
  double gravity_;
  double sum_of_forces_ = 0;  // of the sizes of what the accelerometer shows, m/s²
  double fastest_ = 0;        // rad/s
  long samples_ = 0;
};

}  // namespace flatdyn
