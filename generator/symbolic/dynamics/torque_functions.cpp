// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/torque_functions.hpp"

#include "symbolic/dynamics/accelerations.hpp"
#include "symbolic/dynamics/energy.hpp"
#include "symbolic/dynamics/kinematics.hpp"

namespace flatdyn {

Function derive_inverse_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_motion(InputKind::qdd), bench.mechanism.gravity,
                        true};
    const std::vector<Number> tau = torques(bench.frames, motion);
    return finished(bench, {torque_output("tau", bench.nodes(bench.at_coordinates(tau)))});
  });
}

Function derive_inverse_dynamics_tip_force(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, at_the_tip(choices, mechanism.tip), [](Workbench& bench) {
    const std::vector<Number> h = inputs(bench.derivation, InputKind::h_e, 6);
    const Wrench tip = wrench_on_body(bench.frames, bench.mechanism.tip, {{h[0], h[1], h[2]}, {h[3], h[4], h[5]}});
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_motion(InputKind::qdd), bench.mechanism.gravity,
                        true};
    const std::vector<Number> tau = torques(bench.frames, motion, tip);
    return finished(bench, {torque_output("tau", bench.nodes(bench.at_coordinates(tau)))});
  });
}

Function derive_gravity(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    return finished(bench, {torque_output("g", bench.nodes(bench.at_coordinates(gravity_torques(bench.frames))))});
  });
}

Function derive_bias(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    return finished(bench, {torque_output("n", bench.nodes(bias_torques(bench)))});
  });
}

}  // namespace flatdyn
