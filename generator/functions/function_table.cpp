// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/function_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/acceleration_functions.hpp"
#include "derivation/dynamics/centroidal_functions.hpp"
#include "derivation/dynamics/contact_functions.hpp"
#include "derivation/dynamics/derivative_functions.hpp"
#include "derivation/dynamics/energy_functions.hpp"
#include "derivation/dynamics/inertia_functions.hpp"
#include "derivation/dynamics/kinematics_functions.hpp"
#include "derivation/dynamics/loop_functions.hpp"
#include "derivation/dynamics/momentum_functions.hpp"
#include "derivation/dynamics/operational.hpp"
#include "derivation/dynamics/torque_functions.hpp"
#include "derivation/parameters/regressor_functions.hpp"
#include "functions/derivative_rows.hpp"
#include "graph/function_name.hpp"
#include "truth/definition/centroidal_definitions.hpp"
#include "truth/definition/contact_definitions.hpp"
#include "truth/definition/derivative_definitions.hpp"
#include "truth/definition/dynamics_definitions.hpp"
#include "truth/definition/kinematics_definitions.hpp"
#include "truth/definition/loop_definitions.hpp"
#include "truth/definition/operational_definitions.hpp"
#include "truth/definition/regressor_definitions.hpp"
#include "truth/reference/centroidal_references.hpp"
#include "truth/reference/contact_references.hpp"
#include "truth/reference/derivative_references.hpp"
#include "truth/reference/dynamics_references.hpp"
#include "truth/reference/kinematics_references.hpp"
#include "truth/reference/loop_references.hpp"
#include "truth/reference/operational_references.hpp"
#include "truth/reference/regressor_references.hpp"

