// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/pace_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

double number_or_infinite(const std::optional<Value>& limit) {
  return limit ? nearest_double(limit->number) : std::numeric_limits<double>::infinity();
}

}  // namespace

bool PaceLimits::are_infinite() const {
  const auto all_infinite = [](const std::vector<double>& limits) {
    return std::all_of(limits.begin(), limits.end(), [](double limit) { return std::isinf(limit); });
  };
  return all_infinite(speed) && all_infinite(acceleration) && all_infinite(torque);
}

PaceLimits given_limits(const Mechanism& mechanism) {
  PaceLimits limits;
  for (const Body& body : mechanism.joints()) {
    limits.speed.push_back(number_or_infinite(body.limits.velocity));
    limits.acceleration.push_back(number_or_infinite(body.limits.acceleration));
    limits.torque.push_back(number_or_infinite(body.limits.effort));
  }
  return limits;
}

LargestLimitUse largest_limit_use(const Trajectory& trajectory, const std::vector<std::vector<double>>& tau,
                                  const PaceLimits& limits) {
  LargestLimitUse most;
  for (std::size_t p = 0; p < trajectory.points.size(); ++p) {
    const TrajectoryPoint& point = trajectory.points[p];
    for (std::size_t i = 0; i < point.q.size(); ++i) {
      const LargestLimitUse uses[] = {{std::abs(tau[p][i]) / limits.torque[i], LimitKind::torque, i, p},
                                      {std::abs(point.qd[i]) / limits.speed[i], LimitKind::speed, i, p},
                                      {std::abs(point.qdd[i]) / limits.acceleration[i], LimitKind::acceleration, i, p}};
      for (const LargestLimitUse& use : uses) {
        if (use.part > most.part) most = use;
      }
    }
  }
  return most;
}

}  // namespace flatdyn
