// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/regressor_functions.hpp"

#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/kernel/joint_angles.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "derivation/parameters/regressor.hpp"

namespace flatdyn {
namespace {

constexpr const char* kColumnMeaning = "column k is the torque for base parameter k = 1, the others 0";

Rows regressor_at_coordinates(DerivationContext& context, const JointMotion& motion, const std::vector<int>& columns) {
  return rows_at_coordinates(context.mechanism, context.derivation, regressor(context.frames, motion, columns), "y");
}

Function regressor_of(const Mechanism& mechanism, const std::vector<int>& columns, const std::string& name,
                      const std::string& meaning) {
  DerivationContext context(mechanism);
  const std::vector<Number> qd = context.joint_motion(InputKind::qd);
  const JointMotion motion{qd, qd, context.joint_motion(InputKind::qdd), gravity_of(mechanism, context.derivation)};
  const std::vector<NodeId> entries = context.nodes(regressor_at_coordinates(context, motion, columns));
  return finished(context, {matrix_output(name, context.size(), static_cast<int>(columns.size()), entries, meaning)});
}

}  // namespace

Function derive_regressor(const Mechanism& mechanism) {
  const char* const joints = "m, m l (3), I_xx, xy, xz, yy, yz, zz, I_m, F_v, F_s of every joint";
  const char* const bodies =
      "the first ten of the base, then m, m l (3), I_xx, xy, xz, yy, yz, zz, I_m, F_v, F_s of "
      "every joint";
  return regressor_of(mechanism, parameter_indices(mechanism), "Y", mechanism.floating_base ? bodies : joints);
}

Function derive_base_regressor(const Mechanism& mechanism) {
  return regressor_of(mechanism, base_parameters(mechanism).columns, "Y_b", kColumnMeaning);
}

Function derive_base_parameters(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  const std::vector<Number> values = base_values(mechanism, base_parameters(mechanism));
  return finished(context, {vector_output("pi_b", context.nodes(values), "base parameters, SI units")});
}

Function derive_inverse_dynamics_base(const Mechanism& mechanism) {
  Derivation derivation(DerivationContext::parameters(mechanism));
  const BaseParameters base = base_parameters(mechanism);
  const Mechanism run_time = with_base_parameters(mechanism, base, inputs(derivation, InputKind::pi_b, base.size()));
  Frames frames(run_time, derivation);
  const Motion motion{joint_motion(mechanism, derivation, InputKind::qd),
                      joint_motion(mechanism, derivation, InputKind::qdd), gravity_of(mechanism, derivation), true};
  std::vector<NodeId> tau;
  for (const Number& torque : at_coordinates(mechanism, derivation, torques(frames, motion), "tau")) {
    tau.push_back(derivation.node(torque));
  }
  Function function = finished(mechanism, derivation, {torque_output("tau", tau)});
  function.base_parameters = base.size();
  return function;
}

Function derive_adaptive_regressor(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  const JointMotion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qd_r),
                           context.joint_motion(InputKind::qdd_r), gravity_of(mechanism, context.derivation)};
  const std::vector<int> columns = base_parameters(mechanism).columns;
  const std::vector<NodeId> entries = context.nodes(regressor_at_coordinates(context, motion, columns));
  return finished(context,
                  {matrix_output("Y_b", context.size(), static_cast<int>(columns.size()), entries, kColumnMeaning)});
}

Function derive_spring_regressor(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  Rows Y(static_cast<std::size_t>(mechanism.body_count()));
  for (const int j : mechanism.bodies_on_one_axis()) {
    const Number stiffness_column = joint_position(mechanism, context.derivation, j);
    for (int i = 0; i < mechanism.body_count(); ++i) {
      std::vector<Number>& row = Y[static_cast<std::size_t>(i)];
      row.push_back(i == j ? stiffness_column : Number(0));
      row.push_back(i == j ? -1 : 0);
    }
  }
  const int columns = static_cast<int>(Y.front().size());
  const std::vector<NodeId> entries = context.nodes(rows_at_coordinates(mechanism, context.derivation, Y, "y"));
  return finished(context,
                  {matrix_output("Y_s", context.size(), columns, entries, "k, k q_0 of every joint's spring")});
}

}  // namespace flatdyn
