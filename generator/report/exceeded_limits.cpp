// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "report/torque_report.hpp"

namespace flatdyn {
namespace {

constexpr double kReachedLimit = 1e-9;  // relative: a limit that is reached is not exceeded

// The largest excess of one quantity of one joint over its limit during the trajectory; negative if it keeps the limit.
struct Excess {
  double value = 0, time = 0, beyond = 0;
};

using ValueAt = std::function<double(std::size_t)>;

Excess worst_excess(const Trajectory& trajectory, const ValueAt& value, double lower, double upper) {
  Excess result;
  for (std::size_t p = 0; p < trajectory.points.size(); ++p) {
    const double x = value(p), beyond = std::max(x - upper - kReachedLimit * std::abs(upper),
                                                 lower - kReachedLimit * std::abs(lower) - x);
    if (beyond > result.beyond) result = {x, trajectory.points[p].time, beyond};
  }
  return result;
}

class LimitCheck {
 public:
  LimitCheck(const Trajectory& trajectory, const std::string& file, Diagnostics& found)
      : trajectory_(trajectory), file_(file), found_(found) {}

  void operator()(const Body& body, const char* what, const std::string& unit, const std::optional<Value>& lower,
                  const std::optional<Value>& upper, const ValueAt& value) {
    const double least = lower ? nearest_double(lower->number) : -HUGE_VAL;
    const double greatest = upper ? nearest_double(upper->number) : HUGE_VAL;
    report(body, what, unit, least, greatest, worst_excess(trajectory_, value, least, greatest));
  }

  // Compares values of both signs with the limit.
  void operator()(const Body& body, const char* what, const std::string& unit, const std::optional<Value>& most,
                  const ValueAt& value) {
    if (!most) return;
    const double limit = nearest_double(most->number);
    report(body, what, unit, -limit, limit, worst_excess(trajectory_, value, -limit, limit));
  }

 private:
  void report(const Body& body, const char* what, const std::string& unit, double least, double greatest,
              const Excess& excess) {
    if (excess.beyond <= 0) return;
    found_.warning({file_, 0},
                   fmt::format("joint \"{}\": {} {:.6g} {} at {:.6g} s, beyond its limit {:.6g} {}", body.joint, what,
                               excess.value, unit, excess.time, excess.value > 0 ? greatest : least, unit),
                   "the limit is the robot file's, or the scene's");
  }

  const Trajectory& trajectory_;
  const std::string& file_;
  Diagnostics& found_;
};

}  // namespace

Diagnostics exceeded_limits(const Mechanism& mechanism, const Trajectory& trajectory,
                            const std::vector<std::vector<double>>& tau, const std::string& file) {
  Diagnostics found;
  LimitCheck check(trajectory, file, found);
  for (std::size_t i = 0; i < mechanism.joints().size(); ++i) {
    const Body& body = mechanism.joints()[i];
    const std::string unit = body.prismatic ? "m" : "rad";
    const auto& points = trajectory.points;
    check(body, "position", unit, body.limits.lower, body.limits.upper, [&](std::size_t p) { return points[p].q[i]; });
    check(body, "rate", unit + "/s", body.limits.velocity, [&](std::size_t p) { return points[p].qd[i]; });
    check(body, "acceleration", unit + "/s^2", body.limits.acceleration,
          [&](std::size_t p) { return points[p].qdd[i]; });
    check(body, "torque", torque_unit(body), body.limits.effort, [&](std::size_t p) { return tau[p][i]; });
  }
  return found;
}

}  // namespace flatdyn
