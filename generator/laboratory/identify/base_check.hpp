// SPDX-License-Identifier: GPL-2.0-or-later
// Detects a floating base's twist that is in other units, or in the world's axes, by comparison with its pose.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "laboratory/identify/log_layout.hpp"

namespace flatdyn {

class BaseCheck {
 public:
  // dt: the usual time between samples, s.
  BaseCheck(const LogHeading& heading, double dt) : heading_(heading), dt_(dt) {}

  void add(const double* channels);
  // Tells that the next sample does not follow the last one.
  void restart() { last_.reset(); }
  // Warnings, once for each kind.
  void finish(const Place& place, Diagnostics& diagnostics) const;

 private:
  // Pose and twist of a sample.
  struct Sample {
    double time = 0;
    Eigen::Vector3d place, v, turns;
    Eigen::Quaterniond turn;
  };
  // Squares of what rates in base axes, and in world axes, leave of a change, and of what they say of it.
  struct Agreement {
    double of_base = 0, of_world = 0, all = 0;
    long count = 0;

    void add(const Eigen::Vector3d& in_base, const Eigen::Vector3d& in_world, const Eigen::Vector3d& expected);
    bool is_in_world() const;
  };

  const LogHeading& heading_;
  double dt_;
  double fastest_ = 0;  // rad/s
  std::optional<Sample> last_;
  Agreement linear_, angular_;
};

}  // namespace flatdyn
