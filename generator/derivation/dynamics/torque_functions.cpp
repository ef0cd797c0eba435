// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/torque_functions.hpp"

#include "derivation/dynamics/accelerations.hpp"
#include "derivation/dynamics/energy.hpp"
#include "derivation/dynamics/kinematics.hpp"

namespace flatdyn {
namespace {

// The mechanism without all that has a torque of its own.
Mechanism without_own_torques(Mechanism mechanism) {
  for (Body& body : mechanism.bodies) {
    body.inertia = {};
    body.rotor.reset();
    body.armature = body.stiffness = 0;
    body.leave_out_friction();
  }
  return mechanism;
}

// The input h_e at the frame's origin, in base axes, as a wrench on the frame's body.
Wrench exerted_wrench(DerivationContext& context, const LinkFrame& link) {
  const std::vector<Number> h = inputs(context.derivation, InputKind::h_e, 6);
  return wrench_on_body(context.frames, link, {{h[0], h[1], h[2]}, {h[3], h[4], h[5]}});
}

}  // namespace

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
    const Wrench tip = exerted_wrench(context, context.mechanism.tip);
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), context.gravity(),
                        true};
    const std::vector<Number> tau = torques(context.frames, motion, tip);
    return finished(context, {torque_output("tau", context.nodes(context.at_coordinates(tau)))});
  });
}

Function derive_external_torque(const Mechanism& mechanism, const LinkFrame& link) {
  Mechanism bare = without_own_torques(mechanism);
  bare.tip = link;
  return derived(bare, at_the_tip(uniform_choices(bare, Grouping::i_yy), link), [](DerivationContext& context) {
    const std::vector<Number> zeros(static_cast<std::size_t>(context.mechanism.body_count()), 0);
    const Wrench tip = exerted_wrench(context, context.mechanism.tip);
    const std::vector<Number> tau = torques(context.frames, {zeros, zeros, zero_vector(), false}, tip);
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
