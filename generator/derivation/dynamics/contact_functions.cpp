// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/contact_functions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "derivation/dynamics/accelerations.hpp"
#include "derivation/dynamics/contact_rank.hpp"
#include "derivation/dynamics/contacts.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kAround = 3, kBaseRows = 6;

Function derived_at_contacts(const Mechanism& mechanism, const Choices& choices,
                             const std::function<Function(DerivationContext&)>& derive) {
  return derived(mechanism, at_the_contacts(choices, mechanism), derive);
}

// The same for functions whose forces must be determined.
Function derived_with_forces(const Mechanism& mechanism, const Choices& choices,
                             const std::function<Function(DerivationContext&)>& derive) {
  if (mechanism.contact_damping == 0) require_independent(mechanism);
  return derived_at_contacts(mechanism, choices, derive);
}

std::string at_contacts(const std::string& what, DerivationContext& context) {
  return fmt::format("{} at {}, base axes", what, contact_text(context.mechanism.contacts));
}

bool have_surfaces(DerivationContext& context) {
  const std::vector<Contact>& all = context.mechanism.contacts;
  return std::any_of(all.begin(), all.end(), [](const Contact& contact) { return contact.is_surface; });
}

Output force_output(DerivationContext& context, const std::vector<Number>& forces) {
  const char* what = have_surfaces(context) ? "forces (N) and moments (N m) on the robot" : "forces (N) on the robot";
  return vector_output("f_c", context.nodes(forces), at_contacts(what, context));
}

Output condition_output(DerivationContext& context, const Number& condition) {
  return vector_output("condition", {context.node(condition)},
                       "0..1: 1 where contacts are independent of each other, 0 where one follows from others");
}

Function with_contacts(const Mechanism& mechanism, Function function) {
  function.inverted = mechanism.contact_damping == 0 ? "B or J B^-1 J^T" : "B or J B^-1 J^T + lambda^2 1";
  return function;
}

// The contacts' points as those of a rigid body whose masses are 1, and surfaces with moments of inertia of 1 kg m².
class PointsOfSupport {
 public:
  explicit PointsOfSupport(DerivationContext& context)
      : context_(context), arms_(contact_positions(context)), centre_(centre()), inertia_(about_centre()) {}

  // The forces, smallest in Σ |f|² + |n|², whose sum is `force` and whose moment about the base frame's origin
  // `moment`: f = force / k + θ × d with d from the centre of the points, n = θ.
  std::vector<Number> forces(const Vec3& force, const Vec3& moment) const {
    Derivation& d = context_.derivation;
    const Vec3 about = d.named(moment - cross(centre_, force), "n_p");
    const std::vector<Number> turned = inertia_.solve({about[0], about[1], about[2]}, "theta");
    const Vec3 theta = {turned[0], turned[1], turned[2]};
    const Vec3 share = d.named(Number(1) / static_cast<int>(arms_.size()) * force, "f_p");
    std::vector<Number> result;
    for (std::size_t k = 0; k < arms_.size(); ++k) {
      const Vec3 f = d.named(share + cross(theta, arms_[k]), "f_" + label(static_cast<int>(k)));
      result.insert(result.end(), f.begin(), f.end());
      if (context_.mechanism.contacts[k].is_surface) result.insert(result.end(), theta.begin(), theta.end());
    }
    return result;
  }

  Number condition() const {
    Number sum = 0;
    for (std::size_t k = 0; k < kAround; ++k) sum += inertia_.diagonal()[k] * inertia_.inverse_pivots()[k];
    return context_.derivation.quotient(static_cast<int>(kAround), context_.derivation.named(sum, "growth"),
                                        "condition");
  }

  Conditions conditions() const {
    const std::vector<Number>& diagonal = inertia_.diagonal();
    const Number size = context_.derivation.named(kContactMargin * (diagonal[0] + diagonal[1] + diagonal[2]), "size_p");
    return {context_.nodes(inertia_.pivots()), context_.nodes(inertia_.pivot_scales({size, size, size}))};
  }

 private:
  // The mean of the points; `arms_` are then measured from it.
  Vec3 centre() {
    Derivation& d = context_.derivation;
    Vec3 sum = zero_vector();
    for (const Vec3& p : arms_) sum = sum + p;
    const Vec3 mean = d.named(Number(1) / static_cast<int>(arms_.size()) * sum, "p_m");
    for (std::size_t k = 0; k < arms_.size(); ++k) {
      arms_[k] = d.named(arms_[k] - mean, "d_" + label(static_cast<int>(k)));
    }
    return mean;
  }

  Factorisation about_centre() const {
    const auto is_surface = [](const Contact& contact) { return contact.is_surface; };
    const std::vector<Contact>& contacts = context_.mechanism.contacts;
    const Number surfaces = static_cast<long>(std::count_if(contacts.begin(), contacts.end(), is_surface));
    Mat3 sum = {Vec3{surfaces, 0, 0}, Vec3{0, surfaces, 0}, Vec3{0, 0, surfaces}};
    for (const Vec3& d : arms_) sum = sum + steiner(1, d);
    const Mat3 I = context_.derivation.named_symmetric(sum, "I_p");
    const Rows rows = {{I[0][0], I[0][1], I[0][2]}, {I[1][0], I[1][1], I[1][2]}, {I[2][0], I[2][1], I[2][2]}};
    return {context_.derivation, {-1, 0, 1}, rows, "the moment of the contacts' forces", "p"};
  }

