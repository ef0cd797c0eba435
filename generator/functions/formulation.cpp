// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/formulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/nearest.hpp"
#include "derivation/differentiation/differentiable.hpp"
#include "derivation/differentiation/differentiate.hpp"
#include "functions/function_table.hpp"
#include "functions/structured_derivatives.hpp"
#include "graph/function_name.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/floating_base.hpp"

namespace flatdyn {
namespace {

// Refuses derivatives that there are not; returns if the function itself is unknown.
void refuse_derivative(const std::string& name, const FunctionName& parts) {
  if (parts.stem.empty()) {
    throw Failure(FailureKind::usage, fmt::format("\"{}\" lacks a function", name),
                  fmt::format("such as {}inverse_dynamics", name));
  }
  if (parts_of_name(parts.of_whole()).derivative != Derivative::none) {
    throw Failure(FailureKind::usage, fmt::format("\"{}\": there are no derivatives of derivatives", name),
                  "hessian:FUNCTION has second derivatives");
  }
  const FunctionRow* row = find_row(parts.stem);
  if (row == nullptr) return;
  const bool is_of_step = parts.stem.starts_with("step_derivatives:");
  throw Failure(
      FailureKind::unsupported, fmt::format("there are no derivatives of \"{}\"", parts.stem),
      is_of_step ? "hessian:step:METHOD has second derivatives" : "it has no arguments that they could be by");
}

const FunctionRow& known_row(const std::string& name) {
  if (const FunctionRow* row = find_row(name)) return *row;
  const FunctionName parts = parts_of_name(name);
  if (parts.derivative != Derivative::none) refuse_derivative(name, parts);
  std::vector<std::string> known;
  for (const FunctionRow& row : function_table()) {
    const bool is_meant = !parts.stem.starts_with("step") || std::string(row.name).starts_with("step");
    if (is_meant) known.emplace_back(row.name);
  }
  throw Failure(FailureKind::usage, "unknown function \"" + parts.stem + "\"",
                hint_for_abbreviated(parts.stem, known, "functions"));
}

const LinkFrame& link_of(const Mechanism& mechanism, const std::string& name) {
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [&](const LinkFrame& frame) { return frame.link == name; });
  if (found != mechanism.links.end()) return *found;
  std::vector<std::string> known;
  for (const LinkFrame& frame : mechanism.links) known.push_back(frame.link);
  throw Failure(FailureKind::usage, "no link named \"" + name + "\"", hint_for_unknown(name, known, "links"));
}

// The function that a name asks for: "jacobian", or "jacobian:hand" for a link.
struct Request {
  const FunctionRow* row = nullptr;
  const LinkFrame* link = nullptr;
};

void refuse_friction_that_is_not_linear(const Mechanism& mechanism, const FunctionRow& row) {
  const auto body = std::find_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                 [](const Body& each) { return !each.dry.is_linear(); });
  const bool is_of_parameters = (row.differentiated != nullptr ? *row.differentiated : row).needs_linear_friction();
  if (body == mechanism.bodies.end() || !is_of_parameters) return;
  throw Failure(FailureKind::unsupported,
                fmt::format("function \"{}\": friction of joint \"{}\" ({}) is no multiple of F_s", row.name,
                            body->joint, body->dry.has_excess() ? "static" : "forward, backward"),
                "leave it out of --functions, or leave friction out by a scene with friction = false");
}

