// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/step_rows.hpp"

#include <algorithm>
#include <string>

#include "derivation/dynamics/step_derivative_functions.hpp"
#include "derivation/dynamics/step_functions.hpp"
#include "truth/definition/step_definitions.hpp"
#include "truth/reference/step_references.hpp"

namespace flatdyn {
namespace {

const std::vector<InputKind> kArguments = {InputKind::q, InputKind::qd, InputKind::tau, InputKind::h};

// The state after the step.
const std::vector<OutputRow> kNextState = {
    {"q_next", Layout::vector, Extent::joints, Extent::one, OutputQuantity::joint_position},
    {"qd_next", Layout::vector, Extent::joints, Extent::one, OutputQuantity::joint_rate}};

// A and B.
const std::vector<OutputRow> kStateDerivatives = {
    {"A", Layout::matrix, Extent::states, Extent::states, OutputQuantity::derivative},
    {"B", Layout::matrix, Extent::states, Extent::joints, OutputQuantity::derivative}};

std::vector<FunctionRow> step_rows() {
  return {
      {.name = "step:semi_implicit_euler",
       .summary = "A step of length h with constant torques: qd_next = qd + h qdd(q, qd, tau), q_next = q + h qd_next",
       .equation = "",
       .inputs = kArguments,
       .outputs = kNextState,
       .derivation = {.from_choices = derive_semi_implicit_step,
                      .alternatives = {{"articulated bodies", derive_semi_implicit_step_by_articulated_bodies},
                                       {"B = L^T D L of composite bodies",
                                        derive_semi_implicit_step_by_composite_bodies}},
                      .formulation = "B = L^T D L"},
       .definition = definitions::semi_implicit_step,
       .reference = references::semi_implicit_step,
       .traits = {.on_request = true,
                  .divides_by_pivots = true,
                  .needs_rates = true,
                  .leaves_rest = true,
                  .refuses_loops = true}},
      {.name = "step_derivatives:semi_implicit_euler",
       .summary =
           "The derivatives A and B of step:semi_implicit_euler by the state (q, qd) and by tau; Coulomb friction "
           "counts as constant",
       .equation = "",
       .inputs = kArguments,
       .outputs = kStateDerivatives,
       .derivation = {.from_choices = derive_semi_implicit_step_derivatives,
                      .alternatives = {{"products with B^-1", derive_semi_implicit_step_derivatives_by_products}},
                      .formulation = "substitution into B = L^T D L"},
       .definition = definitions::semi_implicit_step_derivatives,
       .reference = references::semi_implicit_step_derivatives,
       .traits = {.on_request = true,
                  .divides_by_pivots = true,
                  .is_all_or_nothing = true,
                  .needs_rates = true,
                  .leaves_rest = true,
                  .refuses_loops = true}},
      {.name = "step:rk4",
       .summary = "A step of length h with constant torques by the classical Runge-Kutta method of fourth order",
       .equation = "",
       .inputs = kArguments,
       .outputs = kNextState,
       .derivation = {.from_choices = derive_runge_kutta_step,
                      .alternatives = {{"articulated bodies", derive_runge_kutta_step_by_articulated_bodies},
                                       {"B = L^T D L of composite bodies",
                                        derive_runge_kutta_step_by_composite_bodies}},
                      .formulation = "B = L^T D L"},
       .definition = definitions::runge_kutta_step,
       .reference = references::runge_kutta_step,
       .traits = {.on_request = true,
                  .divides_by_pivots = true,
                  .needs_rates = true,
                  .leaves_rest = true,
                  .refuses_loops = true}},
      {.name = "step_derivatives:rk4",
       .summary = "The derivatives A and B of step:rk4 by the state (q, qd) and by tau; Coulomb friction counts as "
                  "constant",
       .equation = "",
       .inputs = kArguments,
       .outputs = kStateDerivatives,
       .derivation = {.from_choices = derive_runge_kutta_step_derivatives},
       .definition = definitions::runge_kutta_step_derivatives,
       .reference = references::runge_kutta_step_derivatives,
       .traits = {.on_request = true,
                  .divides_by_pivots = true,
                  .is_all_or_nothing = true,
                  .needs_rates = true,
                  .leaves_rest = true,
                  .refuses_loops = true}},
      {.name = "step:implicit_midpoint",
       .summary = "One Newton iteration from qd_end for a step of length h with constant torques by the implicit "
                  "midpoint rule",
       .equation = "",
       .inputs = {InputKind::q, InputKind::qd, InputKind::tau, InputKind::h, InputKind::qd_end},
       .outputs = {kNextState[0],
                   kNextState[1],
                   {"residual", Layout::vector, Extent::joints, Extent::one, OutputQuantity::joint_torque}},
       .derivation = {.from_choices = derive_midpoint_step},
       .definition = definitions::midpoint_step,
       .reference = references::midpoint_step,
       .traits =
           {.on_request = true, .needs_rates = true, .leaves_rest = true, .refuses_loops = true, .has_gaps = true}},
      {.name = "step_derivatives:implicit_midpoint",
       .summary = "The derivatives A and B of a step of length h by the implicit midpoint rule, by the state (q, qd) "
                  "and by tau, where qd_end solves its equations; Coulomb friction counts as constant",
       .equation = "",
       .inputs = {InputKind::q, InputKind::qd, InputKind::h, InputKind::qd_end},
       .outputs = kStateDerivatives,
       .derivation = {.from_choices = derive_midpoint_step_derivatives},
       .definition = definitions::midpoint_step_derivatives,
       .reference = references::midpoint_step_derivatives,
       .traits = {.on_request = true,
                  .is_all_or_nothing = true,
                  .needs_rates = true,
                  .leaves_rest = true,
                  .refuses_loops = true,
                  .has_gaps = true}},
  };
}

}  // namespace

std::vector<FunctionRow> with_steps(std::vector<FunctionRow> rows) {
  const auto place = std::find_if(rows.begin(), rows.end(), [](const FunctionRow& row) {
    return std::string(row.name) == "forward_dynamics_derivatives";
  });
  const std::vector<FunctionRow> steps = step_rows();
  rows.insert(place + 1, steps.begin(), steps.end());
  return rows;
}

}  // namespace flatdyn
