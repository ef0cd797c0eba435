// SPDX-License-Identifier: GPL-2.0-or-later
// The recursive Newton–Euler algorithm of 7.5 in symbols, in link frames, (7.107)–(7.114), with inertias about the
// frames' origins instead of the centres of mass.
#pragma once

#include <optional>

#include "derivation/kernel/frames.hpp"

namespace flatdyn {

// The input of the recursion. Zero entries do not appear in the result.
struct Motion {
  std::vector<Number> qd, qdd;
  Vec3 gravity = zero_vector();  // g_0, base frame
  bool passive = true;           // whether friction and springs of the joints act
};

// Gravity in the base frame: g_0, or the input g_b if the base floats, m/s².
Vec3 gravity_of(const Mechanism& mechanism, Derivation& derivation);

// ω_i, ω̇_i and p̈_i - g_0 of every body, in its own frame; U_i = S(ω̇_i) + S(ω_i)².
struct LinkMotion {
  Vec3 omega = zero_vector();   // rad/s
  Vec3 domega = zero_vector();  // rad/s^2
  Vec3 ddp = zero_vector();     // acceleration of the frame's origin less g_0, m/s^2
  Mat3 U = zero_matrix();       // 1/s^2
  // For a body that a spherical joint moves: Rᵀ ω and Rᵀ ω̇ of its parent, in its own frame.
  Vec3 omega_r = zero_vector(), domega_r = zero_vector();
};
// The motions of all bodies, from the base outwards. Bodies that are the motion of a floating base all move with the
// base's full twist; of those before the base link only ω is given. Of the bodies of a spherical joint, none of which
// but the last has inertia, only the last one's motion is given.
std::vector<LinkMotion> link_motions(Frames& frames, const Motion& motion);

// The motion of a fixed base: it is accelerated so that gravity acts on all bodies.
LinkMotion base_motion(Frames& frames, const Motion& motion);

// A force and its moment about the origin of a body's frame, in that frame.
struct Wrench {
  Vec3 f = zero_vector();   // N
  Vec3 mu = zero_vector();  // N m
};

// The wrench that gives a body its motion, about the frame's origin. `n`: the label in names.
Wrench inertial_wrench(Derivation& d, const InertialParameters& body, const LinkMotion& link, const std::string& n);

// The wrench f_i, μ_i on each body through its joint, (7.112), (7.113), in its own frame. `tip`: the wrench that the
// tip exerts on the environment, on the tip's body.
std::vector<Wrench> joint_wrenches(Frames& frames, const Motion& motion, const std::vector<LinkMotion>& links,
                                   const std::optional<Wrench>& tip = std::nullopt);

// The generalised forces τ, (7.114).
std::vector<Number> torques(Frames& frames, const Motion& motion, const std::optional<Wrench>& tip = std::nullopt);

// The reactions of spinning rotors on the bodies that carry them, in the bodies' frames.
std::vector<Wrench> rotor_reactions(Frames& frames, const Motion& motion, const std::vector<LinkMotion>& links);

// q - q_0: how far joint i is from where its spring exerts nothing, rad or m.
Number spring_stretch(Frames& frames, int i);

// k (q - q_0) of the spring at joint i, N m or N; 0 if it has none.
Number spring_torque(Frames& frames, int i);

// The acceleration that the own inertia of joint i has: q̈_i, and of a floating base's slides that of its origin, whose
// derivatives of components v̇ lack ω × v.
Number own_acceleration(Frames& frames, int i, const Motion& motion);

// τ_i, (7.114), from the wrench on body i through its joint, with motor, friction and spring.
Number joint_torque(Frames& frames, int i, const Wrench& wrench, const std::vector<LinkMotion>& links,
                    const Motion& motion);

// k_r I_m z_m: the angular momentum of joint i's rotor for a unit rate, in the frame of the body that carries it. The
// joint must have a rotor.
Vec3 rotor_momentum(Frames& frames, int i);

// The inertia of a joint's own motor at the joint: the armature, and k_r^2 I_m of the rotor.
Number reflected_inertia(const Body& body);

// The component of a wrench along joint i: its torque or force.
Number joint_component(Frames& frames, int i, const Wrench& wrench);

// A wrench on body i, given about its frame's origin, in the frame of its parent about the parent's origin.
Wrench to_parent(Frames& frames, int i, const Wrench& wrench, const std::string& name);

}  // namespace flatdyn
