// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/resampling.hpp"

#include <algorithm>

#include "laboratory/trajectory/interpolation.hpp"

namespace flatdyn {
namespace {

std::vector<double> tip_force(const Trajectory& trajectory, double time) {
  const std::vector<TrajectoryPoint>& points = trajectory.points;
  const auto next = std::upper_bound(points.begin() + 1, points.end() - 1, time,
                                     [](double t, const TrajectoryPoint& point) { return t < point.time; });
  const TrajectoryPoint &a = *(next - 1), &b = *next;
  const double s = (time - a.time) / (b.time - a.time);
  std::vector<double> force = a.h_e;
  for (std::size_t i = 0; i < force.size(); ++i) force[i] += s * (b.h_e[i] - a.h_e[i]);
  return force;
}

TrajectoryPoint one_sided(TrajectoryPoint point) {
  point.qdd_before.clear();
  return point;
}

}  // namespace

Trajectory resampled(const Trajectory& trajectory, int intervals) {
  Trajectory even;
  even.points.push_back(one_sided(trajectory.points.front()));
  for (int k = 1; k < intervals; ++k) {
    const double time = trajectory.points.front().time + trajectory.duration() * k / intervals;
    even.points.push_back(interpolated(trajectory, time));
    if (trajectory.has_tip_force()) even.points.back().h_e = tip_force(trajectory, time);
  }
  even.points.push_back(one_sided(trajectory.points.back()));
  return even;
}

}  // namespace flatdyn
