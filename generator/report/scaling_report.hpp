// SPDX-License-Identifier: GPL-2.0-or-later
// A motion at another pace, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "trajectory/time_optimal.hpp"

namespace flatdyn {

// What of a time-optimal law is told beside its motion.
struct OptimalPace {
  TimeLaw law;
  std::optional<LimitUsed> between;          // largest use between the grid's points, where it can be asked
  double slowed_by = 1;                      // all of it, so that the limits hold where the law alone exceeds them
  double coefficients_ms = 0, solve_ms = 0;  // how long it took to evaluate the dynamics, and then to find the law
};

struct ScaledMotion {
  PaceLimits limits;
  LinearScaling linear;
  std::optional<OptimalPace> optimal;
  Trajectory before, after;
  std::vector<std::vector<double>> tau_after;
  // Both sides of every jump, of the motion as given (whose points `linear` counts) and at its new pace.
  Trajectory sides_before, sides_after;
  std::vector<std::vector<double>> tau_sides_before, tau_sides_after;
  LimitUsed used;  // of sides_after, from a sweep of its own
};

std::string describe_scaling(const Mechanism& mechanism, const ScaledMotion& motion);
nlohmann::ordered_json scaling_json(const Mechanism& mechanism, const ScaledMotion& motion);

// "torque limit 3000 N m of joint \"elbow\"".
std::string limit_text(const Mechanism& mechanism, const PaceLimits& limits, LimitKind kind, std::size_t joint);

}  // namespace flatdyn