  DerivationContext& context_;
  std::vector<Vec3> arms_;
  Vec3 centre_;
  Factorisation inertia_;
};

// τ - Jᵀ f, and zeros for the base.
std::vector<Number> without_forces(DerivationContext& context, std::vector<Number> tau,
                                   const std::vector<Number>& forces) {
  const Rows J = contact_jacobian(context);
  for (std::size_t k = 0; k < tau.size(); ++k) {
    if (k < kBaseRows) tau[k] = 0;
    for (std::size_t i = 0; i < J.size() && k >= kBaseRows; ++i) tau[k] -= J[i][k] * forces[i];
  }
  return tau;
}

Function contact_inverse_dynamics_at(DerivationContext& context) {
  const Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), context.gravity(),
                      true};
  const std::vector<Number> needed = context.at_coordinates(torques(context.frames, motion));
  const PointsOfSupport support(context);
  const std::vector<Number> forces =
      support.forces({needed[0], needed[1], needed[2]}, {needed[3], needed[4], needed[5]});
  Function function = finished(
      context,
      {torque_output("tau", context.nodes(without_forces(context, needed, forces))), force_output(context, forces),
       vector_output("condition", {context.node(support.condition())},
                     "0..1: 0 where the contacts' points are on one line")},
      support.conditions());
  function.inverted = "the inertia of the contacts' points";
  return function;
}

// The accelerations and forces while the contacts hold.
std::vector<Output> held_motion(DerivationContext& context, const ContactSpace& contacts) {
  const std::vector<Number> tau = context.all(InputKind::tau);
  std::vector<Number> b = bias_torques(context);
  for (std::size_t k = 0; k < b.size(); ++k) {
    b[k] = context.derivation.named(tau[k] - b[k], "b_" + context.frames.label(static_cast<int>(k)));
  }
  const ContactSpace::Solution solution = contacts.accelerations(b, contact_drift(context));
  return {
      vector_output("qdd", context.nodes(solution.motion), "joint accelerations, rad/s^2 (m/s^2 for prismatic joints)"),
      force_output(context, solution.forces)};
}

}  // namespace

Function derive_contact_jacobian(const Mechanism& mechanism, const Choices& choices) {
  return derived_at_contacts(mechanism, choices, [](DerivationContext& context) {
    std::vector<Number> positions;
    for (const Vec3& p : contact_positions(context)) positions.insert(positions.end(), p.begin(), p.end());
    const Rows J = contact_jacobian(context);
    return finished(context, {vector_output("p_c", context.nodes(positions),
                                            "position of each contact from the base frame's origin, base axes, m"),
                              matrix_output("J_c", static_cast<int>(J.size()), context.size(), context.nodes(J),
                                            at_contacts("velocities by qd", context))});
  });
}

Function derive_contact_bias(const Mechanism& mechanism, const Choices& choices) {
  return derived_at_contacts(mechanism, choices, [](DerivationContext& context) {
    return finished(context, {vector_output("b_c", context.nodes(contact_drift(context)),
                                            at_contacts("accelerations while qdd is zero", context))});
  });
}

Function derive_constrained_forward_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived_with_forces(mechanism, choices, [](DerivationContext& context) {
    const ContactSpace contacts(context);
    std::vector<Output> outputs = held_motion(context, contacts);
    outputs.push_back(condition_output(context, contacts.condition()));
    return with_contacts(context.mechanism, finished(context, std::move(outputs), contacts.conditions()));
  });
}

Function derive_held_motion_and_sensitivities(const Mechanism& mechanism, const Choices& choices) {
  return derived_with_forces(mechanism, choices, [](DerivationContext& context) {
    const ContactSpace contacts(context);
    std::vector<Output> outputs = held_motion(context, contacts);
    const ContactSpace::Sensitivities by = contacts.sensitivities();
    const int n = context.size(), rows = static_cast<int>(by.Lambda.size());
    outputs.push_back(matrix_output("P", n, n, context.nodes(by.P), "of the accelerations by torques"));
    outputs.push_back(matrix_output("Q", n, rows, context.nodes(by.Q), "of the accelerations by the drift, negative"));
    outputs.push_back(matrix_output("Lambda", rows, rows, context.nodes(by.Lambda), "of the forces by it, negative"));
    return with_contacts(context.mechanism, finished(context, std::move(outputs), contacts.conditions()));
  });
}

Function derive_contact_inverse_dynamics(const Mechanism& mechanism, const Choices& choices) {
  require_support(mechanism);
  return derived_at_contacts(mechanism, choices, contact_inverse_dynamics_at);
}

Function derive_contact_impact(const Mechanism& mechanism, const Choices& choices) {
  return derived_with_forces(mechanism, choices, [](DerivationContext& context) {
    const ContactSpace contacts(context);
    const ContactSpace::Solution solution = contacts.after_impact(context.all(InputKind::qd));
    return with_contacts(
        context.mechanism,
        finished(
            context,
            {vector_output("qd_after", context.nodes(solution.motion), "qd after the impact"),
             vector_output("impulse", context.nodes(solution.forces),
                           at_contacts(have_surfaces(context) ? "impulses (N s) and their moments (N m s) on the robot"
                                                              : "impulses (N s) on the robot",
                                       context)),
             condition_output(context, contacts.condition())},
            contacts.conditions()));
  });
}

}  // namespace flatdyn
