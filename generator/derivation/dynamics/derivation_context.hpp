// SPDX-License-Identifier: GPL-2.0-or-later
// The state of one derivation: what every function of the table starts from, and how it becomes a Function.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "derivation/dynamics/composite.hpp"
#include "derivation/dynamics/coordinates.hpp"
#include "derivation/dynamics/factorisation.hpp"
#include "derivation/dynamics/newton_euler.hpp"
#include "derivation/kernel/choices.hpp"

namespace flatdyn {

struct DerivationContext {
  explicit DerivationContext(const Mechanism& m, const std::vector<Axes>& axes = {})
      : mechanism(m), derivation(parameters(m)), frames(mechanism, derivation, axes) {}

  static std::vector<GiNaC::symbol> parameters(const Mechanism& mechanism);

  int size() const { return mechanism.size(); }
  // The inputs of a kind for every coordinate, and the motion of every body's joint, which follows from them.
  std::vector<Number> all(InputKind kind) {
    return inputs(derivation, with_base(kind, mechanism.has_quasi_velocities()), size());
  }
  std::vector<Number> joint_motion(InputKind kind) { return flatdyn::joint_motion(mechanism, derivation, kind); }
  // The accelerations of the joints while q̈ is zero.
  std::vector<Number> joint_drift() { return flatdyn::joint_drift(mechanism, derivation, InputKind::qd); }
  Vec3 gravity() { return gravity_of(mechanism, derivation); }
  std::vector<Number> at_coordinates(const std::vector<Number>& tau) {
    return flatdyn::at_coordinates(mechanism, derivation, tau, "tau");
  }
  Rows inertia() {
    return flatdyn::at_coordinates(mechanism, derivation, inertia_matrix(frames), Shape::symmetric, "b");
  }

  NodeId node(const Number& value) { return derivation.node(value); }
  std::vector<NodeId> nodes(const std::vector<Number>& values);
  std::vector<NodeId> nodes(const Rows& rows);  // row by row

  const Mechanism& mechanism;
  Derivation derivation;
  Frames frames;
  PivotGuard guard;  // as in Choices
};

// The values that must be positive for a result to be valid, and the scales of the first of them
// (Function::pivot_scales).
struct Conditions {
  std::vector<NodeId> validity_conditions, pivot_scales;

  // Appends conditions. If they have scales, conditions before them that have none become their own scales.
  void append(const Conditions& more);
};
// Pivots of B that are not compared with scales. Those that inputs can make infinite must be below kLargestPivot, too:
// all entries of the result may be finite after a division by infinity. (Beside a scale, which is then infinite, too,
// they count as lost.)
inline constexpr const char* kLargestPivot = "1e30";  // kg m² or kg; a float holds it
Conditions conditions_of(DerivationContext& context, const std::vector<Number>& pivots);
// The pivots of B, with their scales if the context's guard compares them.
Conditions conditions_of(DerivationContext& context, const Factorisation& B);
// The pivots of a floating base's part of B, whose diagonal these are from entry `first` of v on: of all six, or of the
// moments of inertia that are left when the translations are eliminated.
Conditions conditions_of_base(DerivationContext& context, const Factorisation& inertia,
                              const std::vector<Number>& diagonal, std::size_t first);

Output vector_output(const std::string& name, std::vector<NodeId> entries, const std::string& meaning);
Output torque_output(const std::string& name, std::vector<NodeId> entries);
Output matrix_output(const std::string& name, int rows, int cols, std::vector<NodeId> entries,
                     const std::string& meaning);
Output scalar_output(const std::string& name, NodeId entry, const std::string& meaning);

// Makes a Function and takes the graph out of the derivation. With closed loops, the loops that the outputs depend on
// must not be singular. The function's name, arguments and quantities are set from its row (functions/).
Function finished(const Mechanism& mechanism, Derivation& derivation, std::vector<Output> outputs,
                  Conditions conditions = {});
inline Function finished(DerivationContext& context, std::vector<Output> outputs, Conditions conditions = {}) {
  return finished(context.mechanism, context.derivation, std::move(outputs), std::move(conditions));
}

// Derives a function from the mechanism in these choices of frames and units.
Function derived(const Mechanism& mechanism, const Choices& choices,
                 const std::function<Function(DerivationContext&)>& derive);

// Choices with metres and with the axes of the tip's link, in which wrenches and tasks at the tip are given.
Choices at_the_tip(Choices choices, const LinkFrame& tip);

}  // namespace flatdyn