namespace flatdyn {
namespace {

constexpr InputKind q = InputKind::q, qd = InputKind::qd, qdd = InputKind::qdd, tau = InputKind::tau,
                    h_e = InputKind::h_e, g_b = InputKind::g_b, pi_b = InputKind::pi_b, qd_r = InputKind::qd_r,
                    qdd_r = InputKind::qdd_r;

constexpr OutputRow scalar(const char* name, OutputQuantity quantity) {
  return {name, Layout::scalar, Extent::one, Extent::one, quantity};
}
constexpr OutputRow vector(const char* name, Extent rows, OutputQuantity quantity) {
  return {name, Layout::vector, rows, Extent::one, quantity};
}
constexpr OutputRow matrix(const char* name, Extent rows, Extent cols, OutputQuantity quantity) {
  return {name, Layout::matrix, rows, cols, quantity};
}
constexpr OutputRow per_joint(const char* name, OutputQuantity quantity) {
  return vector(name, Extent::joints, quantity);
}
constexpr OutputRow square(const char* name, OutputQuantity quantity) {
  return matrix(name, Extent::joints, Extent::joints, quantity);
}

const std::vector<FunctionRow> kRows = {
    {.name = "inverse_dynamics",
     .summary = "tau = B(q) qdd + C(q, qd) qd + g(q) + friction",
     .equation = "(7.42)",
     .inputs = {q, g_b, qd, qdd},
     .outputs = {per_joint("tau", OutputQuantity::joint_torque)},
     .derivation = {.from_choices = derive_inverse_dynamics, .closed_form = closed_inverse_dynamics},
     .definition = definitions::inverse_dynamics,
     .reference = references::inverse_dynamics},
    {.name = "inverse_dynamics_tip_force",
     .summary = "Inverse dynamics with a force h_e that the tip exerts on the environment",
     .equation = "(7.42)",
     .inputs = {q, g_b, qd, qdd, h_e},
     .outputs = {per_joint("tau", OutputQuantity::joint_torque)},
     .derivation = {.from_choices = derive_inverse_dynamics_tip_force},
     .definition = definitions::inverse_dynamics_tip_force,
     .reference = references::inverse_dynamics_tip_force},
    {.name = "inertia_matrix",
     .summary = "Joint-space inertia matrix B(q)",
     .equation = "(7.32)",
     .inputs = {q},
     .outputs = {square("B", OutputQuantity::joint_inertia)},
     .derivation = {.from_choices = derive_inertia_matrix, .closed_form = closed_inertia_matrix},
     .definition = definitions::inertia_matrix,
     .reference = references::inertia_matrix},
    {.name = "christoffel",
     .summary = "Christoffel symbols of the first kind c_ijk(q)",
     .equation = "(7.45)",
     .inputs = {q},
     .outputs = {{"c", Layout::christoffel, Extent::joints, Extent::joint_pairs, OutputQuantity::christoffel_symbol}},
     .derivation = {.from_choices = derive_christoffel, .closed_form = closed_christoffel},
     .definition = definitions::christoffel,
     .reference = references::christoffel,
     .traits = {.needs_rates = true}},
    {.name = "coriolis_matrix",
     .summary = "C(q, qd) from the Christoffel symbols",
     .equation = "(7.44)",
     .inputs = {q, qd},
     .outputs = {square("C", OutputQuantity::torque_per_rate)},
     .derivation = {.from_choices = derive_coriolis_from_christoffel,
                    .alternatives = {{"momenta of composite bodies", derive_coriolis_from_momenta}},
                    .formulation = "Christoffel symbols",
                    .closed_form = closed_coriolis_matrix},
     .definition = definitions::coriolis_matrix,
     .reference = references::coriolis_matrix},
    {.name = "gravity",
     .summary = "Gravity torques g(q)",
     .equation = "(7.39)",
     .inputs = {q, g_b},
     .outputs = {per_joint("g", OutputQuantity::joint_torque)},
     .derivation = {.from_choices = derive_gravity, .closed_form = closed_gravity},
     .definition = definitions::gravity,
     .reference = references::gravity,
     .traits = {.depends_on_gravity_only = true}},
    {.name = "bias",
     .summary = "C(q, qd) qd + g(q) + friction",
     .equation = "(7.116)",
     .inputs = {q, g_b, qd},
     .outputs = {per_joint("n", OutputQuantity::joint_torque)},
     .derivation = {.from_choices = derive_bias, .closed_form = closed_bias},
     .definition = definitions::bias,
     .reference = references::bias},
    {.name = "forward_dynamics",
     .summary = "qdd from B(q) qdd = tau - bias(q, qd)",
     .equation = "(7.115)",
     .inputs = {q, g_b, qd, tau},
     .outputs = {per_joint("qdd", OutputQuantity::joint_acceleration)},
     .derivation = {.from_choices = derive_forward_dynamics,
                    .alternatives = {{"articulated bodies", derive_forward_dynamics_by_articulated_bodies},
                                     {"B = L^T D L of composite bodies", derive_forward_dynamics_by_composite_bodies}},
                    .formulation = "B = L^T D L"},
     .definition = definitions::forward_dynamics,
     .reference = references::forward_dynamics,
     .traits = {.divides_by_pivots = true}},
    {.name = "kinetic_energy",
     .summary = "Kinetic energy of links and rotors",
     .equation = "(7.31)",
     .inputs = {q, qd},
     .outputs = {scalar("T", OutputQuantity::energy)},
     .derivation = {.from_choices = derive_kinetic_energy, .closed_form = closed_kinetic_energy},
     .definition = definitions::kinetic_energy,
     .reference = references::kinetic_energy},
    {.name = "momentum",
     .summary = "Generalised momenta B(q) qd",
     .equation = "",
     .inputs = {q, qd},
     .outputs = {per_joint("p", OutputQuantity::joint_momentum)},
     .derivation = {.from_choices = derive_momentum},
     .definition = definitions::momentum,
     .reference = references::momentum,
     .traits = {.on_request = true}},
    {.name = "coriolis_transpose_qd",
     .summary = "C(q, qd)^T qd: what changes the momenta apart from torques, gravity and friction",
     .equation = "(7.47)",
     .inputs = {q, qd},
     .outputs = {per_joint("dp", OutputQuantity::joint_momentum_rate)},
     .derivation = {.from_choices = derive_coriolis_transpose_qd},
     .definition = definitions::coriolis_transpose_qd,
     .reference = references::coriolis_transpose_qd,
     .traits = {.on_request = true}},
    {.name = "potential_energy",
     .summary = "Potential energy of links and rotors",
     .equation = "(7.36)",
     .inputs = {q, g_b},
     .outputs = {scalar("U", OutputQuantity::energy)},
     .derivation = {.from_choices = derive_potential_energy},
     .definition = definitions::potential_energy,
     .reference = references::potential_energy,
     .traits = {.depends_on_gravity_only = true}},
    {.name = "forward_kinematics",
     .summary = "Pose of the tip",
     .equation = "(2.50)",
     .inputs = {q},
     .outputs = {matrix("R", Extent::three, Extent::three, OutputQuantity::number),
                 vector("p", Extent::three, OutputQuantity::position)},
     .derivation = {.of_link = derive_forward_kinematics},
     .definition = definitions::forward_kinematics,
     .reference = references::forward_kinematics},
    {.name = "jacobian",
     .summary = "Geometric Jacobian of the tip",
     .equation = "(7.14), (7.15)",
     .inputs = {q},
     .outputs = {matrix("J", Extent::six, Extent::joints, OutputQuantity::tip_jacobian)},
     .derivation = {.of_link = derive_jacobian},
     .definition = definitions::jacobian,
     .reference = references::jacobian},
    {.name = "jacobian_dot_qd",
     .summary = "(dJ/dt) qd of the tip",
     .equation = "",
     .inputs = {q, qd},
     .outputs = {vector("a", Extent::six, OutputQuantity::tip_acceleration)},
     .derivation = {.of_link = derive_jacobian_dot_qd},
     .definition = definitions::jacobian_dot_qd,
     .reference = references::jacobian_dot_qd},
    {.name = "frame_velocity",
     .summary = "J(q) qd: the velocity of the tip",
     .equation = "",
     .inputs = {q, qd},
     .outputs = {vector("v_e", Extent::six, OutputQuantity::frame_velocity)},
     .derivation = {.of_link = derive_frame_velocity},
     .definition = definitions::frame_velocity,
     .reference = references::frame_velocity,
     .traits = {.on_request = true}},
    {.name = "frame_acceleration",
     .summary = "J(q) qdd + (dJ/dt) qd: the acceleration of the tip",
     .equation = "",
     .inputs = {q, qd, qdd},
     .outputs = {vector("a_e", Extent::six, OutputQuantity::frame_acceleration)},
     .derivation = {.of_link = derive_frame_acceleration},
     .definition = definitions::frame_acceleration,
     .reference = references::frame_acceleration,
     .traits = {.on_request = true}},
    {.name = "external_torque",
     .summary = "J(q)^T h_e: the torques for a force h_e that the tip exerts on the environment",
     .equation = "(7.42)",
     .inputs = {q, h_e},
     .outputs = {per_joint("tau", OutputQuantity::joint_torque)},
     .derivation = {.of_link = derive_external_torque},
     .definition = definitions::external_torque,
     .reference = references::external_torque,
     .traits = {.on_request = true}},
    {.name = "loop_closure",
     .summary = "Phi(q): what lies between the points where the loops are closed",
     .equation = "",
     .inputs = {q},
     .outputs = {vector("phi", Extent::loop_equations, OutputQuantity::loop_gap)},
     .derivation = {.from_mechanism = derive_loop_closure},
     .definition = definitions::loop_closure,
     .reference = references::loop_closure,
     .traits = {.needs_loops = true}},
    {.name = "loop_jacobian",
     .summary = "Phi_q, the derivative of loop_closure",
     .equation = "",
     .inputs = {q},
     .outputs = {matrix("phi_q", Extent::loop_equations, Extent::positions, OutputQuantity::loop_gap_per_position)},
     .derivation = {.from_mechanism = derive_loop_jacobian},
     .definition = definitions::loop_jacobian,
     .reference = references::loop_jacobian,
     .traits = {.needs_loops = true}},
    {.name = "loop_step",
     .summary = "Newton's step of the dependent joints towards closed loops",
     .equation = "",
     .inputs = {q},
     .outputs = {vector("dq", Extent::positions, OutputQuantity::joint_position)},
     .derivation = {.from_mechanism = derive_loop_step},
     .definition = definitions::loop_step,
     .reference = references::loop_step,
     .traits = {.needs_loops = true}},
    {.name = "loop_motion",
     .summary = "Rates and accelerations of all joints of q, from those of the independent ones",
     .equation = "",
     .inputs = {q, qd, qdd},
     .outputs = {vector("rates", Extent::positions, OutputQuantity::joint_rate),
                 vector("accelerations", Extent::positions, OutputQuantity::joint_acceleration)},
     .derivation = {.from_mechanism = derive_loop_motion},
     .definition = definitions::loop_motion,
     .reference = references::loop_motion,
     .traits = {.needs_loops = true}},
    {.name = "inverse_dynamics_derivatives",
     .summary = "Derivatives of tau(q, qd, qdd) by q and by qd; Coulomb friction counts as constant",
     .equation = "",
     .inputs = {q, g_b, qd, qdd},
     .outputs = {square("dtau_dq", OutputQuantity::torque_per_position),
                 square("dtau_dqd", OutputQuantity::torque_per_rate)},
     .derivation = {.from_choices = derive_inverse_dynamics_derivatives},
     .definition = definitions::inverse_dynamics_derivatives,
     .reference = references::inverse_dynamics_derivatives,
     .traits = {.on_request = true}},
    {.name = "forward_dynamics_derivatives",
     .summary = "Derivatives of qdd(q, qd, tau) by q, qd and tau; Coulomb friction counts as constant",
     .equation = "",
     .inputs = {q, g_b, qd, tau},
     .outputs = {square("dqdd_dq", OutputQuantity::acceleration_per_position),
                 square("dqdd_dqd", OutputQuantity::acceleration_per_rate),
                 square("dqdd_dtau", OutputQuantity::acceleration_per_torque)},
     .derivation = {.from_choices = derive_forward_dynamics_derivatives,
                    .alternatives = {{"products with B^-1", derive_forward_dynamics_derivatives_by_products}},
                    .formulation = "substitution into B = L^T D L"},
     .definition = definitions::forward_dynamics_derivatives,
     .reference = references::forward_dynamics_derivatives,
     // The derivatives depend on the inverse of B that comes with them.
     .traits = {.on_request = true, .divides_by_pivots = true, .is_all_or_nothing = true}},
    {.name = "operational_inertia",
     .summary = "B_A and the consistent inverse of J: the inertia that the tip moves with",
     .equation = "(7.130), (7.138)",
     .inputs = {q},
     .outputs = {matrix("B_A", Extent::task_rows, Extent::task_rows, OutputQuantity::task_inertia),
                 matrix("J_bar", Extent::joints, Extent::task_rows, OutputQuantity::joint_rate_per_task),
                 vector("condition", Extent::one, OutputQuantity::number)},
     .derivation = {.from_choices = derive_operational_inertia},
     .definition = definitions::operational_inertia,
     .reference = references::operational_inertia,
     .traits = {.on_request = true, .divides_by_pivots = true, .uses_task = true}},
    {.name = "operational_bias",
     .summary = "C_A times the tip's velocity, and g_A",
     .equation = "(7.131), (7.132)",
     .inputs = {q, g_b, qd},
     .outputs = {vector("c_A", Extent::task_rows, OutputQuantity::task_force),
                 vector("g_A", Extent::task_rows, OutputQuantity::task_force)},
     .derivation = {.from_choices = derive_operational_bias},
     .definition = definitions::operational_bias,
     .reference = references::operational_bias,
     .traits = {.on_request = true, .divides_by_pivots = true, .uses_task = true, .leaves_out_springs = true}},
    {.name = "null_space_torque",
     .summary = "The part of tau that moves the arm and leaves the tip where it is",
     .equation = "(7.141)",
     .inputs = {q, tau},
     .outputs = {per_joint("tau_n", OutputQuantity::joint_torque)},
     .derivation = {.from_choices = derive_null_space_torque},
     .definition = definitions::null_space_torque,
     .reference = references::null_space_torque,
     .traits = {.on_request = true, .divides_by_pivots = true, .uses_task = true}},
    {.name = "inverse_dynamics_floating",
     .summary = "The base's acceleration if nothing touches it, and joint torques, from joint accelerations: the first "
                "six entries of qdd are not read, those of tau are zero",
     .equation = "",
     .inputs = {q, g_b, qd, qdd},
     .outputs = {vector("a_base", Extent::six, OutputQuantity::joint_acceleration),
                 per_joint("tau", OutputQuantity::joint_torque)},
     .derivation = {.from_choices = derive_inverse_dynamics_floating},
     .definition = definitions::inverse_dynamics_floating,
     .reference = references::inverse_dynamics_floating,
     .traits = {.on_request = true, .divides_by_pivots = true, .needs_floating_base = true}},
    {.name = "centroidal_momentum_matrix",
     .summary = "A_G: A_G v is the momentum, and its moment about the centre of mass",
     .equation = "",
     .inputs = {q},
     .outputs = {matrix("A_G", Extent::six, Extent::joints, OutputQuantity::momentum_per_rate)},
     .derivation = {.from_choices = derive_centroidal_momentum_matrix},
     .definition = definitions::centroidal_momentum_matrix,
     .reference = references::centroidal_momentum_matrix,
     .traits = {.on_request = true, .needs_floating_base = true, .leaves_out_base_joint = true}},
    {.name = "centroidal_bias",
     .summary = "b_G: A_G a + b_G is the sum of all forces, and of their moments about the centre of mass",
     .equation = "",
     .inputs = {q, qd},
     .outputs = {vector("b_G", Extent::six, OutputQuantity::force_and_moment)},
     .derivation = {.from_choices = derive_centroidal_bias},
     .definition = definitions::centroidal_bias,
     .reference = references::centroidal_bias,
     .traits = {.on_request = true, .needs_floating_base = true, .leaves_out_base_joint = true}},
    {.name = "centre_of_mass",
     .summary = "Centre of mass of a robot with a floating base, and the Jacobian of its velocity",
     .equation = "",
     .inputs = {q},
     .outputs = {vector("r_G", Extent::three, OutputQuantity::position),
                 matrix("J_G", Extent::three, Extent::joints, OutputQuantity::tip_jacobian)},
     .derivation = {.from_choices = derive_centre_of_mass},
     .definition = definitions::centre_of_mass,
     .reference = references::centre_of_mass,
     .traits = {.on_request = true, .needs_floating_base = true, .leaves_out_base_joint = true}},
    {.name = "contact_jacobian",
     .summary = "Positions of the scene's contacts, and the Jacobian J_c of their velocities",
     .equation = "(7.14), (7.15)",
     .inputs = {q},
     .outputs = {vector("p_c", Extent::contact_points, OutputQuantity::position),
                 matrix("J_c", Extent::contact_rows, Extent::joints, OutputQuantity::contact_jacobian)},
     .derivation = {.from_choices = derive_contact_jacobian},
     .definition = definitions::contact_jacobian,
     .reference = references::contact_jacobian,
     .traits = {.on_request = true, .needs_contacts = true}},
    {.name = "contact_bias",
     .summary = "b_c: J_c qdd + b_c is the acceleration of the scene's contacts",
     .equation = "",
     .inputs = {q, qd},
     .outputs = {vector("b_c", Extent::contact_rows, OutputQuantity::contact_acceleration)},
     .derivation = {.from_choices = derive_contact_bias},
     .definition = definitions::contact_bias,
     .reference = references::contact_bias,
     .traits = {.on_request = true, .needs_contacts = true}},
    {.name = "constrained_forward_dynamics",
     .summary = "qdd and the forces f_c that keep the scene's contacts from accelerating: B qdd + bias = tau + J_c^T "
                "f_c, J_c qdd + b_c = 0",
     .equation = "",
     .inputs = {q, g_b, qd, tau},
     .outputs = {per_joint("qdd", OutputQuantity::joint_acceleration),
                 vector("f_c", Extent::contact_rows, OutputQuantity::contact_force),
                 vector("condition", Extent::one, OutputQuantity::number)},
     .derivation = {.from_choices = derive_constrained_forward_dynamics},
     .definition = definitions::constrained_forward_dynamics,
     .reference = references::constrained_forward_dynamics,
     .traits = {.on_request = true, .divides_by_pivots = true, .needs_contacts = true}},
    {.name = "contact_inverse_dynamics",
     .summary = "tau for given qdd, and the smallest forces f_c at the scene's contacts that carry the base: B qdd + "
                "bias = tau + J_c^T f_c",
     .equation = "",
     .inputs = {q, g_b, qd, qdd},
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
     .inputs = {q, qd},
     .outputs = {per_joint("qd_after", OutputQuantity::joint_rate),
                 vector("impulse", Extent::contact_rows, OutputQuantity::contact_impulse),
                 vector("condition", Extent::one, OutputQuantity::number)},
     .derivation = {.from_choices = derive_contact_impact},
     .definition = definitions::contact_impact,
     .reference = references::contact_impact,
     .traits = {.on_request = true, .divides_by_pivots = true, .needs_contacts = true}},
    {.name = "regressor",
     .summary = "Y(q, qd, qdd) with tau = Y pi, 13 parameters per joint, of its link with the rotors that it "
                "carries, in and about the frame that flatdyn inspect shows",
     .equation = "(7.81)",
     .inputs = {q, g_b, qd, qdd},
     .outputs = {matrix("Y", Extent::joints, Extent::parameters, OutputQuantity::torque_per_parameter)},
     .derivation = {.from_mechanism = derive_regressor},
     .definition = definitions::regressor,
     .reference = references::regressor,
     .traits = {.on_request = true, .leaves_out_springs = true, .leaves_out_base_joint = true}},
    {.name = "base_regressor",
     .summary = "Y_b(q, qd, qdd) with tau = Y_b pi_b, pi_b the base parameters",
     .equation = "(7.81)",
     .inputs = {q, g_b, qd, qdd},
     .outputs = {matrix("Y_b", Extent::joints, Extent::base_parameters, OutputQuantity::torque_per_parameter)},
     .derivation = {.from_mechanism = derive_base_regressor},
     .definition = definitions::base_regressor,
     .reference = references::base_regressor,
     .traits = {.on_request = true,
                .uses_base_parameters = true,
                .is_all_or_nothing = true,
                .leaves_out_springs = true,
                .leaves_out_base_joint = true}},
    {.name = "base_parameters",
     .summary = "pi_b of this robot: Y_b pi_b = tau",
     .equation = "",
     .inputs = {},
     .outputs = {vector("pi_b", Extent::base_parameters, OutputQuantity::parameter)},
     .derivation = {.from_mechanism = derive_base_parameters},
     .definition = definitions::base_parameters,
     .reference = references::base_parameters,
     .traits = {.on_request = true,
                .uses_base_parameters = true,
                .is_all_or_nothing = true,
                .leaves_out_springs = true,
                .leaves_out_base_joint = true}},
    {.name = "inverse_dynamics_base",
     .summary = "tau = B qdd + C qd + g + friction with the base parameters pi_b as an argument",
     .equation = "(7.42)",
     .inputs = {q, g_b, qd, qdd, pi_b},
     .outputs = {per_joint("tau", OutputQuantity::joint_torque)},
     .derivation = {.from_mechanism = derive_inverse_dynamics_base},
     .definition = definitions::inverse_dynamics_base,
     .reference = references::inverse_dynamics_base,
     .traits =
         {.on_request = true, .uses_base_parameters = true, .leaves_out_springs = true, .leaves_out_base_joint = true}},
    {.name = "spring_regressor",
     .summary =
         "Y_s(q) with Y_s pi_s the torques of the joints' springs, pi_s the stiffness k and k q_0 of every joint",
     .equation = "",
     .inputs = {q},
     .outputs = {matrix("Y_s", Extent::joints, Extent::springs, OutputQuantity::torque_per_parameter)},
     .derivation = {.from_mechanism = derive_spring_regressor},
     .definition = definitions::spring_regressor,
     .reference = references::spring_regressor,
     .traits = {.on_request = true}},
    {.name = "adaptive_regressor",
     .summary = "Y_b(q, qd, qd_r, qdd_r) with B qdd_r + C qd_r + g + friction at qd_r = Y_b pi_b",
     .equation = "(7.81)",
     .inputs = {q, g_b, qd, qd_r, qdd_r},
     .outputs = {matrix("Y_b", Extent::joints, Extent::base_parameters, OutputQuantity::torque_per_parameter)},
     .derivation = {.from_mechanism = derive_adaptive_regressor},
     .definition = definitions::adaptive_regressor,
     .reference = references::adaptive_regressor,
     .traits = {.on_request = true,
                .uses_base_parameters = true,
                .is_all_or_nothing = true,
                .leaves_out_springs = true,
                .leaves_out_base_joint = true}},
};

}  // namespace

std::vector<InputKind> FunctionRow::inputs_for(const Mechanism& mechanism) const {
  std::vector<InputKind> result;
  for (const InputKind kind : inputs) {
    if (kind == InputKind::g_b && !mechanism.has_base_gravity()) continue;
    result.push_back(with_base(kind, mechanism.has_quasi_velocities()));
  }
  return result;
}

const std::vector<FunctionRow>& function_table() { return kRows; }

const FunctionRow* find_row(const std::string& name) {
  static const DerivativeRows derivatives(kRows);
  const FunctionName parts = parts_of_name(name);
  if (parts.derivative != Derivative::none) return derivatives.find(parts.derivative, parts.stem);
  const auto found =
      std::find_if(kRows.begin(), kRows.end(), [&parts](const FunctionRow& row) { return parts.stem == row.name; });
  return found == kRows.end() ? nullptr : &*found;
}

std::string functions_of_links() {
  std::vector<std::string> names;
  for (const FunctionRow& row : function_table()) {
    if (row.derivation.of_link != nullptr) names.emplace_back(row.name);
  }
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

const FunctionRow& row_of(const Function& function) {
  const FunctionRow* row = find_row(function.name);
  if (row == nullptr) throw Failure(FailureKind::bug, "no row for function \"" + function.name + "\"");
  return *row;
}

}  // namespace flatdyn
