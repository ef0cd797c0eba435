// SPDX-License-Identifier: GPL-2.0-or-later
// One point of a field at which a function is compared with its definition: the Lagrangian there, the values drawn for
// the arguments, and the function's own values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "definition/joint_signs.hpp"
#include "definition/lagrangian.hpp"
#include "diagnostics/diagnostics.hpp"
#include "graph/function.hpp"
#include "model/joint_points.hpp"

namespace flatdyn {

template <class Arithmetic>
class DefinitionPoint {
 public:
  using F = typename Arithmetic::Scalar;
  using Values = std::vector<F>;

  // `own_values`: the values of the function's nodes, from evaluate() with the same arithmetic. All arguments must
  // outlive this object.
  DefinitionPoint(const Mechanism& mechanism_in, const Function& function_in, Arithmetic& arithmetic_in,
                  const Values& own_values)
      : mechanism(mechanism_in),
        function(function_in),
        arithmetic(arithmetic_in),
        q(joint_points(mechanism, arithmetic)),
        lagrangian(mechanism_over(mechanism, arithmetic), q),
        own_values_(own_values) {}

  // The function's own values of an output.
  Values own(const Output& output) const {
    Values result;
    for (const NodeId entry : output.entries) result.push_back(own_values_[static_cast<std::size_t>(entry)]);
    return result;
  }

  // The values drawn for an argument: for every coordinate, or for `count` entries.
  Values drawn(InputKind kind) const { return drawn(kind, mechanism.size()); }
  Values drawn(InputKind kind, int count) const {
    Values result;
    for (int i = 0; i < count; ++i) result.push_back(arithmetic.input({kind, i}));
    return result;
  }
  Values qd() const { return drawn(InputKind::qd); }
  Values qdd() const { return drawn(InputKind::qdd); }
  Values signs() const { return joint_signs(mechanism, arithmetic, InputKind::qd); }

  // The frame that the function is about: the tip's, or that of the link in its name.
  const FieldFrame<F>& frame() const {
    const std::size_t colon = function.name.find(':');
    if (colon == std::string::npos) return lagrangian.mechanism().tip;
    const std::string link = function.name.substr(colon + 1);
    for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
      if (mechanism.links[k].link == link) return lagrangian.mechanism().links[k];
    }
    throw Failure(ExitCode::bug, "no link named \"" + link + "\"");
  }

  Values inverse_dynamics() { return lagrangian.inverse_dynamics(qd(), qdd(), signs()); }

  // τ - n, the value that B q̈ must have.
  Values net_torques() {
    Values result = drawn(InputKind::tau);
    const Values bias = lagrangian.bias(qd(), signs());
    for (std::size_t i = 0; i < bias.size(); ++i) result[i] += -bias[i];
    return result;
  }

  const Mechanism& mechanism;
  const Function& function;
  Arithmetic& arithmetic;
  const std::vector<JointPoint<F>> q;  // by body: the position of its joint
  Lagrangian<F> lagrangian;

 private:
  const Values& own_values_;
};

}  // namespace flatdyn
