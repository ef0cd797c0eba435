// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/conventions/coverage.hpp"

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/function_table.hpp"

namespace flatdyn {
namespace {

bool is_known(InputKind kind) {
  const ArgumentRow& row = argument_row(kind);
  const bool is_array =
      row.length != ArgumentLength::symbols && row.length != ArgumentLength::none && row.length != ArgumentLength::own;
  return is_array && !row.is_reference && row.quantity != ArgumentQuantity::base_parameter &&
         row.with_quasi_velocities == kind;
}

bool is_known(OutputQuantity quantity) {
  switch (quantity) {
    case OutputQuantity::number:
    case OutputQuantity::position:
    case OutputQuantity::joint_rate:
    case OutputQuantity::joint_acceleration:
    case OutputQuantity::joint_torque:
    case OutputQuantity::joint_inertia:
    case OutputQuantity::energy:
    case OutputQuantity::torque_per_rate:
    case OutputQuantity::tip_jacobian:
    case OutputQuantity::tip_acceleration:
    case OutputQuantity::momentum_per_rate:
    case OutputQuantity::force_and_moment:
    case OutputQuantity::contact_jacobian:
    case OutputQuantity::contact_acceleration:
    case OutputQuantity::contact_force:
    case OutputQuantity::contact_impulse:
      return true;
    default:
      return false;
  }
}

// Derivatives of torques and accelerations hold the numbers in v, a and τ, which are the same in plain conventions.
bool is_derivative(const Output& output) {
  switch (output.quantity) {
    case OutputQuantity::torque_per_position:
    case OutputQuantity::acceleration_per_position:
    case OutputQuantity::acceleration_per_rate:
    case OutputQuantity::acceleration_per_torque:
      return true;
    default:
      return false;
  }
}

bool has_derivatives(const Function& function) {
  return std::any_of(function.outputs.begin(), function.outputs.end(), is_derivative);
}

// Whether an argument or a result has linear and angular parts, as those of the tip and of its task.
bool has_two_parts(InputKind kind) { return argument_row(kind).quantity == ArgumentQuantity::wrench; }
bool has_two_parts(const Output& output) {
  switch (output.quantity) {
    case OutputQuantity::tip_jacobian:
    case OutputQuantity::tip_acceleration:
    case OutputQuantity::task_inertia:
    case OutputQuantity::task_force:
    case OutputQuantity::joint_rate_per_task:
      return true;
    default:
      return false;
  }
}
bool has_two_parts(const Function& function) {
  const auto has_parts = [](const auto& each) { return has_two_parts(each); };
  return std::any_of(function.inputs.begin(), function.inputs.end(), has_parts) ||
         std::any_of(function.outputs.begin(), function.outputs.end(), has_parts);
}

bool returns_positions(const Function& function) {
  return std::any_of(function.outputs.begin(), function.outputs.end(),
                     [](const Output& output) { return output.quantity == OutputQuantity::joint_position; });
}

bool takes(const Function& function, InputKind kind) {
  return std::find(function.inputs.begin(), function.inputs.end(), kind) != function.inputs.end();
}

}  // namespace

void check_conventions_apply(const Mechanism& mechanism) {
  if (!mechanism.has_quasi_velocities()) {
    throw Failure(FailureKind::unsupported, "--convention: the robot has neither a floating base nor spherical joints",
                  "leave it out, or use --base floating");
  }
}

bool is_of_inertia(const Function& function) {
  return function.outputs.size() == 1 && function.outputs[0].quantity == OutputQuantity::joint_inertia;
}

bool is_coriolis(const Function& function) {
  return function.outputs.size() == 1 && function.outputs[0].quantity == OutputQuantity::torque_per_rate;
}

bool depends_on_acceleration(const Output& output) {
  switch (output.quantity) {
    case OutputQuantity::joint_acceleration:
    case OutputQuantity::joint_torque:
    case OutputQuantity::tip_acceleration:
    case OutputQuantity::force_and_moment:
    case OutputQuantity::contact_acceleration:
      return true;
    default:
      return false;
  }
}

FrictionOfOrigin friction_of_origin(const Mechanism& mechanism, const Convention& convention) {
  if (!mechanism.floating_base) return {};
  const Body& turning = mechanism.base_link();
  return {convention.linear_in_world ? turning.viscous : Number(0), turning.coulomb};
}

bool is_rubbed(const Function& function, const Mechanism& mechanism, const Convention& convention) {
  const auto is_dynamic = [](const Output& output) {
    return output.quantity == OutputQuantity::joint_torque || output.quantity == OutputQuantity::joint_acceleration;
  };
  return takes(function, InputKind::v) && std::any_of(function.outputs.begin(), function.outputs.end(), is_dynamic) &&
         !friction_of_origin(mechanism, convention).is_zero();
}

bool has_other_quaternions(const Convention& convention, const Mechanism& mechanism) {
  return !convention.scalar_first && mechanism.has_spherical_joints();
}

std::string why_not(const Function& adapted, const std::vector<Function>& all, const Convention& convention,
                    const Mechanism& mechanism) {
  if (find_row(adapted.name) == nullptr) return "it is a fused function";
  if (!is_whole(adapted)) return "the scene leaves out some of its entries";
  if (!mechanism.floating_base) {
    if (has_other_quaternions(convention, mechanism) && returns_positions(adapted)) {
      return "its quaternions are flatdyn's own";
    }
    if (!convention.angular_first || !has_two_parts(adapted)) return "";
    return "with a fixed base, velocities and forces of the tip keep flatdyn's order";
  }
  if (find_row(adapted.name)->traits.needs_loops) return "it is about the joints alone: take flatdyn's own";
  const bool knows_all =
      std::all_of(adapted.inputs.begin(), adapted.inputs.end(), [](InputKind kind) { return is_known(kind); }) &&
      std::all_of(adapted.outputs.begin(), adapted.outputs.end(),
                  [](const Output& output) { return is_known(output.quantity) || is_derivative(output); });
  if (!knows_all) return "its results are flatdyn's own";
  if (has_derivatives(adapted) && !convention.is_plain()) {
    return "derivatives hold the numbers in v, which are others here: take pinocchio or pose";
  }
  if (has_derivatives(adapted) && !friction_of_origin(mechanism, convention).is_zero()) {
    return "the base's friction along the axes of the world has a part in it";
  }
  if (find_row(adapted.name)->traits.depends_on_gravity_only && adapted.outputs[0].quantity == OutputQuantity::energy) {
    return "it is about the base's origin: add -m g_0^T p to flatdyn's own";
  }
  const bool adds_friction = takes(adapted, InputKind::tau) || adapted.outputs.size() == 1;
  if (is_rubbed(adapted, mechanism, convention) && !adds_friction) {
    return "the base's friction along the axes of the world has a part in it";
  }
  if (is_coriolis(adapted) && convention.linear_in_world && std::none_of(all.begin(), all.end(), is_of_inertia)) {
    return "in axes of the world it needs inertia_matrix, too";
  }
  return "";
}

}  // namespace flatdyn
