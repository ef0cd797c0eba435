// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/structured_derivatives.hpp"

#include <algorithm>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/differentiation/derivative_outputs.hpp"
#include "derivation/differentiation/differentiate.hpp"
#include "derivation/differentiation/held.hpp"
#include "derivation/differentiation/implicit.hpp"
#include "graph/fusion.hpp"

namespace flatdyn {
namespace {

constexpr int kAxes = 3;

// The columns along the directions of an argument, from those of a matrix of derivatives that start with number `from`.
void take_columns(const Output& matrix, int from, const TangentBlock& block, JacobianColumns& columns) {
  if (matrix.cols < from + block.length) throw Failure(FailureKind::bug, matrix.name + " has the wrong shape");
  for (int k = 0; k < block.length; ++k) {
    std::vector<NodeId>& column = columns[static_cast<std::size_t>(block.first + k)];
    for (int i = 0; i < matrix.rows; ++i) {
      column.push_back(matrix.entries[static_cast<std::size_t>(i * matrix.cols + from + k)]);
    }
  }
}

// g_b acts as an acceleration of the base the other way: τ depends on v̇ - g_b, of which τ = B a + … holds v̇ among the
// first entries of a. So ∂τ/∂g_b is minus the first columns of B; and while τ is held, ∂v̇/∂g_b is the unit matrix.
void take_columns_of_gravity(bool is_of_acceleration, const Tangents& tangents, Graph& graph,
                             JacobianColumns& columns) {
  const TangentBlock* block = tangents.find(InputKind::g_b);
  if (block == nullptr) return;
  const TangentBlock* acceleration = tangents.find(InputKind::a);
  const std::size_t rows = columns.front().size();
  for (int k = 0; k < kAxes; ++k) {
    std::vector<NodeId>& column = columns[static_cast<std::size_t>(block->first + k)];
    for (std::size_t i = 0; i < rows; ++i) {
      column.push_back(is_of_acceleration
                           ? graph.constant(i == static_cast<std::size_t>(k) ? 1 : 0)
                           : graph.scaled(-1, columns[static_cast<std::size_t>(acceleration->first + k)][i]));
    }
  }
}

// A vector, as far as its derivatives need to know of it.
Output shape_of(const std::string& name, int rows) {
  return {.name = name, .rows = rows, .entries = std::vector<NodeId>(static_cast<std::size_t>(rows)), .meaning = ""};
}

template <class Property>
bool base_has(const Mechanism& mechanism, Property property) {
  for (int k = 0; k < mechanism.base_bodies(); ++k) {
    if (property(mechanism.body(k))) return true;
  }
  return false;
}

// Whether gravity acts on a floating base as an acceleration does. It does not act on armature.
bool gravity_is_acceleration(const Mechanism& mechanism) {
  return !mechanism.has_base_gravity() || !base_has(mechanism, [](const Body& body) { return body.armature != 0; });
}

// Functions as one, which requires of each loop once, at the end, that it is not singular.
Function whole_of(const std::vector<Function>& parts) {
  const Fusion fusion = fused(parts);
  std::vector<Function> separate;
  for (std::size_t k = 0; k < parts.size(); ++k) separate.push_back(function_of(fusion, k));
  Function whole = fusion.function;
  Conditions conditions;
  for (const Function& part : separate) {
    Conditions own{part.validity_conditions, part.pivot_scales};
    const std::size_t pivots = part.validity_conditions.size() - static_cast<std::size_t>(part.loop_conditions);
    own.validity_conditions.resize(pivots);
    own.pivot_scales.resize(std::min(pivots, own.pivot_scales.size()));
    conditions.append(own);
  }
  whole.validity_conditions = std::move(conditions.validity_conditions);
  whole.pivot_scales = std::move(conditions.pivot_scales);
  whole.loop_conditions = 0;
  for (const Function& part : separate) {
    for (std::size_t k = part.validity_conditions.size() - static_cast<std::size_t>(part.loop_conditions);
         k < part.validity_conditions.size(); ++k) {
      require_loop(whole, part.validity_conditions[k], part.pivot_scales[k]);
    }
  }
  return whole;
}

}  // namespace

bool has_jacobian_parts(const Mechanism& mechanism, const FunctionRow& row) {
  return !row.jacobian_parts.empty() && mechanism.symbols.empty() && gravity_is_acceleration(mechanism);
}

std::optional<Function> jacobian_of_parts(const Mechanism& mechanism, const FunctionRow& row, FormulationIndex way,
                                          const Choices& choices) {
  std::vector<Function> parts;
  for (const JacobianPart& part : row.jacobian_parts) {
    std::optional<Function> made = formulation(mechanism, part.function, parts.empty() ? way : 0, choices);
    if (!made) return std::nullopt;
    parts.push_back(std::move(*made));
  }
  Function whole = whole_of(parts);
  whole.formulation = parts.front().formulation;
  whole.proven_pivot_share = parts.front().proven_pivot_share;
  whole.inputs = row.inputs_for(mechanism);
  const Tangents tangents(mechanism, whole.inputs, 0);
  JacobianColumns columns(static_cast<std::size_t>(tangents.count()));
  std::size_t output = 0;
  for (const JacobianPart& part : row.jacobian_parts) {
    for (const InputKind argument : part.arguments) {
      const TangentBlock* block = tangents.find(with_base(argument, mechanism.has_quasi_velocities()));
      if (block == nullptr) throw Failure(FailureKind::bug, std::string(part.function) + " has other arguments");
      take_columns(whole.outputs[output++], 0, *block, columns);
    }
  }
  const bool is_of_acceleration = row.outputs.front().quantity == OutputQuantity::joint_acceleration;
  take_columns_of_gravity(is_of_acceleration, tangents, whole.graph, columns);
  const std::string result = in_coordinates(row.outputs.front().name, mechanism);
  whole.outputs = jacobian_outputs({shape_of(result, mechanism.size())}, tangents, columns);
  return whole;
}

bool has_state_derivatives(const Mechanism& mechanism, const FunctionRow& row) {
  return row.state_derivatives != nullptr && mechanism.symbols.empty() && !mechanism.has_quasi_velocities();
}

std::optional<Function> jacobian_of_step(const Mechanism& mechanism, const FunctionRow& row, FormulationIndex way,
                                         const Choices& choices) {
  std::optional<Function> state = formulation(mechanism, row.state_derivatives, way, choices);
  const std::optional<Function> step = formulation(mechanism, row.name, 0, choices);
  if (!state || !step) return std::nullopt;
  const Function by_length = jacobian_matrices(*step, Tangents(mechanism, {InputKind::h}, 0));
  const Fusion both = fused({*state, by_length});
  Function whole = function_of(both, 0);
  const Output A = whole.outputs.at(0), B = whole.outputs.at(1);
  whole.inputs = row.inputs_for(mechanism);
  const Tangents tangents(mechanism, whole.inputs, 0);
  JacobianColumns columns(static_cast<std::size_t>(tangents.count()));
  take_columns(A, 0, *tangents.find(InputKind::q), columns);
  take_columns(A, mechanism.size(), *tangents.find(InputKind::qd), columns);
  take_columns(B, 0, *tangents.find(InputKind::tau), columns);
  for (const Output& part : function_of(both, 1).outputs) take_columns(part, 0, *tangents.find(InputKind::h), columns);
  whole.outputs = jacobian_outputs(step->outputs, tangents, columns);
  return whole;
}

bool is_implicit(const Mechanism& mechanism, const FunctionRow& row, Derivative derivative) {
  const bool is_weighted =
      derivative == Derivative::vector_times_jacobian || derivative == Derivative::contracted_hessian;
  return is_weighted && row.implicit.torques != nullptr && mechanism.symbols.empty() &&
         gravity_is_acceleration(mechanism);
}

std::optional<Function> implicit_derivative(const Mechanism& mechanism, const FunctionRow& row, Derivative derivative,
                                            FormulationIndex way, const Choices& choices) {
  const bool is_second = derivative == Derivative::contracted_hessian;
  const auto& ways = row.implicit.solution_and_derivatives;
  const bool has_several = is_second && !mechanism.has_loops();
  if (way >= (has_several ? ways.size() : 1)) return std::nullopt;
  Function solution = (is_second ? ways[way] : row.implicit.solution)(mechanism, choices);
  Function inverse_dynamics = *formulation(mechanism, row.implicit.torques, 0, choices);
  const std::vector<InputKind> arguments = row.inputs_for(mechanism), of_torques = inverse_dynamics.inputs;
  solution.inputs = arguments;
  solution.inputs.push_back(InputKind::weights);
  const std::string acceleration = in_coordinates(row.outputs.front().name, mechanism);
  solution.own = {mechanism.size(), "weights of the entries of " + acceleration};
  solution.outputs.front().name = acceleration;
  solution.formulation = "multipliers B^-1 w";
  solution.proven_pivot_share = choices.guard.proven_share;
  const Tangents tangents(mechanism, arguments, 0);
  const Differentiable torques(mechanism, std::move(inverse_dynamics), of_torques, choices);
  const ImplicitAcceleration implicit{solution, torques, tangents};
  return is_second ? weighted_second_derivatives(implicit) : weighted_derivatives(implicit);
}

bool is_held(const Mechanism& mechanism, const FunctionRow& row) {
  return row.held_motion != nullptr && mechanism.symbols.empty() && !mechanism.has_loops() &&
         !base_has(mechanism, [](const Body& body) { return body.armature != 0 || body.viscous != 0; });
}

Function held_jacobian(const Mechanism& mechanism, const FunctionRow& row, const Choices& choices) {
  const Function solution = row.held_motion(mechanism, choices),
                 torques = *formulation(mechanism, "inverse_dynamics_derivatives", 0, choices);
  Function contacts = fused({*formulation(mechanism, "contact_jacobian", 0, choices),
                             *formulation(mechanism, "contact_bias", 0, choices)})
                          .function;
  contacts.outputs.erase(contacts.outputs.begin());  // the contacts' positions
  const std::vector<InputKind> arguments = row.inputs_for(mechanism);
  const Tangents tangents(mechanism, arguments, 0);
  auto [function, columns] = held_derivatives(mechanism, {solution, torques, contacts, tangents});
  function.inputs = arguments;
  function.proven_pivot_share = choices.guard.proven_share;
  std::vector<Output> shapes;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string name = in_coordinates(row.outputs[k].name, mechanism);
    shapes.push_back(shape_of(name, solution.outputs[k].rows));
  }
  function.outputs = jacobian_outputs(shapes, tangents, columns);
  return function;
}

}  // namespace flatdyn