Request parsed(const Mechanism& mechanism, const std::string& name) {
  const FunctionName parts = parts_of_name(name);
  Request request{&known_row(name), nullptr};
  refuse_friction_that_is_not_linear(mechanism, *request.row);
  if (request.row->traits.needs_rates && mechanism.has_quasi_velocities()) {
    throw Failure(
        FailureKind::unsupported,
        fmt::format("function \"{}\" needs velocities that are derivatives of coordinates; those of {} are not",
                    request.row->name, mechanism.floating_base ? "a floating base" : "spherical joints"),
        "leave it out of --functions; coriolis_matrix has C(q, v)");
  }
  if (request.row->traits.refuses_loops && mechanism.has_loops()) {
    throw Failure(FailureKind::unsupported,
                  fmt::format("function \"{}\" is not there for robots with closed loops", request.row->name),
                  "step the independent joints with forward_dynamics, and close the loops with loop_step");
  }
  if (request.row->traits.uses_task && mechanism.floating_base && mechanism.task.rates_are_of_angles()) {
    throw Failure(FailureKind::unsupported, "a task in Euler angles is not supported for robots with a floating base",
                  "the base turns, too: take angular_velocity, in base axes");
  }
  if (request.row->traits.needs_floating_base && !mechanism.floating_base) {
    throw Failure(FailureKind::usage,
                  fmt::format("function \"{}\" is one of robots with a floating base", request.row->name),
                  "let the base move: --base floating");
  }
  if (request.row->traits.needs_contacts && mechanism.contacts.empty()) {
    throw Failure(FailureKind::usage,
                  fmt::format("function \"{}\" is about contacts, and there are none", request.row->name),
                  "name them in a scene: [[contact]] link = \"foot\" (docs/scene-format.md)");
  }
  if (request.row->traits.needs_load_friction && !mechanism.has_load_friction()) {
    throw Failure(FailureKind::usage,
                  fmt::format("function \"{}\" is about friction of loads, and no joint has any", request.row->name),
                  "write load_friction = 0.05 at a joint of a TOML file (docs/robot-format/toml.md)");
  }
  if (request.row->traits.needs_cones && mechanism.cone_rows() == 0) {
    throw Failure(FailureKind::usage,
                  fmt::format("function \"{}\" is about friction, and no contact has any", request.row->name),
                  "write friction = 0.6 in [[contact]] of the scene (docs/scene-format.md)");
  }
  if (!parts.link) return request;
  if (request.row->derivation.of_link == nullptr) {
    throw Failure(FailureKind::usage, fmt::format("function \"{}\" is not one of a link", request.row->name),
                  "those of a link are " + functions_of_links());
  }
  request.link = &link_of(mechanism, *parts.link);
  return request;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t k = text.find(from); k != std::string::npos; k = text.find(from, k + to.size())) {
    text.replace(k, from.size(), to);
  }
  return text;
}

// Said of derivatives by positions with a floating base, which are in its tangent space.
const char* const kTangentSpace =
    ". The first columns by q are those of a displacement of the base along its axes (m; it changes nothing), then of "
    "a turn R exp(S(delta)) about its axes (rad), which turns g_b alone: the numbers in v, and in a or tau, are held "
    "fixed";

// The same of spherical joints.
const char* const kTurnsOfChildren =
    ". Three columns by q of a spherical joint are those of a turn R exp(S(delta)) of the child about its axes (rad): "
    "the numbers in v, and in a or tau, are held fixed";

bool differentiates_by_position(const FunctionRow& row) {
  return std::any_of(row.outputs.begin(), row.outputs.end(), [](const OutputRow& output) {
    return output.quantity == OutputQuantity::torque_per_position ||
           output.quantity == OutputQuantity::acceleration_per_position;
  });
}

// The summary for a robot with springs.
std::string with_springs(const std::string& summary, const FunctionRow& row) {
  if (row.traits.leaves_out_springs) return summary + ", without springs";
  return replaced(replaced(summary, "+ friction", "+ friction + springs"), "Potential energy of links and rotors",
                  "Potential energy of links, rotors and springs");
}

// The summary for a robot whose floating base has armature or friction.
std::string with_base_joint(const std::string& summary, const FunctionRow& row) {
  if (!row.traits.leaves_out_base_joint) return summary;
  return summary + ", without the armature and friction of the floating base";
}

enum class SmoothJoints { none, some, all };

// Which of the joints with dry friction have smooth friction.
SmoothJoints smooth_joints(const Mechanism& mechanism) {
  const auto is_smooth = [](const Body& body) { return body.has_dry_friction() && body.dry.is_smooth(); };
  const auto jumps = [](const Body& body) { return body.has_dry_friction() && !body.dry.is_smooth(); };
  const auto& bodies = mechanism.bodies;
  if (std::none_of(bodies.begin(), bodies.end(), is_smooth)) return SmoothJoints::none;
  return std::any_of(bodies.begin(), bodies.end(), jumps) ? SmoothJoints::some : SmoothJoints::all;
}

