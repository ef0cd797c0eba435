// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/step_rows.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "derivation/dynamics/step_derivative_functions.hpp"
#include "derivation/dynamics/step_functions.hpp"
#include "truth/definition/step_definitions.hpp"
#include "truth/reference/step_references.hpp"

namespace flatdyn {
namespace {

// A step, with the state after it, and its formulations.
FunctionRow step(const char* name, const char* summary, DerivationRow derivation, const Definition& definition,
                 const NumericReference& reference) {
  return {.name = name,
          .summary = summary,
          .equation = "",
          .inputs = {InputKind::q, InputKind::g_b, InputKind::qd, InputKind::tau, InputKind::h},
          .outputs = {{"q_next", Layout::vector, Extent::positions, Extent::one, OutputQuantity::joint_position},
                      {"qd_next", Layout::vector, Extent::joints, Extent::one, OutputQuantity::joint_rate},
                      {"displacement", Layout::vector, Extent::three, Extent::one, OutputQuantity::position, true},
                      {"turn", Layout::vector, Extent::four, Extent::one, OutputQuantity::number, true}},
          .derivation = std::move(derivation),
          .definition = definition,
          .reference = reference,
          .traits = {.on_request = true, .divides_by_pivots = true, .leaves_rest = true, .refuses_loops = true}};
}

// The derivatives A and B of a step.
FunctionRow derivatives(const char* name, const char* summary, DerivationRow derivation, const Definition& definition,
                        const NumericReference& reference) {
  FunctionRow row = step(name, summary, std::move(derivation), definition, reference);
  row.outputs = {{"A", Layout::matrix, Extent::states, Extent::states, OutputQuantity::derivative},
                 {"B", Layout::matrix, Extent::states, Extent::joints, OutputQuantity::derivative}};
  row.traits.is_all_or_nothing = true;
  return row;
}

// The same of a rule whose equations have no solution everywhere, and which takes velocities at the end of the step.
FunctionRow implicit(FunctionRow row) {
  row.inputs.push_back(InputKind::qd_end);
  row.traits.divides_by_pivots = false;
  row.traits.has_gaps = true;
  return row;
}

FunctionRow midpoint_row() {
  FunctionRow row =
      implicit(step("step:implicit_midpoint",
                    "One Newton iteration from qd_end for a step of length h with constant torques by "
                    "the implicit midpoint rule",
                    {.from_choices = derive_midpoint_step}, definitions::midpoint_step, references::midpoint_step));
  row.outputs.push_back({"residual", Layout::vector, Extent::joints, Extent::one, OutputQuantity::joint_momentum_rate});
  return row;
}

FunctionRow midpoint_derivatives_row() {
  FunctionRow row = implicit(derivatives(
      "step_derivatives:implicit_midpoint",
      "The derivatives A and B of a step of length h by the implicit midpoint rule, by the state (q, qd) and by tau, "
      "where qd_end solves its equations; Coulomb friction counts as constant",
      {.from_choices = derive_midpoint_step_derivatives}, definitions::midpoint_step_derivatives,
      references::midpoint_step_derivatives));
  std::erase(row.inputs, InputKind::tau);  // which follows from qd_end
  return row;
}

FunctionRow with_derivatives(FunctionRow row, const char* name) {
  row.state_derivatives = name;
  return row;
}

std::vector<FunctionRow> step_rows() {
  return {
      with_derivatives(
          step(
              "step:semi_implicit_euler",
              "A step of length h with constant torques: qd_next = qd + h qdd(q, qd, tau), then q_next along h qd_next",
              {.from_choices = derive_semi_implicit_step,
               .alternatives = {{"articulated bodies", derive_semi_implicit_step_by_articulated_bodies},
                                {"B = L^T D L of composite bodies", derive_semi_implicit_step_by_composite_bodies}},
               .formulation = "B = L^T D L"},
              definitions::semi_implicit_step, references::semi_implicit_step),
          "step_derivatives:semi_implicit_euler"),
      derivatives("step_derivatives:semi_implicit_euler",
                  "The derivatives A and B of step:semi_implicit_euler by the state (q, qd) and by tau; Coulomb "
                  "friction counts as constant",
                  {.from_choices = derive_semi_implicit_step_derivatives,
                   .alternatives = {{"products with B^-1", derive_semi_implicit_step_derivatives_by_products}},
                   .formulation = "substitution into B = L^T D L"},
                  definitions::semi_implicit_step_derivatives, references::semi_implicit_step_derivatives),
      with_derivatives(
          step("step:rk4",
               "A step of length h with constant torques by the classical Runge-Kutta method of fourth order",
               {.from_choices = derive_runge_kutta_step,
                .alternatives = {{"articulated bodies", derive_runge_kutta_step_by_articulated_bodies},
                                 {"B = L^T D L of composite bodies", derive_runge_kutta_step_by_composite_bodies}},
                .formulation = "B = L^T D L"},
               definitions::runge_kutta_step, references::runge_kutta_step),
          "step_derivatives:rk4"),
      derivatives("step_derivatives:rk4",
                  "The derivatives A and B of step:rk4 by the state (q, qd) and by tau; Coulomb friction counts as "
                  "constant",
                  {.from_choices = derive_runge_kutta_step_derivatives}, definitions::runge_kutta_step_derivatives,
                  references::runge_kutta_step_derivatives),
      midpoint_row(),
      midpoint_derivatives_row()};
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
