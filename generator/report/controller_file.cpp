// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/controller_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/diagnostics/version.hpp"
#include "report/numbers.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

constexpr std::array<ControllerRow, 3> kControllers = {{{Controller::ur, "ur", ".script", 6, 500},
                                                        {Controller::franka, "franka", "_1kHz.csv", 7, 1000},
                                                        {Controller::ros, "ros", "_trajectory.json", {}, {}}}};

PlannedState state_at(const MotionEquations& equations, const PlannedMotion& motion, std::size_t sample) {
  const FourierMotion& at = motion.samples[sample];
  return equations.state(at.q.data(), at.qd.data(), at.qdd.data());
}

std::string positions_text(const Eigen::VectorXd& q) {
  std::vector<std::string> texts;
  for (const double each : q) texts.push_back(fmt::format("{:.9f}", each));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string ur_script(const MotionEquations& equations, const PlannedMotion& motion) {
  const double step = motion.time(1);
  std::string text = fmt::format(
      "# An excitation of {} by flatdyn {}: {:.6g} s, a point every {:.6g} s, from rest to rest.\n"
      "# Clear the room around the arm, and log t, q and torques or currents while it runs.\n"
      "def excitation():\n  movej([{}], a=0.5, v=0.3)  # to where the motion begins\n  sleep(1.0)\n",
      cpp_identifier(equations.model().mechanism().name), kProgramVersion, motion.trajectory.duration(), step,
      positions_text(state_at(equations, motion, 0).q));
  for (std::size_t k = 1; k < motion.samples.size(); ++k) {
    text +=
        fmt::format("  servoj([{}], 0, 0, {:.6g}, 0.1, 300)\n", positions_text(state_at(equations, motion, k).q), step);
  }
  return text + "  stopj(1.0)\nend\nexcitation()\n";
}

std::string franka_csv(const MotionEquations& equations, const PlannedMotion& motion) {
  std::string text;
  for (std::size_t k = 0; k < motion.samples.size(); ++k)
    text += positions_text(state_at(equations, motion, k).q) + "\n";
  return text;
}

nlohmann::ordered_json ros_trajectory(const MotionEquations& equations, const PlannedMotion& motion) {
  constexpr double kNanoseconds = 1e9;
  nlohmann::ordered_json json;
  json["joint_names"] = nlohmann::ordered_json::array();
  for (const Body& body : equations.model().mechanism().bodies) json["joint_names"].push_back(body.joint);
  for (std::size_t k = 0; k < motion.samples.size(); ++k) {
    const PlannedState state = state_at(equations, motion, k);
    const auto time = std::llround(motion.time(k) * kNanoseconds), second = static_cast<long long>(kNanoseconds);
    json["points"].push_back({{"positions", list(state.q)},
                              {"velocities", list(state.v)},
                              {"accelerations", list(state.a)},
                              {"time_from_start", {{"sec", time / second}, {"nanosec", time % second}}}});
  }
  return json;
}

}  // namespace

std::vector<std::string> controller_names() {
  std::vector<std::string> names;
  for (const ControllerRow& each : kControllers) names.emplace_back(each.name);
  return names;
}

const ControllerRow& controller_row(const std::string& name) {
  return *std::find_if(kControllers.begin(), kControllers.end(),
                       [&](const ControllerRow& each) { return each.name == name; });
}

std::string controller_text(const ControllerRow& row, const MotionEquations& equations, const PlannedMotion& motion) {
  switch (row.controller) {
    case Controller::ur:
      return ur_script(equations, motion);
    case Controller::franka:
      return franka_csv(equations, motion);
    case Controller::ros:
      return ros_trajectory(equations, motion).dump() + "\n";
  }
  return {};
}

}  // namespace flatdyn
