// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/motion_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

struct Defaults {
  double position, speed, acceleration;
};
constexpr Defaults kTurning{1.5707963267948966, 2, 10};
constexpr Defaults kSliding{0.25, 0.5, 2};
constexpr Defaults kTurningBase{0.4, 1, 5}, kSlidingBase{0.1, 0.25, 1}, kBall{0.8, 2, 10};

double number_or(const std::optional<Value>& limit, double otherwise) {
  return limit ? nearest_double(limit->number) : otherwise;
}

JointLimits limits_of(const Body& body, const Defaults& defaults) {
  const Limits& given = body.limits;
  JointLimits limits{-defaults.position, defaults.position, number_or(given.velocity, defaults.speed),
                     number_or(given.acceleration, defaults.acceleration),
                     number_or(given.effort, std::numeric_limits<double>::infinity())};
  if (given.lower) limits.lower = nearest_double(given.lower->number);
  if (given.upper) limits.upper = nearest_double(given.upper->number);
  if (given.lower && !given.upper) limits.upper = limits.lower + 2 * defaults.position;
  if (given.upper && !given.lower) limits.lower = limits.upper - 2 * defaults.position;
  return limits;
}

const Defaults& defaults_of(const Mechanism& mechanism, int entry, const Body& body) {
  if (entry < mechanism.base_bodies()) return body.prismatic ? kSlidingBase : kTurningBase;
  if (body.spherical > 0) return kBall;
  return body.prismatic ? kSliding : kTurning;
}

}  // namespace

std::vector<JointLimits> motion_limits(const Mechanism& mechanism) {
  std::vector<JointLimits> limits;
  for (int i = 0; i < mechanism.size(); ++i) {
    const Body& body = mechanism.joint(i);
    limits.push_back(limits_of(body, defaults_of(mechanism, i, body)));
  }
  return limits;
}

std::vector<JointLimits> within_margin(std::vector<JointLimits> limits, double margin) {
  for (JointLimits& joint : limits) {
    const double middle = joint.middle(), reach = margin * joint.reach();
    joint = {middle - reach, middle + reach, margin * joint.speed, margin * joint.acceleration, margin * joint.torque};
  }
  return limits;
}

void update_use(LimitUse& use, const JointLimits& limits, double q, double qd, double qdd, double tau) {
  use.position = std::max(use.position, std::abs(q - limits.middle()) / limits.reach());
  use.speed = std::max(use.speed, std::abs(qd) / limits.speed);
  use.acceleration = std::max(use.acceleration, std::abs(qdd) / limits.acceleration);
  use.torque = std::max(use.torque, std::abs(tau) / limits.torque);
}

}  // namespace flatdyn
