// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/linear_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// An open interval that must not contain u.
struct Forbidden {
  double least = 0, greatest = kInfinite;
  LargestLimitUse by;
};

// Forbids the u > 0 at which a u² + b u + c > 0.
void forbid_positive(double a, double b, double c, const LargestLimitUse& by, std::vector<Forbidden>& all) {
  const auto add = [&](double least, double greatest) {
    if (greatest > std::max(least, 0.0)) all.push_back({std::max(least, 0.0), greatest, by});
  };
  if (a == 0) {
    if (b == 0 && c > 0) add(0, kInfinite);
    if (b > 0) add(-c / b, kInfinite);
    if (b < 0) add(0, -c / b);
    return;
  }
  const double square = b * b - 4 * a * c;
  if (square <= 0) {
    if (a > 0 && square < 0) add(0, kInfinite);
    return;
  }
  const double sum = -(b + std::copysign(std::sqrt(square), b)) / 2;  // no cancellation
  const double first = sum / a, second = sum == 0 ? 0 : c / sum;
  const auto [lower, upper] = std::minmax(first, second);
  if (a < 0) {
    add(lower, upper);
  } else {
    add(0, lower);
    add(upper, kInfinite);
  }
}

std::vector<Forbidden> forbidden(const Trajectory& trajectory, const PathCoefficients& path, const PaceLimits& limits) {
  std::vector<Forbidden> all;
  for (std::size_t p = 0; p < trajectory.points.size(); ++p) {
    for (std::size_t i = 0; i < path.joints; ++i) {
      const std::size_t k = p * path.joints + i;
      const double L = limits.torque[i];
      if (std::isfinite(L)) {
        const LargestLimitUse torque{1, LimitKind::torque, i, p};
        forbid_positive(path.a[k], path.b[k], path.d[k] - L, torque, all);
        forbid_positive(-path.a[k], -path.b[k], -path.d[k] - L, torque, all);
      }
      const TrajectoryPoint& point = trajectory.points[p];
      const double speed = limits.speed[i] / std::abs(point.qd[i]);
      const double acceleration = std::sqrt(limits.acceleration[i] / std::abs(point.qdd[i]));
      if (std::isfinite(speed)) all.push_back({speed, kInfinite, {1, LimitKind::speed, i, p}});
      if (std::isfinite(acceleration)) all.push_back({acceleration, kInfinite, {1, LimitKind::acceleration, i, p}});
    }
  }
  return all;
}

}  // namespace

std::optional<LinearScaling> linear_scaling(const Trajectory& trajectory, const PathCoefficients& path,
                                            const PaceLimits& limits, double least_c) {
  std::vector<Forbidden> intervals = forbidden(trajectory, path, limits);
  std::stable_sort(intervals.begin(), intervals.end(),
                   [](const Forbidden& a, const Forbidden& b) { return a.greatest > b.greatest; });
  LinearScaling result;
  double u = 1 / least_c;
  for (const Forbidden& interval : intervals) {
    if (interval.greatest <= u) break;  // all that follow end below u, too
    if (interval.least >= u) continue;
    u = interval.least;
    result.decided_by = interval.by;
  }
  if (u <= 0) return std::nullopt;
  result.c = 1 / u;
  return result;
}

LargestLimitUse largest_static_load(const PathCoefficients& path, const PaceLimits& limits) {
  LargestLimitUse most;
  for (std::size_t k = 0; k < path.d.size(); ++k) {
    const std::size_t joint = k % path.joints;
    const double part = std::abs(path.d[k]) / limits.torque[joint];
    if (part > most.part) most = {part, LimitKind::torque, joint, k / path.joints};
  }
  return most;
}

Trajectory slowed(Trajectory trajectory, double c) {
  const double begin = trajectory.points.front().time;
  for (TrajectoryPoint& point : trajectory.points) {
    point.time = begin + c * (point.time - begin);
    for (double& rate : point.qd) rate /= c;
    for (double& acceleration : point.qdd) acceleration /= c * c;
    for (double& acceleration : point.qdd_before) acceleration /= c * c;
  }
  return trajectory;
}

}  // namespace flatdyn
