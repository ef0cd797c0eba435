// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/momentum_functions.hpp"

#include "derivation/dynamics/velocities.hpp"
#include "robot/model/floating_base.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The rates of all bodies' joints, the velocities of the bodies, and the momenta of composite bodies, those of spinning
// rotors included, as wrenches: N s, N m s.
struct MovingRobot {
  std::vector<Number> rates;
  std::vector<Velocity> links;
  std::vector<Wrench> momenta;
};

// P = m v + ω × m r and L = Î ω + m r × v.
Wrench own_momentum(const InertialParameters& body, const Velocity& link) {
  return {body.mass * link.v + cross(link.omega, body.first_moment),
          body.inertia * link.omega + cross(body.first_moment, link.v)};
}

void add_wrench(Wrench& sum, const Wrench& more) { sum = {sum.f + more.f, sum.mu + more.mu}; }

std::vector<Wrench> composite_momenta_of(Frames& frames, const std::vector<Number>& rates,
                                         const std::vector<Velocity>& links) {
  Derivation& d = frames.derivation();
  std::vector<Wrench> momenta;
  for (std::size_t k = 0; k < links.size(); ++k) {
    momenta.push_back(own_momentum(frames.inertia(static_cast<int>(k)), links[k]));
  }
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto& rotor = frames.body(static_cast<int>(k)).rotor;
    if (!rotor || rotor->carrier < 0) continue;
    const Vec3 spin = rates[k] * rotor_momentum(frames, static_cast<int>(k));
    add_wrench(momenta[static_cast<std::size_t>(rotor->carrier)], {zero_vector(), spin});
  }
  for (std::size_t k = links.size(); k-- > 0;) {
    const int i = static_cast<int>(k), parent = frames.body(i).parent;
    const std::string n = frames.label(i);
    momenta[k] = {d.named(momenta[k].f, "P_" + n), d.named(momenta[k].mu, "L_" + n)};
    if (parent >= 0) add_wrench(momenta[static_cast<std::size_t>(parent)], to_parent(frames, i, momenta[k], "P_" + n));
  }
  return momenta;
}

MovingRobot moving_robot(DerivationContext& context) {
  MovingRobot robot;
  robot.rates = context.joint_motion(InputKind::qd);
  robot.links = link_velocities(context.frames, robot.rates);
  robot.momenta = composite_momenta_of(context.frames, robot.rates, robot.links);
  return robot;
}

// The momenta along all bodies' joints, with those of the joints' own motors.
std::vector<Number> momenta_of_joints(Frames& frames, const MovingRobot& robot) {
  Derivation& d = frames.derivation();
  std::vector<Number> p;
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    const int i = static_cast<int>(k);
    const Body& body = frames.body(i);
    const std::string n = frames.label(i);
    Number along = joint_component(frames, i, robot.momenta[k]);
    along += d.named(reflected_inertia(body), "I_r" + n) * robot.rates[k];
    if (body.rotor && body.rotor->carrier >= 0) {
      const Velocity& carrier = robot.links[static_cast<std::size_t>(body.rotor->carrier)];
      along += dot(rotor_momentum(frames, i), carrier.omega);
    }
    p.push_back(d.named(along, "p_" + n));
  }
  return p;
}

// The last of the bodies that move one link: those of a floating base, of a spherical joint, or body i alone.
int last_body_of_motion(const Mechanism& mechanism, int i) {
  if (mechanism.is_of_base(i)) return mechanism.base_bodies() - 1;
  const int part = mechanism.bodies[static_cast<std::size_t>(i)].spherical;
  return part == 0 ? i : i + kSphericalBodies - part;
}

// The momentum P of all that a joint moves; of a floating base with that of its armature.
Vec3 linear_momentum(Frames& frames, const MovingRobot& robot, int last) {
  Vec3 P = robot.momenta[static_cast<std::size_t>(last)].f;
  if (!frames.mechanism().is_of_base(last) || !has_base_armature(frames.mechanism())) return P;
  const Number armature = frames.derivation().named(frames.body(0).armature, "I_r" + frames.label(0));
  return P + armature * robot.links[static_cast<std::size_t>(last)].v;
}

// Cᵀ q̇ along all bodies' joints.
std::vector<Number> coriolis_transpose_of_joints(Frames& frames, const MovingRobot& robot) {
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  std::vector<Number> result(robot.links.size(), 0);
  for (int i = mechanism.body_count() - 1; i >= 0;) {
    const int last = last_body_of_motion(mechanism, i);
    const auto& [omega, v] = robot.links[static_cast<std::size_t>(last)];
    const Wrench& momentum = robot.momenta[static_cast<std::size_t>(last)];
    Wrench turning = {Number(-1) * cross(omega, linear_momentum(frames, robot, last)),
                      Number(-1) * (cross(omega, momentum.mu) + cross(v, momentum.f))};
    for (; i >= 0 && last_body_of_motion(mechanism, i) == last; --i) {
      const std::string n = frames.label(i);
      if (i != last) turning = to_parent(frames, i + 1, turning, "turning_" + n);
      result[static_cast<std::size_t>(i)] = d.named(joint_component(frames, i, turning), "dT_" + n);
    }
  }
  return result;
}

// Adds d(A G)/dt ᵀ p, by which Cᵀ q̇ of the coordinates differs where closed loops let joints move along.
void add_rate_of_loops(DerivationContext& context, const std::vector<Number>& p, std::vector<Number>& result) {
  if (!context.mechanism.has_loops()) return;
  const Rows rate = joint_motion_rate(context.mechanism, context.derivation);
  for (std::size_t j = 0; j < p.size(); ++j) {
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += rate[j][k] * p[j];
  }
}

}  // namespace

Function derive_momentum(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const std::vector<Number> p = momenta_of_joints(context.frames, moving_robot(context));
    return finished(
        context, {vector_output("p", context.nodes(context.at_coordinates(p)), "generalised momenta, N m s or N s")});
  });
}

Function derive_coriolis_transpose_qd(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const MovingRobot robot = moving_robot(context);
    std::vector<Number> rates = context.at_coordinates(coriolis_transpose_of_joints(context.frames, robot));
    add_rate_of_loops(context, momenta_of_joints(context.frames, robot), rates);
    return finished(context, {vector_output("dp", context.nodes(rates),
                                            "the rates of the momenta apart from those by forces, N m or N")});
  });
}

}  // namespace flatdyn