// The summary for a robot with smooth friction, which has a derivative.
std::string with_smooth_friction(const std::string& summary, const Mechanism& mechanism) {
  const SmoothJoints smooth = smooth_joints(mechanism);
  if (smooth == SmoothJoints::none) return summary;
  const std::string constant = "Coulomb friction counts as constant";
  if (smooth == SmoothJoints::all) return replaced(summary, "; " + constant, "");
  return replaced(summary, constant, "Coulomb friction that is not smooth counts as constant");
}

// The summary for a robot whose drives lose a share of their torque.
std::string with_load_friction(const std::string& summary, const FunctionRow& row) {
  const bool has_torques = std::find(row.inputs.begin(), row.inputs.end(), InputKind::tau) != row.inputs.end() ||
                           std::any_of(row.outputs.begin(), row.outputs.end(), [](const OutputRow& output) {
                             return output.quantity == OutputQuantity::joint_torque;
                           });
  if (row.traits.needs_load_friction || !has_torques) return summary;
  return summary + "; tau is at the joints, without load_friction of the drives (drive_torque)";
}

// The summary where contacts are damped: they accelerate by forces.
std::string with_damping(const std::string& summary, const Rational& damping) {
  const std::string lambda = fmt::format(", lambda = {}", nearest_double(to_number(damping)));
  const std::string held = replaced(summary, "the forces f_c that keep", "the damped forces f_c that nearly keep");
  return replaced(replaced(held, "J_c qdd + b_c = 0", "J_c qdd + b_c = -lambda^2 f_c" + lambda), "J_c qd_after = 0",
                  "J_c qd_after = -lambda^2 impulse" + lambda);
}

// The summary "Pose of the tip", or "Pose of link hand".
std::string summary_of(const Request& request, const Mechanism& mechanism) {
  const bool floating_base = mechanism.floating_base;
  std::string summary = request.row->summary;
  if (mechanism.has_springs()) summary = with_springs(summary, *request.row);
  if (has_base_joint(mechanism)) summary = with_base_joint(summary, *request.row);
  summary = with_smooth_friction(summary, mechanism);
  if (mechanism.has_load_friction()) summary = with_load_friction(summary, *request.row);
  if (request.row->traits.needs_contacts && mechanism.contact_damping != 0) {
    summary = with_damping(summary, mechanism.contact_damping);
  }
  summary = in_coordinates(summary, mechanism);
  if (floating_base && summary.starts_with("(dJ/dt) v of ")) {
    summary = "Acceleration, while a is zero, of " + summary.substr(std::string("(dJ/dt) v of ").size());
  }
  if (differentiates_by_position(*request.row)) {
    if (floating_base) summary += kTangentSpace;
    if (mechanism.has_spherical_joints()) summary += kTurnsOfChildren;
  }
  const std::string tip = "the tip";
  const std::size_t place = summary.find(tip);
  if (request.link != nullptr && place != std::string::npos) {
    summary.replace(place, tip.size(), "link \"" + request.link->link + "\"");
  }
  return summary;
}

Function derived_plainly(const Mechanism& mechanism, const Request& request, const Choices& choices) {
  const DerivationRow& row = request.row->derivation;
  if (row.from_choices != nullptr) return row.from_choices(mechanism, choices);
  if (row.from_mechanism != nullptr) return row.from_mechanism(mechanism);
  return row.of_link(mechanism, request.link != nullptr ? *request.link : mechanism.tip);
}

// Says of an output with entries for v or a of a robot with spherical joints which they are.
void describe_spherical(Output& output) {
  switch (output.quantity) {
    case OutputQuantity::joint_torque:
      output.meaning += "; of spherical joints the moment in the child's axes";
      break;
    case OutputQuantity::joint_acceleration:
      output.meaning = "derivatives of the entries of v";
      break;
    case OutputQuantity::joint_inertia:
      output.meaning = "inertia matrix, symmetric, rows and columns in the order of v, SI units";
      break;
    case OutputQuantity::torque_per_position:
    case OutputQuantity::acceleration_per_position:
      output.meaning = replaced(replaced(output.meaning, "by q[k]", "by q, or a turn, along entry k of v"), "then q",
                                "then joints in the order of v");
      break;
    default:
      break;
  }
}

