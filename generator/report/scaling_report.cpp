// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/scaling_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

const char* name_of_limit(LimitKind kind) {
  switch (kind) {
    case LimitKind::speed:
      return "speed";
    case LimitKind::acceleration:
      return "acceleration";
    case LimitKind::torque:
      return "torque";
  }
  return "";
}

double limit_of(const PaceLimits& limits, LimitKind kind, std::size_t joint) {
  const std::vector<double>* const by_kind[] = {&limits.speed, &limits.acceleration, &limits.torque};
  return (*by_kind[static_cast<std::size_t>(kind)])[joint];
}

std::string unit_of_limit(const Body& body, LimitKind kind) {
  if (kind == LimitKind::torque) return torque_unit(body);
  return std::string(body.prismatic ? "m" : "rad") + (kind == LimitKind::speed ? "/s" : "/s^2");
}

double largest_torque(const std::vector<std::vector<double>>& tau, std::size_t joint) {
  double largest = 0;
  for (const std::vector<double>& at_point : tau) largest = std::max(largest, std::abs(at_point[joint]));
  return largest;
}

std::string torque_table_text(const Mechanism& mechanism, const ScaledMotion& motion) {
  std::vector<std::vector<std::string>> rows = {{"joint", "unit", "torque limit", "before", "after"}};
  for (std::size_t i = 0; i < mechanism.joints().size(); ++i) {
    const double limit = motion.limits.torque[i];
    rows.push_back({mechanism.joints()[i].joint, unit_of_limit(mechanism.joints()[i], LimitKind::torque),
                    std::isfinite(limit) ? fmt::format("{:.6g}", limit) : "none",
                    fmt::format("{:.6g}", largest_torque(motion.tau_sides_before, i)),
                    fmt::format("{:.6g}", largest_torque(motion.tau_sides_after, i))});
  }
  return aligned_table(rows);
}

std::string decision_text(const Mechanism& mechanism, const ScaledMotion& motion) {
  const std::optional<LargestLimitUse>& by = motion.linear.decided_by;
  if (!by) return "the motion keeps all limits as it is\n";
  const double time = motion.sides_before.points[by->point].time;
  return fmt::format("decided by the {}, at {:.6g} s of the motion as given, {:.6g} s of the scaled one\n",
                     limit_text(mechanism, motion.limits, by->kind, by->joint), time,
                     motion.linear.c * (motion.even ? motion.even->slowed_by : 1) * time);
}

std::string sampling_text(const ScaledMotion& motion) {
  return fmt::format("{} samples at {} Hz, for which all of it takes {:.9g} times as long\n",
                     motion.after.points.size(), motion.even->rate, motion.even->slowed_by);
}

std::string optimal_text(const OptimalPace& pace, const LinearScaling& linear) {
  std::string text =
      fmt::format("time-optimal over {} points; the best linear law takes {:.6g} times the given duration\n",
                  pace.law.x.size(), linear.c);
  if (pace.between) text += fmt::format("between the points up to {:.6g} of a limit are used\n", pace.between->part);
  if (pace.law.rounds > 1) text += fmt::format("friction linearised {} times\n", pace.law.rounds);
  return text +
         fmt::format("dynamics evaluated in {:.3g} ms, law found in {:.3g} ms\n", pace.coefficients_ms, pace.solve_ms);
}

nlohmann::ordered_json use_json(const Mechanism& mechanism, const LargestLimitUse& used, const Trajectory& trajectory) {
  return {{"joint", mechanism.joints()[used.joint].joint},
          {"limit", name_of_limit(used.kind)},
          {"part", used.part},
          {"at", trajectory.points[used.point].time}};
}

}  // namespace

std::string limit_text(const Mechanism& mechanism, const PaceLimits& limits, LimitKind kind, std::size_t joint) {
  const Body& body = mechanism.joints()[joint];
  return fmt::format("{} limit {:.6g} {} of joint \"{}\"", name_of_limit(kind), limit_of(limits, kind, joint),
                     unit_of_limit(body, kind), body.joint);
}

std::string describe_scaling(const Mechanism& mechanism, const ScaledMotion& motion) {
  std::string text;
  if (motion.optimal) {
    text = fmt::format("{:.6g} s instead of {:.6g} s\n", motion.after.duration(), motion.before.duration()) +
           optimal_text(*motion.optimal, motion.linear);
  } else {
    text = fmt::format("c = {:.6g}: {:.6g} s instead of {:.6g} s\n", motion.linear.c, motion.after.duration(),
                       motion.before.duration()) +
           decision_text(mechanism, motion);
  }
  if (motion.even) text += sampling_text(motion);
  text += fmt::format("largest use of a limit: {:.9g} of the {}\n\n", motion.used.part,
                      limit_text(mechanism, motion.limits, motion.used.kind, motion.used.joint));
  return text + torque_table_text(mechanism, motion);
}

nlohmann::ordered_json scaling_json(const Mechanism& mechanism, const ScaledMotion& motion) {
  nlohmann::ordered_json json = {{"robot", mechanism.name},
                                 {"law", motion.optimal ? "time-optimal" : "linear"},
                                 {"c", motion.linear.c},
                                 {"duration_before", motion.before.duration()},
                                 {"duration", motion.after.duration()},
                                 {"points", motion.after.points.size()}};
  if (motion.even) json["even_samples"] = {{"rate", motion.even->rate}, {"slowed_by", motion.even->slowed_by}};
  if (motion.linear.decided_by) {
    json["decided_by"] = use_json(mechanism, *motion.linear.decided_by, motion.sides_before);
    json["decided_by"].erase("part");
  }
  json["largest_use"] = use_json(mechanism, motion.used, motion.sides_after);
  if (motion.optimal) {
    json["rounds"] = motion.optimal->law.rounds;
    if (motion.optimal->between) json["largest_use_between"] = motion.optimal->between->part;
    json["slowed_by"] = motion.optimal->slowed_by;
    json["coefficients_ms"] = motion.optimal->coefficients_ms;
    json["solve_ms"] = motion.optimal->solve_ms;
  }
  for (std::size_t i = 0; i < mechanism.joints().size(); ++i) {
    nlohmann::ordered_json joint = {{"joint", mechanism.joints()[i].joint}};
    if (std::isfinite(motion.limits.torque[i])) joint["torque_limit"] = motion.limits.torque[i];
    joint["torque_before"] = largest_torque(motion.tau_sides_before, i);
    joint["torque"] = largest_torque(motion.tau_sides_after, i);
    json["joints"].push_back(joint);
  }
  return json;
}

}  // namespace flatdyn
