// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/acceleration_functions.hpp"

#include <algorithm>

#include "derivation/dynamics/accelerations.hpp"
#include "derivation/dynamics/articulated.hpp"
#include "derivation/dynamics/composite.hpp"
#include "derivation/dynamics/composite_bias.hpp"
#include "robot/model/floating_base.hpp"

namespace flatdyn {

namespace {

Function finished_accelerations(DerivationContext& context, const std::vector<Number>& qdd, Conditions conditions) {
  const std::vector<NodeId> entries = context.nodes(qdd);
  return finished(context, {vector_output("qdd", entries, "joint accelerations, rad/s^2 (m/s^2 for prismatic joints)")},
                  std::move(conditions));
}

constexpr std::size_t kSlides = 3, kOfBase = 6;

Vec3 vector_at(const std::vector<Number>& values, std::size_t first) {
  return {values[first], values[first + 1], values[first + 2]};
}

// The acceleration of a floating base: of its frame's origin, less gravity, and the angular one.
struct BaseAcceleration {
  Vec3 linear = zero_vector(), angular = zero_vector();
};

// The robot as one body of mass m with its centre at c: f + m (a + α × c) = 0 and n + m c × a + I α = 0, with f and n
// the force and moment that the base needs while it is not accelerated. Without a that is (I + m S(c)²) α = c × f - n.
class FreeBase {
 public:
  explicit FreeBase(DerivationContext& context)
      : context_(context),
        robot_(composites(context.frames)[static_cast<std::size_t>(context.mechanism.base_bodies() - 1)]),
        per_mass_(context.derivation.quotient(1, positive_mass(), "per_mass")),
        centre_(context.derivation.named(per_mass_ * robot_.first_moment, "r_G")),
        inertia_(about_centre()) {}

  BaseAcceleration solve(const Vec3& force, const Vec3& moment) const {
    Derivation& d = context_.derivation;
    const Vec3 needed = d.named(cross(centre_, force) - moment, "n_G");
    const Vec3 angular = vector_at(inertia_.solve({needed[0], needed[1], needed[2]}, "dw"), 0);
    return {d.named(cross(centre_, angular) - per_mass_ * force, "ddp_b"), angular};
  }
  Conditions conditions() const {
    const Mat3& I = robot_.inertia;
    return conditions_of_base(context_, inertia_, {I[0][0], I[1][1], I[2][2]}, kSlides);
  }

 private:
  Number positive_mass() const {
    if (vanishes(robot_.mass)) throw SingularInertia(context_.frames.body(0));
    return robot_.mass;
  }

  Factorisation about_centre() const {
    Derivation& d = context_.derivation;
    const Mat3 I = d.named_symmetric(robot_.inertia + skew(centre_) * skew(robot_.first_moment), "I_G");
    const Rows rows = {{I[0][0], I[0][1], I[0][2]}, {I[1][0], I[1][1], I[1][2]}, {I[2][0], I[2][1], I[2][2]}};
    return {d, {-1, 0, 1}, rows, "the inertia about the centre of mass", "G"};
  }

  DerivationContext& context_;
  InertialParameters robot_;
  Number per_mass_;
  Vec3 centre_;
  Factorisation inertia_;
};

// The motion of all links relative to a base that turns at its rate, and is not accelerated otherwise. All parts of the
// robot fall alike, so neither gravity nor the base's velocity has an effect on torques.
Motion motion_about_base(DerivationContext& context) {
  Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), zero_vector(), true};
  std::fill_n(motion.qd.begin(), kSlides, Number(0));
  std::fill_n(motion.qdd.begin(), kOfBase, Number(0));
  return motion;
}

// The derivatives of the base's velocities, (v̇, ω̇): v̇ = a - ω × v + g_b.
std::vector<Number> rates_of_twist(DerivationContext& context, const BaseAcceleration& base) {
  const std::vector<Number> v = context.joint_motion(InputKind::qd);
  const Vec3 fallen = base.linear + context.gravity() - cross(vector_at(v, kSlides), vector_at(v, 0));
  return {fallen[0], fallen[1], fallen[2], base.angular[0], base.angular[1], base.angular[2]};
}

// The accelerations that the base's causes at body i, from those at its parent.
BaseAcceleration carried_outwards(Frames& frames, int i, const BaseAcceleration& before) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(i);
  const Vec3 of_origin = d.named(before.linear + cross(before.angular, frames.p(i)), "ao_" + n);
  BaseAcceleration here{frames.to_child(i, of_origin, "ab_" + n), frames.to_child(i, before.angular, "alphab_" + n)};
  if (frames.body(i).prismatic) {
    here.linear = d.named(here.linear + cross(here.angular, {0, 0, frames.slide(i)}), "as_" + n);
  }
  return here;
}