// Says of an output that has entries of a floating base which they are.
void describe_floating(const OutputRow& row, Output& output) {
  switch (output.quantity) {
    case OutputQuantity::joint_torque:
      output.meaning = "force and moment on the base (base axes, N, N m), then joint torques";
      break;
    case OutputQuantity::joint_acceleration:
      if (row.rows == Extent::positions) break;
      output.meaning =
          row.rows == Extent::six ? "derivatives of the first six entries of v" : "derivatives of the entries of v";
      break;
    case OutputQuantity::joint_inertia:
      output.meaning = "inertia matrix, symmetric, rows and columns in the order of v, SI units";
      break;
    case OutputQuantity::tip_acceleration:
      output.meaning = "acceleration while a is zero, for an observer at rest, base axes: linear, then angular";
      break;
    case OutputQuantity::torque_per_position:
      output.meaning = "row i: of tau[i]; columns: displacement of the base, its turn, then q";
      break;
    case OutputQuantity::acceleration_per_position:
      output.meaning = "row i: of a[i]; columns: displacement of the base, its turn, then q";
      break;
    default:
      break;
  }
}

// Says of derivatives by q with closed loops by what they are.
void describe_along_loops(Output& output) {
  output.meaning = replaced(output.meaning, "by q[k]", "by independent joint k, along which the others move");
}

// Sets what a row says of its function. Throws Failure(bug) if the derivation has other outputs than the row.
void describe(const FunctionRow& row, const Mechanism& mechanism, Function& function) {
  function.equation = row.equation;
  function.inputs = row.inputs_for(mechanism);
  const auto is_same = [](const Output& output, const OutputRow& expected) {
    return output.name == expected.name && output.layout == expected.layout;
  };
  const std::vector<OutputRow> outputs = row.outputs_for(mechanism);
  if (!std::equal(function.outputs.begin(), function.outputs.end(), outputs.begin(), outputs.end(), is_same)) {
    throw Failure(FailureKind::bug, fmt::format("{}: its derivation has other outputs than its row", row.name));
  }
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    function.outputs[k].quantity = outputs[k].quantity;
    function.outputs[k].name = in_coordinates(function.outputs[k].name, mechanism);
    function.outputs[k].meaning = in_coordinates(function.outputs[k].meaning, mechanism);
    if (mechanism.floating_base) describe_floating(outputs[k], function.outputs[k]);
    if (mechanism.has_spherical_joints()) describe_spherical(function.outputs[k]);
    if (mechanism.has_loops() && differentiates_by_position(row)) describe_along_loops(function.outputs[k]);
  }
}

}  // namespace

