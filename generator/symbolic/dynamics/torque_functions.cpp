// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/torque_functions.hpp"

#include "symbolic/dynamics/accelerations.hpp"
#include "symbolic/dynamics/energy.hpp"
#include "symbolic/dynamics/kinematics.hpp"

namespace flatdyn {

Function derive_inverse_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), context.gravity(),
                        true};
    const std::vector<Number> tau = torques(context.frames, motion);
    return finished(context, {torque_output("tau", context.nodes(context.at_coordinates(tau)))});
  });
}

Function derive_inverse_dynamics_tip_force(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, at_the_tip(choices, mechanism.tip), [](DerivationContext& context) {
    const std::vector<Number> h = inputs(context.derivation, InputKind::h_e, 6);
    const Wrench tip = wrench_on_body(context.frames, context.mechanism.tip, {{h[0], h[1], h[2]}, {h[3], h[4], h[5]}});
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), context.gravity(),
                        true};
    const std::vector<Number> tau = torques(context.frames, motion, tip);
    return finished(context, {torque_output("tau", context.nodes(context.at_coordinates(tau)))});
  });
}

Function derive_gravity(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    return finished(context,
                    {torque_output("g", context.nodes(context.at_coordinates(gravity_torques(context.frames))))});
  });
}

Function derive_bias(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    return finished(context, {torque_output("n", context.nodes(bias_torques(context)))});
  });
}

}  // namespace flatdyn
