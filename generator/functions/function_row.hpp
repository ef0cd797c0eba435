// SPDX-License-Identifier: GPL-2.0-or-later
// All that is known about a function before a robot is: one row of the table.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "derivation/closed_functions.hpp"
#include "derivation/kernel/choices.hpp"
#include "graph/function_name.hpp"
#include "truth/definition/definition.hpp"
#include "truth/reference/numeric_reference.hpp"

namespace flatdyn {

// A number of rows or columns, which depends on the robot.
enum class Extent {
  one,
  three,
  four,
  six,
  joints,           // n, the number of coordinates
  joint_pairs,      // n (n + 1) / 2
  states,           // 2 n: positions, then their rates
  positions,        // the entries of q: with closed loops, those of dependent joints, too
  loop_equations,   // the entries of Φ
  task_rows,        // the directions of the task
  parameters,       // 13 per joint, and ten of a floating base
  base_parameters,  // the entries of π_b
  springs,          // 2 per joint
  contact_rows,     // the directions that the scene's contacts hold
  contact_points,   // 3 per contact
  cone_rows,        // the conditions of friction at the scene's contacts
  symbols,          // the free symbols of the robot
  link_rows,        // 3 per link
};

struct OutputRow {
  const char* name;
  Layout layout;
  Extent rows, cols;
  OutputQuantity quantity;
  bool of_floating_base = false;  // whether it is there for robots with a floating base only
};

// Another formulation of a function, in the words of reports.
struct Alternative {
  const char* formulation;
  std::optional<Function> (*derive)(const Mechanism&, const Choices&);
};

// Exactly one of the first three derives the function, by the formulation that is named.
struct DerivationRow {
  Function (*from_choices)(const Mechanism&, const Choices&) = nullptr;
  Function (*from_mechanism)(const Mechanism&) = nullptr;
  Function (*of_link)(const Mechanism&, const LinkFrame&) = nullptr;  // of any link; of the tip by default
  // Other formulations of the same function; which one costs least depends on the robot, and not every robot has them.
  std::vector<Alternative> alternatives = {};
  const char* formulation = kRecursion;
  ClosedEntries closed_form = nullptr;  // from Lagrange's equations as expanded polynomials

  bool has_several() const { return !alternatives.empty() || closed_form != nullptr; }
};

// Properties of a function that commands ask for; all false for most functions.
struct FunctionTraits {
  // Whether it is derived only where it is asked for by name. Such functions serve identification, adaptive control,
  // optimisers and operational-space control, and are larger than all other functions of a controller together.
  bool on_request = false;
  bool needs_loops = false;              // whether it applies to robots with closed loops only
  bool divides_by_pivots = false;        // whether it is computed by B = Lᵀ D L, or by articulated bodies
  bool uses_task = false;                // whether it depends on the scene's task
  bool uses_base_parameters = false;     // whether it has a column or an entry per base parameter
  bool is_all_or_nothing = false;        // whether its entries cannot be compared one by one with the definition
  bool depends_on_gravity_only = false;  // whether inertia and friction do not change it
  bool needs_floating_base = false;      // whether it is there for robots with a floating base only
  bool needs_rates = false;              // whether velocities have to be the derivatives of coordinates
  bool leaves_out_springs = false;       // whether it is about torques without those of springs
  bool leaves_out_base_joint = false;    // whether armature and friction of a floating base have no part in it
  bool needs_contacts = false;           // whether it is about the scene's contacts
  bool needs_cones = false;              // whether it is about their friction
  bool needs_load_friction = false;      // whether it is about drives that lose a share of their torque
  bool leaves_rest = false;              // whether it needs velocities although it starts at rest
  bool refuses_loops = false;            // whether it is there for robots without closed loops only
  bool has_gaps = false;                 // whether it has no value at some states, where its reference returns NaN
};

// A function whose outputs are the derivatives of another one by some of its arguments, a square matrix for each.
struct JacobianPart {
  const char* function;
  std::vector<InputKind> arguments;
};

// How forward dynamics is differentiated as the solution of inverse dynamics
// (derivation/differentiation/implicit.hpp).
struct ImplicitRow {
  const char* torques = nullptr;  // "inverse_dynamics"; null: it is not such a solution
  Function (*solution)(const Mechanism&, const Choices&) = nullptr;                           // q̈ and λ
  std::vector<Function (*)(const Mechanism&, const Choices&)> solution_and_derivatives = {};  // in several formulations
};

struct FunctionRow {
  const char* name;
  const char* summary;            // one line of help
  const char* equation;           // of the textbook, or ""
  std::vector<InputKind> inputs;  // for robots of all kinds
  std::vector<OutputRow> outputs;
  DerivationRow derivation;
  Definition definition;
  NumericReference reference;
  FunctionTraits traits = {};
  std::vector<JacobianPart> jacobian_parts = {};  // by all of its arguments but g_b; empty: there are none
  // The function that returns A and B, if it is a step: its derivatives by q, q̇ and τ.
  const char* state_derivatives = nullptr;
  ImplicitRow implicit = {};
  // For a motion while contacts hold: q̈, forces, and how these change (derivation/differentiation/held.hpp).
  Function (*held_motion)(const Mechanism&, const Choices&) = nullptr;
  // Rows of derivatives say which derivatives they are, and have the row of the function, by whose definition and
  // reference they are judged, and from whose derivation they are made.
  Derivative derivative = Derivative::none;
  const FunctionRow* differentiated = nullptr;

  // Whether the function applies to the robot.
  bool applies_to(const Mechanism& mechanism) const {
    const bool has_base = mechanism.floating_base || !traits.needs_floating_base,
               has_rates = !mechanism.has_quasi_velocities() || !traits.needs_rates,
               has_contacts = !mechanism.contacts.empty() || !traits.needs_contacts,
               has_loads = mechanism.has_load_friction() || !traits.needs_load_friction,
               has_cones = mechanism.cone_rows() > 0 || !traits.needs_cones,
               has_loops = mechanism.has_loops() ? !traits.refuses_loops : !traits.needs_loops;
    return has_base && has_rates && has_contacts && has_cones && has_loads && has_loops;
  }
  // Whether it is about the factors of the dynamic parameters, so that friction has to be F_s times one of them.
  bool needs_linear_friction() const {
    const auto is_of_parameters = [](const OutputRow& output) {
      return output.quantity == OutputQuantity::torque_per_parameter || output.quantity == OutputQuantity::parameter;
    };
    return traits.leaves_out_springs && (std::any_of(outputs.begin(), outputs.end(), is_of_parameters) ||
                                         std::find(inputs.begin(), inputs.end(), InputKind::pi_b) != inputs.end());
  }
  // The arguments for this robot: with a floating base or spherical joints v and a for q̇ and q̈, and g_b if the base
  // floats and there is gravity.
  std::vector<InputKind> inputs_for(const Mechanism& mechanism) const;
  // The outputs for this robot.
  std::vector<OutputRow> outputs_for(const Mechanism& mechanism) const;
  // Whether its cost depends on choices of frames and units.
  bool has_choices() const { return derivation.from_choices != nullptr; }
};

}  // namespace flatdyn
