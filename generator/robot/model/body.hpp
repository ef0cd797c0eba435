// SPDX-License-Identifier: GPL-2.0-or-later
// A moving body of the canonical mechanism with the joint that moves it, and the written links that move with it.
#pragma once

#include <optional>
#include <string>

#include "robot/model/number.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// A rotation in a plane; c^2 + s^2 = 1 exactly.
struct PlanarRotation {
  Number c = 1, s = 0;
  bool is_identity() const { return c.is_equal(1); }
};

// The inertial parameters of a body in its own frame, about the frame's origin: the first ten of (7.77).
struct InertialParameters {
  Number mass = 0;                    // m_i, kg
  Vec3 first_moment = zero_vector();  // m_i r_{i,Ci}, kg m
  Mat3 inertia = zero_matrix();       // Î_i, matrix entries (symmetric), kg m^2

  bool is_zero() const;
};

InertialParameters operator+(const InertialParameters& a, const InertialParameters& b);
// The parameters of the same body in another frame, in which the old frame has the pose (R, p).
InertialParameters transformed(const InertialParameters& a, const Mat3& R, const Vec3& p);

// The contribution of the spinning rotor of joint i beyond the augmented links, last two terms of (7.64).
struct Rotor {
  int carrier = -1;           // index of the carrying body; -1: the base
  Number gear_ratio = 0;      // k_r
  Number inertia = 0;         // I_m, kg m^2
  Vec3 axis = zero_vector();  // z_m in the frame of the carrier, unit
};

// How the dry friction of a joint depends on its rate ω: F_s (s - s_0) + E s/(1 + (ω/v_s)²) + D s², where s is sgn(ω)
// or, with a speed v_0, tanh((ω + φ)/v_0). F_s is Body::coulomb; what is 0 is not there.
struct DryFriction {
  Number speed = 0;           // v_0, rad/s or m/s
  Number offset = 0;          // φ, rad/s or m/s
  Number at_rest = 0;         // s_0 = tanh(φ/v_0)
  Number excess = 0;          // E = F_st - F_s, N m or N: what friction at rest has more
  Number stribeck_speed = 0;  // v_s, rad/s or m/s
  Number asymmetry = 0;       // D, N m or N: half of what friction forward has more than backward
  Number load = 0;            // c: the drive loses c |τ| s (derivation/dynamics/load_friction.hpp)

  bool is_smooth() const { return !vanishes(speed); }
  bool has_excess() const { return !vanishes(excess); }
  bool is_asymmetric() const { return !vanishes(asymmetry); }
  // Whether it is F_s times a function of the rate.
  bool is_linear() const { return !has_excess() && !is_asymmetric(); }
};

// Body i, moved by joint i. Its frame in frame parent: displacement p, then Rz(beta) Rx(alpha) Rz(theta + q) for a
// revolute joint; p, then Rz(beta) Rx(alpha) Rz(theta), then q along z for a prismatic one. A spherical joint is three
// bodies (robot/model/spherical_joint.hpp).
struct Body {
  std::string joint;  // the joint's name, as written
  std::string link;   // the name of the link that it moves, as written
  int parent = -1;    // -1: the base
  bool prismatic = false;
  bool continuous = false;
  PlanarRotation beta, alpha, theta;
  Vec3 p = zero_vector();      // origin of frame i (at q = 0), in frame parent, m
  InertialParameters inertia;  // the augmented link, with the rotors that it carries held still
  std::optional<Rotor> rotor;  // the rotor of the motor that drives joint i
  Number armature = 0;         // added to b_ii, kg m^2 or kg
  Number viscous = 0;          // F_v, N m s/rad or N s/m
  Number coulomb = 0;          // F_s, N m or N
  Limits limits;
  Number stiffness = 0;  // k of a spring at joint i, N m/rad or N/m
  // q_0: the spring exerts k (q_0 - q), where q is the joint's position without the constant part that a coupled one
  // has, rad or m.
  Number spring_reference = 0;
  // 1, 2, 3: the body is the first, second or last one of a spherical joint, and turns about its x, y or z. 0: not so.
  int spherical = 0;
  bool is_tendon = false;  // joint i is the length of a tendon (robot/model/tendon.hpp): the body has no inertia
  std::optional<Number> current_to_torque{};  // of the drive of joint i, N m/A or N/A
  DryFriction dry{};

  bool has_dry_friction() const { return !vanishes(coulomb) || !dry.is_linear(); }
  void leave_out_friction() {
    viscous = coulomb = 0;
    dry = {};
  }
};

// The unit of the joint's torque or force.
inline const char* torque_unit(const Body& body) { return body.prismatic ? "N" : "N m"; }

// The axes of a joint in the parent's frame, as columns: the third is the one that it turns about or slides along. For
// a prismatic joint they are its body's axes.
Mat3 joint_axes(const Body& joint);

// The constant pose of a written link in the body (or base: -1) it moves with.
struct LinkFrame {
  std::string link;
  int body = -1;
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};

// A written link with what the file fixes to it, in its own frame: its bodies, and the rotors that it carries, held
// still.
struct WrittenLink : LinkFrame {
  InertialParameters inertia;
};

// R_i^parent at q = 0, without the joint's own motion: Rz(beta) Rx(alpha) Rz(theta). For the first body of a spherical
// joint, that of the quaternion (1, 0, 0, 0).
Mat3 constant_rotation(const Body& body);

}  // namespace flatdyn
