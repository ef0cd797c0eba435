// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/contact_rows.hpp"

#include <algorithm>
#include <string>

#include "derivation/dynamics/contact_functions.hpp"
#include "derivation/dynamics/friction_cones.hpp"
#include "functions/output_rows.hpp"
#include "truth/definition/contact_definitions.hpp"
#include "truth/reference/contact_references.hpp"

namespace flatdyn {
namespace {

const std::vector<FunctionRow> kContactRows = {
    {.name = "contact_jacobian",
     .summary = "Positions of the scene's contacts, and the Jacobian J_c of their velocities",
     .equation = "(7.14), (7.15)",
     .inputs = {InputKind::q},
     .outputs = {vector("p_c", Extent::contact_points, OutputQuantity::position),
                 matrix("J_c", Extent::contact_rows, Extent::joints, OutputQuantity::contact_jacobian)},
     .derivation = {.from_choices = derive_contact_jacobian},
     .definition = definitions::contact_jacobian,
     .reference = references::contact_jacobian,
     .traits = {.on_request = true, .needs_contacts = true}},
    {.name = "contact_bias",
     .summary = "b_c: J_c qdd + b_c is the acceleration of the scene's contacts",
     .equation = "",
     .inputs = {InputKind::q, InputKind::qd},
     .outputs = {vector("b_c", Extent::contact_rows, OutputQuantity::contact_acceleration)},
     .derivation = {.from_choices = derive_contact_bias},
     .definition = definitions::contact_bias,
     .reference = references::contact_bias,
     .traits = {.on_request = true, .needs_contacts = true}},
    {.name = "constrained_forward_dynamics",
     .summary = "qdd and the forces f_c that keep the scene's contacts from accelerating: B qdd + bias = tau + J_c^T "
                "f_c, J_c qdd + b_c = 0",
     .equation = "",
     .inputs = {InputKind::q, InputKind::g_b, InputKind::qd, InputKind::tau},
     .outputs = {per_joint("qdd", OutputQuantity::joint_acceleration),
                 vector("f_c", Extent::contact_rows, OutputQuantity::contact_force),
                 vector("condition", Extent::one, OutputQuantity::number)},
     .derivation = {.from_choices = derive_constrained_forward_dynamics},
     .definition = definitions::constrained_forward_dynamics,
     .reference = references::constrained_forward_dynamics,
     .traits = {.on_request = true, .divides_by_pivots = true, .needs_contacts = true},
     .held_motion = derive_held_motion_and_sensitivities},
    {.name = "contact_inverse_dynamics",
     .summary = "tau for given qdd, and the smallest forces f_c at the scene's contacts that carry the base: B qdd + "
                "bias = tau + J_c^T f_c",
     .equation = "",
     .inputs = {InputKind::q, InputKind::g_b, InputKind::qd, InputKind::qdd},
     .outputs = {per_joint("tau", OutputQuantity::joint_torque),
                 vector("f_c", Extent::contact_rows, OutputQuantity::contact_force),
                 vector("condition", Extent::one, OutputQuantity::number)},
     .derivation = {.from_choices = derive_contact_inverse_dynamics},
     .definition = definitions::contact_inverse_dynamics,
     .reference = references::contact_inverse_dynamics,
     .traits = {.on_request = true, .needs_floating_base = true, .needs_contacts = true}},
    {.name = "contact_impact",
     .summary = "The rates after an impact that stops the scene's contacts: B (qd_after - qd) = J_c^T impulse, J_c "
                "qd_after = 0",
     .equation = "",
     .inputs = {InputKind::q, InputKind::qd},
     .outputs = {per_joint("qd_after", OutputQuantity::joint_rate),
                 vector("impulse", Extent::contact_rows, OutputQuantity::contact_impulse),
                 vector("condition", Extent::one, OutputQuantity::number)},
     .derivation = {.from_choices = derive_contact_impact},
     .definition = definitions::contact_impact,
     .reference = references::contact_impact,
     .traits = {.on_request = true, .divides_by_pivots = true, .needs_contacts = true}},
    {.name = "friction_cones",
     .summary =
         "A_c with A_c f_c <= 0 where friction holds the scene's contacts: pyramids inside the cones of friction",
     .equation = "",
     .inputs = {InputKind::q, InputKind::g_b},
     .outputs = {matrix("A_c", Extent::cone_rows, Extent::contact_rows, OutputQuantity::number)},
     .derivation = {.from_choices = derive_friction_cones},
     .definition = definitions::friction_cones,
     .reference = references::friction_cones,
     .traits = {.on_request = true, .needs_contacts = true, .needs_cones = true}}};

}  // namespace

std::vector<FunctionRow> with_contacts(std::vector<FunctionRow> rows) {
  const auto place = std::find_if(rows.begin(), rows.end(),
                                  [](const FunctionRow& row) { return std::string(row.name) == "regressor"; });
  rows.insert(place, kContactRows.begin(), kContactRows.end());
  return rows;
}

}  // namespace flatdyn
