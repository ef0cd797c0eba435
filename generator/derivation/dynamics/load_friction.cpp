// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/load_friction.hpp"

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/dry_friction.hpp"

namespace flatdyn {
namespace {

// One entry of the argument tau, and how much of it its drive loses.
struct Load {
  Number torque, size;  // the given torque, and its absolute value
  Number share;         // c s
  std::string label;
  bool is_bounded = true;  // whether c is a number, which is less than 1
};

std::vector<Load> loads(DerivationContext& context) {
  const Mechanism& mechanism = context.mechanism;
  if (mechanism.is_coupled()) {
    throw Failure(FailureKind::unsupported, "load_friction is not supported for robots with coupled joints or loops",
                  "leave it out, or let the joints move by themselves");
  }
  Derivation& d = context.derivation;
  const std::vector<Number> tau = context.all(InputKind::tau), qd = context.all(InputKind::qd);
  std::vector<Load> result;
  for (std::size_t k = 0; k < tau.size(); ++k) {
    const Body& body = mechanism.body(static_cast<int>(k));
    Load load{tau[k], 0, 0, context.frames.label(static_cast<int>(k)), is_rational(body.dry.load)};
    if (!vanishes(body.dry.load)) {
      load.size = d.named(tau[k] * d.sign(tau[k], "sgn_tau_" + load.label), "abs_tau_" + load.label);
      load.share = d.named(body.dry.load * sliding_sign(d, body, qd[k], load.label), "c_" + load.label);
    }
    result.push_back(std::move(load));
  }
  return result;
}

}  // namespace

Function derive_drive_torque(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    std::vector<Number> torques;
    for (const Load& load : loads(context)) torques.push_back(load.torque + load.share * load.size);
    return finished(context, {vector_output("tau_d", context.nodes(torques), "torques of the drives, N m or N")});
  });
}

Function derive_torque_from_drive(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    Derivation& d = context.derivation;
    std::vector<Number> torques;
    Conditions conditions;
    for (const Load& load : loads(context)) {
      torques.push_back(load.torque);
      if (vanishes(load.share)) continue;
      const Number left = d.named(1 - load.share * load.share, "left_" + load.label);
      torques.back() = d.quotient(load.torque - load.share * load.size, left, "tau_" + load.label);
      if (!load.is_bounded) conditions.append({{context.node(left)}, {}});
    }
    Function function = finished(
        context, {vector_output("tau_j", context.nodes(torques), "torques that the joints get, N m or N")}, conditions);
    if (!conditions.validity_conditions.empty()) function.inverted = "1 - c^2 s^2";
    return function;
  });
}

}  // namespace flatdyn
