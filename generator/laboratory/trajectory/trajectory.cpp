// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/trajectory.hpp"

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

constexpr double kLarge = 0.01, kAgainstNeighbours = 10;

double largest_acceleration(const Trajectory& trajectory, std::size_t joint) {
  double largest = 0;
  for (const TrajectoryPoint& point : trajectory.points) largest = std::max(largest, std::abs(point.qdd[joint]));
  return largest;
}

}  // namespace

void mark_jumps(Trajectory& trajectory) {
  std::vector<TrajectoryPoint>& points = trajectory.points;
  for (std::size_t i = 0; i < points.front().qdd.size(); ++i) {
    const double large = kLarge * largest_acceleration(trajectory, i);
    const auto change = [&](std::size_t k) {
      return k == 0 || k >= points.size() ? 0 : std::abs(points[k].qdd[i] - points[k - 1].qdd[i]);
    };
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const double beside = std::max(change(k - 1), change(k + 1));
      if (change(k) > large && change(k) > kAgainstNeighbours * beside) points[k].qdd_before = points[k - 1].qdd;
    }
  }
}

Trajectory with_both_sides(const Trajectory& trajectory) {
  Trajectory result;
  for (const TrajectoryPoint& point : trajectory.points) {
    TrajectoryPoint side = point;
    side.qdd_before.clear();
    if (!point.qdd_before.empty()) {
      side.qdd = point.qdd_before;
      result.points.push_back(side);
      side.qdd = point.qdd;
    }
    result.points.push_back(std::move(side));
  }
  return result;
}

}  // namespace flatdyn