// τ_j of the joints, from those while the base is not accelerated: what composite body j needs for the accelerations
// that the base's causes there, and the rotor of joint j. Zeros for the base.
std::vector<Number> torques_with(DerivationContext& context, const BaseAcceleration& base, std::vector<Number> tau) {
  Frames& frames = context.frames;
  const std::vector<InertialParameters> bodies = composites(frames);
  std::vector<BaseAcceleration> all(kOfBase, base);
  for (std::size_t j = kOfBase; j < tau.size(); ++j) {
    const int i = static_cast<int>(j);
    all.push_back(carried_outwards(frames, i, all[static_cast<std::size_t>(frames.body(i).parent)]));
  }
  std::fill_n(tau.begin(), kOfBase, Number(0));
  for (std::size_t j = kOfBase; j < tau.size(); ++j) {
    const int i = static_cast<int>(j);
    const Wrench unit = unit_wrench(frames, i, bodies[j]);
    tau[j] += dot(unit.f, all[j].linear) + dot(unit.mu, all[j].angular);
    const auto& rotor = frames.body(i).rotor;
    if (!rotor) continue;
    tau[j] += dot(rotor_momentum(frames, i), all[static_cast<std::size_t>(rotor->carrier)].angular);
  }
  return tau;
}

// The base's part of B.
Factorisation inertia_of_base(DerivationContext& context, const Rows& B) {
  Rows of_base;
  std::vector<int> chain;
  for (std::size_t i = 0; i < kOfBase; ++i) {
    of_base.emplace_back(B[i].begin(), B[i].begin() + kOfBase);
    chain.push_back(static_cast<int>(i) - 1);
  }
  return {context.derivation, chain, of_base, "the floating base's part of B", "b"};
}

// With armature or friction of the base, not all parts of the robot fall alike: its six equations are solved as they
// are, with gravity and the base's velocity.
Function floating_dynamics_with_base_joint(DerivationContext& context) {
  Motion motion{context.joint_motion(InputKind::qd), context.joint_motion(InputKind::qdd), context.gravity(), true};
  std::fill_n(motion.qdd.begin(), kOfBase, Number(0));
  std::vector<Number> tau = context.at_coordinates(torques(context.frames, motion));
  const Rows B = context.inertia();
  const Factorisation of_base = inertia_of_base(context, B);
  std::vector<Number> needed;
  for (std::size_t i = 0; i < kOfBase; ++i) needed.push_back(-tau[i]);
  const std::vector<Number> a = of_base.solve(needed, "a_b");
  std::fill_n(tau.begin(), kOfBase, Number(0));
  for (std::size_t j = kOfBase; j < tau.size(); ++j) {
    for (std::size_t k = 0; k < kOfBase; ++k) tau[j] += B[j][k] * a[k];
  }
  return finished(
      context,
      {vector_output("a_base", context.nodes(a), "derivatives of v[0..5]"), torque_output("tau", context.nodes(tau))},
      conditions_of_base(context, of_base, of_base.diagonal(), 0));
}

}  // namespace

Function derive_inverse_dynamics_floating(const Mechanism& mechanism, const Choices& choices) {
  if (has_base_joint(mechanism)) return derived(mechanism, choices, floating_dynamics_with_base_joint);
  return derived(mechanism, choices, [](DerivationContext& context) {
    const std::vector<Number> needed = torques(context.frames, motion_about_base(context));
    const FreeBase robot(context);
    const BaseAcceleration base = robot.solve(vector_at(needed, 0), vector_at(needed, kSlides));
    return finished(context,
                    {vector_output("a_base", context.nodes(rates_of_twist(context, base)), "derivatives of v[0..5]"),
                     torque_output("tau", context.nodes(context.at_coordinates(torques_with(context, base, needed))))},
                    robot.conditions());
  });
}

Function derive_forward_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    return finished_accelerations(context, accelerations(context, B), conditions_of(context, B));
  });
}

// Forward dynamics without the diagonal entries b_kk, so that pivots cannot be compared with them to detect lost ones.
std::optional<Function> derive_forward_dynamics_by_articulated_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices) {
  if (!has_articulated_form(mechanism) || choices.guard.compares) return std::nullopt;
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_drift(), context.gravity(), true};
    const std::vector<Number> tau = context.all(InputKind::tau);
    const ArticulatedSolution solution = articulated_accelerations(context.frames, motion, tau);
    return finished_accelerations(context, solution.qdd, conditions_of(context, solution.pivots));
  });
}

// The bias is computed from the composite bodies that B is made from.
std::optional<Function> derive_forward_dynamics_by_composite_bodies(const Mechanism& mechanism,
                                                                    const Choices& choices) {
  if (mechanism.has_prismatic_joint() || mechanism.has_longer_positions()) return std::nullopt;
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_drift(), context.gravity(), true};
    const std::vector<Number> bias =
        context.at_coordinates(composite_bias_torques(context.frames, motion, composites(context.frames)));
    return finished_accelerations(context, accelerations(context, B, bias), conditions_of(context, B));
  });
}

}  // namespace flatdyn
