// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/time_optimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "laboratory/trajectory/pace_interval.hpp"

namespace flatdyn {
namespace {

constexpr double kFastest = 1e12;  // largest x: a million times the given pace means that nothing limits it

bool rests(const TrajectoryPoint& point) {
  return std::all_of(point.qd.begin(), point.qd.end(), [](double rate) { return rate == 0; });
}

class PaceMaker {
 public:
  PaceMaker(const Trajectory& trajectory, const PathCoefficients& path, const PaceLimits& limits, double c)
      : points_(trajectory.points), path_(path), limits_(limits), c_(c) {}

  TimeLaw law() {
    const std::vector<double> linear(points_.size(), 1 / (c_ * c_));
    TimeLaw best = law_of(linear);
    if (best.time.empty()) {  // it is the only law, but rounding hides it
      best = {linear, std::vector<double>(points_.size(), 0), {}};
      set_times(best);
      return best;
    }
    const bool friction = std::any_of(path_.b.begin(), path_.b.end(), [](double b) { return b != 0; });
    constexpr int kMostRounds = 40;
    constexpr double kConverged = 1e-9;
    for (int round = 2; friction && round <= kMostRounds; ++round) {
      TimeLaw law = law_of(best.x);
      if (law.time.empty() || law.time.back() >= best.time.back() * (1 - kConverged)) break;
      best = std::move(law);
      best.rounds = round;
    }
    return best;
  }

 private:
  double delta(std::size_t k) const { return points_[k + 1].time - points_[k].time; }

  // The law with friction linearised about x̂ = about[k]; its times are empty if there is no such law.
  TimeLaw law_of(const std::vector<double>& about) {
    TimeLaw law;
    law.x.resize(points_.size());
    law.u.resize(points_.size());
    for (std::size_t begin = 0; begin + 1 < points_.size();) {
      std::size_t end = begin + 1;
      while (end + 1 < points_.size() && !rests(points_[end])) ++end;
      const bool waits = end == begin + 1 && rests(points_[begin]) && rests(points_[end]);
      if (waits) {
        law.x[begin] = std::max(1.0, 1 / (c_ * c_));
      } else if (!add_section(begin, end, about, law)) {
        return {};
      }
      begin = end;
    }
    set_times(law);
    return law;
  }

  // Adds the section from one rest to the next, or from an end of the trajectory; the pace at either end of it is free.
  bool add_section(std::size_t begin, std::size_t end, const std::vector<double>& about, TimeLaw& law) {
    std::vector<Interval> controllable(end - begin + 1);
    if (end + 1 == points_.size()) {
      rows_.clear();
      add_rows(end, about[end], 0, false);
      const std::optional<Interval> last = rows_.reachable(delta(end - 1), {0, kFastest});
      if (!last) return false;
      controllable.back() = *last;
    }
    for (std::size_t k = end; k-- > begin;) {
      collect(k, about);
      const std::optional<Interval> here = rows_.reachable(delta(k), controllable[k + 1 - begin]);
      if (!here) return false;
      controllable[k - begin] = *here;
    }
    double x = controllable.front().greatest;
    for (std::size_t k = begin; k < end; ++k) {
      const Interval& next = controllable[k + 1 - begin];
      collect(k, about);
      law.x[k] = x;
      law.u[k] = rows_.largest_u(x, delta(k), next);
      x = std::clamp(x + 2 * delta(k) * law.u[k], next.least, next.greatest);
    }
    law.x[end] = x;
    if (end + 1 < points_.size()) return true;
    rows_.clear();
    add_rows(end, about[end], 0, false);
    law.u[end] = rows_.nearest_u(x, law.u[end - 1]);
    return true;
  }

  // Collects the limits at point k and, with the same u, at the next point with the q'' before it; without the latter,
  // u oscillates where the torques hardly depend on it. Where a motion starts between two points, x at the first one
  // has no meaning by itself; it is limited to what the second one allows.
  void collect(std::size_t k, const std::vector<double>& about) {
    rows_.clear();
    add_rows(k, about[k], 0, false);
    if (rests(points_[k])) add_rows(k + 1, about[k + 1], 0, true);
    add_rows(k + 1, about[k + 1], 2 * delta(k), false);
  }

  // Adds rows α u + β (x + ahead u) ≤ γ of point k; if it rests, without those in u alone.
  void add_rows(std::size_t k, double about, double ahead, bool resting) {
    const auto add = [&](double alpha, double beta, double gamma) {
      rows_.add((resting ? 0 : alpha) + ahead * beta, beta, gamma);
    };
    add(0, 1, kFastest);
    const TrajectoryPoint& point = points_[k];
    const std::vector<double>& qdd = ahead > 0 && !point.qdd_before.empty() ? point.qdd_before : point.qdd;
    const std::vector<double>& a = ahead > 0 ? path_.a_before : path_.a;
    for (std::size_t i = 0; i < path_.joints; ++i) {
      const double rate = point.qd[i], speed = limits_.speed[i] / std::abs(rate);
      if (std::isfinite(speed)) add(0, 1, speed * speed);
      const double acceleration = limits_.acceleration[i];
      if (std::isfinite(acceleration)) {
        add(rate, qdd[i], acceleration);
        add(-rate, -qdd[i], acceleration);
      }
      if (std::isfinite(limits_.torque[i])) {
        const std::size_t at = k * path_.joints + i;
        add_torque(at, a[at], limits_.torque[i], about, add);
      }
    }
  }

