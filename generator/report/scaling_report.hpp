// SPDX-License-Identifier: GPL-2.0-or-later
// A motion at another pace, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/trajectory/time_optimal.hpp"

namespace flatdyn {

// Facts on a time-optimal law, in addition to its motion.
struct OptimalPace {
  TimeLaw law;
  std::optional<LargestLimitUse> between;  // largest use between the grid's points, if it can be computed
  double slowed_by = 1;  // factor on the whole motion that restores limits which the law alone exceeds
  double coefficients_ms = 0, solve_ms = 0;  // time to evaluate the dynamics, and to find the law
};

// Even samples of the scaled motion.
struct EvenSamples {
  double rate = 0;       // samples per second
  double slowed_by = 1;  // factor on the whole motion, with which it ends on a sample and keeps limits at all of them
};

struct ScaledMotion {
  PaceLimits limits;
  LinearScaling linear;
  std::optional<OptimalPace> optimal;
  std::optional<EvenSamples> even;
  Trajectory before, after;
  std::vector<std::vector<double>> tau_after;
  // The points at both sides of every jump, of the motion as given (`linear` counts these) and at its new pace, there
  // with even samples if there are some.
  Trajectory sides_before, sides_after;
  std::vector<std::vector<double>> tau_sides_before, tau_sides_after;
  LargestLimitUse used;  // use of limits by sides_after, computed separately
};

std::string describe_scaling(const Mechanism& mechanism, const ScaledMotion& motion);
nlohmann::ordered_json scaling_json(const Mechanism& mechanism, const ScaledMotion& motion);

// A limit as text: "torque limit 3000 N m of joint \"elbow\"".
std::string limit_text(const Mechanism& mechanism, const PaceLimits& limits, LimitKind kind, std::size_t joint);

}  // namespace flatdyn
