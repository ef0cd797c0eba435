// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/interpolation.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

// The motion of one joint at one time.
struct OneJoint {
  double q, qd, qdd;
};

// The motion at the fraction s of the way from a to b, which takes T seconds.
OneJoint between(const OneJoint& a, const OneJoint& b, double T, double s) {
  // q = a + v s + w s²/2 + c_3 s³ + c_4 s⁴ + c_5 s⁵, with derivatives by s.
  const double v = a.qd * T, w = a.qdd * T * T, d = b.q - a.q - v - w / 2;
  const double dv = b.qd * T - v - w, dw = b.qdd * T * T - w;
  const double c_3 = 10 * d - 4 * dv + dw / 2, c_4 = -15 * d + 7 * dv - dw, c_5 = 6 * d - 3 * dv + dw / 2;
  return {a.q + s * (v + s * (w / 2 + s * (c_3 + s * (c_4 + s * c_5)))),
          (v + s * (w + s * (3 * c_3 + s * (4 * c_4 + s * 5 * c_5)))) / T,
          (w + s * (6 * c_3 + s * (12 * c_4 + s * 20 * c_5))) / (T * T)};
}

TrajectoryPoint standing(const TrajectoryPoint& at, double time) {
  const std::vector<double> still(at.q.size(), 0);
  return {time, at.q, still, still, {}};
}

}  // namespace

TrajectoryPoint interpolated(const Trajectory& trajectory, double time) {
  const std::vector<TrajectoryPoint>& points = trajectory.points;
  if (time < points.front().time) return standing(points.front(), time);
  if (time >= points.back().time) return standing(points.back(), time);
  const auto next = std::upper_bound(points.begin(), points.end(), time,
                                     [](double t, const TrajectoryPoint& point) { return t < point.time; });
  const TrajectoryPoint &a = *(next - 1), &b = *next;
  const std::vector<double>& b_qdd = b.qdd_before.empty() ? b.qdd : b.qdd_before;
  const double T = b.time - a.time, s = (time - a.time) / T;
  TrajectoryPoint point = standing(a, time);
  for (std::size_t i = 0; i < a.q.size(); ++i) {
    const OneJoint here = between({a.q[i], a.qd[i], a.qdd[i]}, {b.q[i], b.qd[i], b_qdd[i]}, T, s);
    point.q[i] = here.q;
    point.qd[i] = here.qd;
    point.qdd[i] = here.qdd;
  }
  return point;
}

}  // namespace flatdyn
