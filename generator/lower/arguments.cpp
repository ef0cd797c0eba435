// SPDX-License-Identifier: GPL-2.0-or-later
#include "lower/arguments.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace flatdyn {

JointCounts counts_of(const Scope& scope) {
  JointCounts counts(scope.joints);
  counts.positions = scope.positions;
  counts.floating_base = scope.floating_base;
  counts.spherical = scope.spherical;
  return counts;
}

InputArgument input_argument(InputKind kind, JointCounts counts, int base_parameters) {
  const int joints = counts.joints;
  constexpr int kWrench = 6;
  switch (kind) {
    case InputKind::q:
      return {"q", counts.positions,
              std::string("joint positions, rad or m") +
                  (counts.spherical ? "; of a spherical joint a unit quaternion w, x, y, z" : "")};
    case InputKind::qd:
      return {"qd", joints, "joint velocities, rad/s or m/s"};
    case InputKind::qdd:
      return {"qdd", joints, "joint accelerations, rad/s^2 or m/s^2"};
    case InputKind::tau:
      return {"tau", joints,
              std::string(counts.floating_base ? "force and moment on the base (base axes, N, N m), then joint torques"
                                               : "joint torques or forces, N m or N") +
                  (counts.spherical ? "; of a spherical joint the moment in the child's axes" : "")};
    case InputKind::h_e:
      return {"h_e", kWrench, "force (N), then moment (N m), that the tip exerts on its environment, base frame"};
    case InputKind::g_b:
      return {"g_b", 3, "gravity in base axes, m/s^2: R^T g_0 with R from base axes to world axes"};
    case InputKind::v:
      return {"v", joints,
              std::string(counts.floating_base
                              ? "velocity of the base (linear, then angular; base axes), then of the joints"
                              : "joint velocities, rad/s or m/s") +
                  (counts.spherical ? "; of a spherical joint the angular velocity in the child's axes" : "")};
    case InputKind::a:
      return {"a", joints, "derivatives of the entries of v"};
    case InputKind::v_r:
      return {"v_r", joints, "reference velocities, with entries as those of v"};
    case InputKind::a_r:
      return {"a_r", joints, "derivatives of the entries of v_r"};
    case InputKind::qd_r:
      return {"qd_r", joints, "reference velocities, rad/s or m/s"};
    case InputKind::qdd_r:
      return {"qdd_r", joints, "reference accelerations, rad/s^2 or m/s^2"};
    case InputKind::pi_b:
      return {"pi_b", base_parameters, "base parameters, SI units; which they are is said above"};
    case InputKind::parameter:
    case InputKind::stored:
      break;
  }
  throw std::logic_error("parameters and stored values are no array arguments");
}

InputArgument input_argument(InputKind kind, JointCounts counts, const Function& function) {
  InputArgument argument = input_argument(kind, counts, function.base_parameters);
  const std::size_t colon = function.name.find(':');
  if (colon == std::string::npos) return argument;
  const std::string tip = "the tip";
  if (const std::size_t at = argument.meaning.find(tip); at != std::string::npos) {
    argument.meaning.replace(at, tip.size(), fmt::format("link \"{}\"", function.name.substr(colon + 1)));
  }
  return argument;
}

std::string variable_of_input(const Input& input, const std::vector<std::string>& parameters) {
  if (input.kind == InputKind::parameter) return parameters.at(static_cast<std::size_t>(input.index));
  return fmt::format("{}_{}", input_argument(input.kind, 0).name, input.index + 1);
}

bool returns_value(const Function& function) {
  return function.validity_conditions.empty() && function.outputs.size() == 1 &&
         function.outputs[0].layout == Layout::scalar;
}

}  // namespace flatdyn