  // Adds |m u + a x + b √x + d| ≤ L. On the side of the limit towards which friction acts, the tangent at x̂ bounds √x
  // from above. On the other side, √x is bounded from below by the chord from 0 for x ≤ x̂ and by √x̂ beyond, so by the
  // lower of the two everywhere.
  template <class Add>
  void add_torque(std::size_t k, double a, double L, double about, const Add& add) const {
    const double m = path_.m[k], b = path_.b[k], d = path_.d[k];
    const double root = std::sqrt(about);
    for (const double side : {1.0, -1.0}) {
      const double friction = side * b, room = L - side * d;
      if (friction == 0 || about == 0) {
        add(side * m, side * a, room);
      } else if (friction > 0) {
        add(side * m, side * a + friction / (2 * root), room - friction * root / 2);
      } else {
        add(side * m, side * a + friction / root, room);
        add(side * m, side * a, room - friction * root);
      }
    }
  }

  void set_times(TimeLaw& law) const {
    law.time = {points_.front().time};
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
      const double next_x = law.x[k] + 2 * delta(k) * law.u[k];
      const double pace = std::sqrt(law.x[k]) + std::sqrt(std::max(next_x, 0.0));
      law.time.push_back(law.time.back() + 2 * delta(k) / pace);
    }
    if (std::isfinite(law.time.back()) && *std::max_element(law.x.begin(), law.x.end()) < kFastest) return;
    throw Failure(FailureKind::unsupported, "nothing limits the pace of the motion",
                  "give limits of speed, acceleration or torque for every joint that moves");
  }

  const std::vector<TrajectoryPoint>& points_;
  const PathCoefficients& path_;
  const PaceLimits& limits_;
  double c_;
  PaceRows rows_;
};

// q̇ = q' √x, q̈ = q' u + q'' x, and before the point q̈ = q' u_before + q''_before x.
// The pace at one side of a point.
struct Pace {
  double x = 0, u = 0;
};

TrajectoryPoint at_pace(TrajectoryPoint point, double time, const Pace& pace, const std::optional<Pace>& before) {
  if (point.qdd_before.empty()) point.qdd_before = point.qdd;
  point.time = time;
  for (std::size_t i = 0; i < point.q.size(); ++i) {
    point.qdd[i] = point.qd[i] * pace.u + point.qdd[i] * pace.x;
    if (before) point.qdd_before[i] = point.qd[i] * before->u + point.qdd_before[i] * before->x;
    point.qd[i] *= std::sqrt(pace.x);
  }
  if (!before) point.qdd_before.clear();
  return point;
}

}  // namespace

TimeLaw time_optimal_law(const Trajectory& trajectory, const PathCoefficients& path, const PaceLimits& limits,
                         double c) {
  if (std::all_of(trajectory.points.begin(), trajectory.points.end(), rests)) {
    throw Failure(FailureKind::unsupported, "no joint moves along the trajectory: there is no pace to choose",
                  "leave out --time-optimal");
  }
  return PaceMaker(trajectory, path, limits, c).law();
}

Trajectory paced(const Trajectory& trajectory, const TimeLaw& law) {
  Trajectory result;
  for (std::size_t k = 0; k < law.x.size(); ++k) {
    const TrajectoryPoint& point = trajectory.points[k];
    std::optional<Pace> before;
    if (k > 0) {
      // At rest, x belongs to the motion that follows; the motion before has its own.
      const double way = point.time - trajectory.points[k - 1].time;
      const double x = rests(point) ? std::max(law.x[k - 1] + 2 * way * law.u[k - 1], 0.0) : law.x[k];
      before = Pace{x, law.u[k - 1]};
    }
    if (k + 1 == law.x.size() && rests(point)) before.reset();  // nothing follows
    result.points.push_back(at_pace(point, law.time[k], {law.x[k], law.u[k]}, before));
  }
  return result;
}

Trajectory paced_between(const Trajectory& twice_as_fine, const TimeLaw& law) {
  Trajectory between;
  for (std::size_t k = 0; 2 * k + 1 < twice_as_fine.points.size() && k + 1 < law.x.size(); ++k) {
    const TrajectoryPoint& point = twice_as_fine.points[2 * k + 1];
    const double way = point.time - twice_as_fine.points[2 * k].time;
    const double x = std::max(law.x[k] + 2 * way * law.u[k], 0.0);
    const double time = law.time[k] + 2 * way / (std::sqrt(law.x[k]) + std::sqrt(x));
    between.points.push_back(at_pace(point, time, {x, law.u[k]}, std::nullopt));
  }
  return between;
}

Trajectory every_second(const Trajectory& trajectory) {
  Trajectory result;
  for (std::size_t k = 0; k < trajectory.points.size(); k += 2) result.points.push_back(trajectory.points[k]);
  return result;
}

}  // namespace flatdyn