namespace {

std::string summary_of_derivative(const std::string& function, Derivative derivative, const Mechanism& mechanism) {
  std::string summary;
  switch (derivative) {
    case Derivative::none:
      break;
    case Derivative::jacobian_times_vector:
      summary = fmt::format("J d, with J the derivatives of {} by its arguments", function);
      break;
    case Derivative::vector_times_jacobian:
      summary = fmt::format("w^T J, with J the derivatives of {} by its arguments", function);
      break;
    case Derivative::jacobian:
      summary = fmt::format("J, the derivatives of {} by its arguments", function);
      break;
    case Derivative::contracted_hessian:
      summary = fmt::format("The second derivatives of {} by its arguments, times weights of its entries", function);
      break;
  }
  if (smooth_joints(mechanism) != SmoothJoints::all) summary += "; signs count as constant";
  const bool has_entries_of_v = mechanism.has_quasi_velocities();
  if (mechanism.has_loops() && !has_entries_of_v) {
    summary += ". Derivatives by q are by the independent joints, along which the others move";
  }
  if (!has_entries_of_v) return summary;
  summary += ". Derivatives by q are along the entries of v, while the numbers in other arguments are held";
  if (mechanism.floating_base) {
    summary +=
        ": first a displacement of the base along its axes (m; it changes nothing), then a turn R exp(S(delta)) about "
        "its axes (rad), which turns g_b alone";
  }
  if (mechanism.has_loops()) summary += "; then the independent joints, along which the others move";
  if (mechanism.has_spherical_joints()) {
    summary += "; of a spherical joint they are turns R exp(S(delta)) of the child about its axes (rad)";
  }
  if (derivative == Derivative::contracted_hessian) {
    summary += ". Second derivatives by turns depend on the order: that of the row comes first";
  }
  return summary;
}

Function derivative_of(const Differentiable& of, Derivative derivative) {
  switch (derivative) {
    case Derivative::none:
      break;
    case Derivative::jacobian_times_vector:
      return jacobian_times_vector(of.function(), of.tangents());  // its outputs have the quantities of the function's
    case Derivative::vector_times_jacobian:
      return vector_times_jacobian(of.function(), of.tangents());
    case Derivative::jacobian:
      return jacobian_matrices(of.function(), of.tangents());
    case Derivative::contracted_hessian:
      return contracted_hessian(of.function(), of.tangents());
  }
  return of.function();
}

// A derivative of a function, in a formulation of the function, or of what its derivatives are made from.
std::optional<Function> derivative_in(const Mechanism& mechanism, const FunctionRow& row, const std::string& function,
                                      FormulationIndex way, const Choices& choices) {
  const FunctionRow& of = *row.differentiated;
  if (row.derivative == Derivative::jacobian && has_jacobian_parts(mechanism, of)) {
    return jacobian_of_parts(mechanism, of, way, choices);
  }
  if (row.derivative == Derivative::jacobian && has_state_derivatives(mechanism, of)) {
    return jacobian_of_step(mechanism, of, way, choices);
  }
  if (row.derivative == Derivative::jacobian && is_held(mechanism, of)) {
    if (way > 0) return std::nullopt;
    return held_jacobian(mechanism, of, choices);
  }
  if (is_implicit(mechanism, of, row.derivative)) {
    if (std::optional<Function> made = implicit_derivative(mechanism, of, row.derivative, way, choices)) return made;
    // Second derivatives of the graph of forward dynamics take several times as many operations, and long to make.
    if (row.derivative == Derivative::contracted_hessian) return std::nullopt;
    --way;  // the first formulation is that of the multipliers, the others are those of the graph
  }
  const std::optional<Function> made = formulation(mechanism, function, way, choices);
  if (!made) return std::nullopt;
  const Differentiable whole(mechanism, without_condition(*made), made->inputs, choices);
  return whole.finished(derivative_of(whole, row.derivative));
}

}  // namespace

std::string in_coordinates(const std::string& text, const Mechanism& mechanism) {
  return mechanism.has_quasi_velocities() ? replaced(replaced(text, "qdd", "a"), "qd", "v") : text;
}

Function without_condition(Function function) {
  if (!function.outputs.empty() && function.outputs.back().name == kCondition) function.outputs.pop_back();
  return function;
}

void check_function_name(const Mechanism& mechanism, const std::string& name) { parsed(mechanism, name); }

std::optional<Function> formulation(const Mechanism& mechanism, const std::string& name, FormulationIndex way,
                                    const Choices& choices) {
  const Request request = parsed(mechanism, name);
  if (request.row->differentiated != nullptr) {
    const std::string function = parts_of_name(name).of_whole();
    std::optional<Function> made = derivative_in(mechanism, *request.row, function, way, choices);
    if (!made) return std::nullopt;
    made->name = name;
    made->summary = summary_of_derivative(function, request.row->derivative, mechanism);
    made->equation = "";
    return made;
  }
  const DerivationRow& derivation = request.row->derivation;
  std::optional<Function> result;
  if (way == 0) {
    result = derived_plainly(mechanism, request, choices);
  } else if (way <= derivation.alternatives.size()) {
    result = derivation.alternatives[way - 1].derive(mechanism, choices);
  }
  if (!result) return result;
  if (derivation.has_several()) {
    result->formulation = way == 0 ? derivation.formulation : derivation.alternatives[way - 1].formulation;
  }
  result->name = name;
  if (request.row->traits.divides_by_pivots) result->proven_pivot_share = choices.guard.proven_share;
  result->summary = summary_of(request, mechanism);
  describe(*request.row, mechanism, *result);
  return result;
}

const FunctionRow& checked_row(const Mechanism& mechanism, const std::string& name) {
  return *parsed(mechanism, name).row;
}

bool has_choices(const Mechanism& mechanism, const std::string& name) {
  return parsed(mechanism, name).row->has_choices();
}

Choices plain_choices(const Mechanism& mechanism) { return uniform_choices(mechanism, Grouping::i_yy); }

Function derive_function(const Mechanism& mechanism, const std::string& name) {
  return *formulation(mechanism, name, 0, plain_choices(mechanism));
}

}  // namespace flatdyn
