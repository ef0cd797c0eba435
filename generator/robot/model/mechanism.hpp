// SPDX-License-Identifier: GPL-2.0-or-later
// The canonical mechanism: a tree of moving bodies in exact numbers. Fixed joints are merged, every joint axis is z of
// its body's frame, constant rotations are exactly orthonormal (rational), and rotors are part of the link that carries
// them (augmented links, 7.2.2). Frames follow the modified DH convention as far as the geometry allows.
#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <vector>

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

// A point of a body, or a frame, that touches something which does not move. `frame` has the axes of the link.
struct Contact {
  std::string name;
  LinkFrame frame;
  bool is_surface = false;  // whether the body cannot turn, either

  // The directions that it holds: velocities along x, y, z of the base frame, and for a surface rotations about them.
  int rows() const { return is_surface ? 6 : 3; }
};

// A multiple of an entry of q by which joints turn.
struct CoordinateMultiple {
  int position = 0;
  Number factor = 1;  // positive
};

// A closed loop that is not a linear coupling, cut where two points, and perhaps two axes, meet. Its constraint is
// Φ(q) = 0, where Φ has those of these components that the joints change: 0 to 2 are the displacement from the first
// point to the second, in the frame of the carrier; 3 and 4 are the cosines between the second end's axis and two
// directions across the first end's.
struct LoopClosure {
  static constexpr std::size_t kOfPoints = 3;
  struct End {
    int body = -1;  // -1: the base
    Vec3 p = zero_vector();
  };
  End ends[2];
  int carrier = -1;               // the body nearest to the ends that moves both of them; -1: the base
  Mat3 axes = identity_matrix();  // the axes of components 0 to 2, as columns, in the carrier's frame
  int components = kOfPoints;     // 5 if axes meet as well
  // e_1 and e_2 in the first end's body, which with its axis e_1 × e_2 are a frame; a in the second end's body, unit.
  Vec3 across[2] = {zero_vector(), zero_vector()};
  Vec3 axis = zero_vector();
  int sense = 0;                  // whether a is e_1 × e_2 (1) or its opposite (-1) as assembled; 0: not known
  std::vector<std::size_t> rows;  // the components that the joints change, in their order
  std::vector<int> dependent;     // entries of q that follow from the others; as many as rows

  // Whether its joints do not by themselves keep its axes parallel.
  bool aligns_axes() const { return !rows.empty() && rows.back() >= kOfPoints; }
};

class JointRange;

struct Mechanism {
  std::string name;
  std::vector<Body> bodies;        // parents before children
  std::vector<WrittenLink> links;  // every written link, in file order
  LinkFrame tip;                   // the frame of the tip
  Task task;                       // the scene's task; no rows: the independent rows of the tip's Jacobian
  Vec3 gravity = zero_vector();    // g_0 in the base frame, m/s^2
  InertialParameters base;         // bodies fixed to the base (only the potential energy's constant depends on them)
  std::vector<FreeSymbol> symbols;
  std::vector<std::string> merged;  // names of links that fixed joints have merged into another

  // With coupled joints: the position of body i's joint is Σ_k coupling[i][k] q_k plus a constant that is part of the
  // frames. q_k belongs to the joint of body coordinates[k]. All are empty where q_i is the position of joint i. Rows
  // of a floating base are zero.
  std::vector<int> coordinates;
  Rows coupling;
  std::vector<Number> offsets;  // the constant part of each body's joint position, rad or m
  // Multiples of coordinates whose sines and cosines are needed, too: a joint turns by them, and they are not small
  // whole ones.
  std::vector<CoordinateMultiple> angles;

  // With closed loops: q has the positions of all joints that are not coupled; q̇, q̈ and τ are those of the
  // independent ones among them, after those of a floating base. Loops are in an order in which each finds all
  // positions that it depends on. The mechanism counts as coupled.
  std::vector<LoopClosure> loops;
  std::vector<int> independent;  // entries of q; empty: all

  // With a floating base, bodies 0 to 5 are its motion, and the last of them is the base link
  // (robot/model/floating_base.hpp). q has no entries of theirs; the first six of q̇, q̈ and τ are the base's.
  bool floating_base = false;

  // The first of the three bodies of each spherical joint (robot/model/spherical_joint.hpp), in order. q has four
  // entries of such a joint, q̇, q̈ and τ have three.
  std::vector<int> spherical;

  // The scene's contacts, and λ of the matrix J B^-1 J^T + λ² 1 that their forces are found with.
  std::vector<Contact> contacts;
  Rational contact_damping = 0;

  // The rows of all contacts' Jacobian.
  int contact_rows() const;
  // The bodies, and the entries of q̇, that are the motion of a floating base.
  int base_bodies() const { return floating_base ? 6 : 0; }
  bool is_of_base(int body) const { return body < base_bodies(); }
  bool is_of_spherical(int body) const { return bodies[static_cast<std::size_t>(body)].spherical > 0; }
  // Whether the coordinate of a body's joint is one around the present pose, where it is zero: q has no such entry.
  bool is_around_pose(int body) const { return is_of_base(body) || is_of_spherical(body); }
  // The first entries of q of all spherical joints' quaternions.
  std::vector<int> quaternions() const;
  bool has_spherical_joints() const { return !spherical.empty(); }
  // Whether q̇ are velocities that are not all the derivatives of q: v and a are arguments instead of q̇ and q̈.
  bool has_quasi_velocities() const { return floating_base || has_spherical_joints(); }
  // Whether torques depend on gravity in the axes of a floating base.
  bool has_base_gravity() const;
  // Entries of q.
  int position_count() const {
    if (is_coupled()) return static_cast<int>(coordinates.size());
    return body_count() - base_bodies() + static_cast<int>(spherical.size());
  }
  int angle_count() const { return position_count() + static_cast<int>(angles.size()); }
  // The number of entries of q̇, q̈ and τ.
  int size() const {
    if (has_loops()) return base_bodies() + static_cast<int>(independent.size());
    return is_coupled() ? base_bodies() + position_count() : body_count();
  }
  int body_count() const { return static_cast<int>(bodies.size()); }
  bool is_coupled() const { return !coupling.empty(); }
  // The rate of each body's joint by the entries of q̇, where loops do not decide it: `coupling`, after the columns of a
  // floating base. Only of coupled joints.
  Rows rate_coupling() const;
  bool has_loops() const { return !loops.empty(); }
  // The joints that the entries of q̇ belong to, in order, without the motion of a floating base.
  JointRange joints() const;
  // The entry of q that is integrated from entry k of q̇, which must not be the base's. For those of a spherical joint,
  // x, y and z of its quaternion, one for each.
  int position_of(int k) const {
    const int joint = k - base_bodies();
    return has_loops() ? independent[static_cast<std::size_t>(joint)] : joint + spherical_up_to(k);
  }
  // The body of an entry of q; for w of a quaternion, the first one of the spherical joint.
  int body_at(int position) const {
    return is_coupled() ? coordinates[static_cast<std::size_t>(position)] : body_of_position(position);
  }
  // The name of an entry of q: of the joint, or "JOINT.qw" to "JOINT.qz" for a spherical one.
  std::string position_name(int position) const;
  // The first entry of q of the spherical joint of which body i is one.
  int quaternion_of(int i) const {
    const int first = i + 1 - bodies[static_cast<std::size_t>(i)].spherical;
    return position_of(first) - 1;
  }
  // Whether an entry of q is one of a quaternion, the first of the four that are from `first` on.
  bool is_of_quaternion(int position) const { return !is_coupled() && is_of_spherical(body_at(position)); }
  int body_of(int k) const { return k < base_bodies() ? k : body_at(position_of(k)); }
  const Body& joint_at(int position) const { return bodies[static_cast<std::size_t>(body_at(position))]; }
  const Body& joint(int k) const { return bodies[static_cast<std::size_t>(body_of(k))]; }
  // The bodies that joints of one axis move, which may have springs.
  std::vector<int> bodies_on_one_axis() const;
  bool has_springs() const;
  bool has_prismatic_joint() const;  // not counting the motion of a floating base
  // Whether entries of q or q̇ are lengths, so that the unit of length is not free.
  bool has_lengths() const { return floating_base || has_prismatic_joint(); }

 private:
  // How many spherical joints have their first body at k or before it.
  int spherical_up_to(int k) const;
  int body_of_position(int position) const;
};

class JointRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Body;
    using difference_type = std::ptrdiff_t;
    using pointer = const Body*;
    using reference = const Body&;

    Iterator(const Mechanism& mechanism, int k) : mechanism_(&mechanism), k_(k) {}
    const Body& operator*() const { return mechanism_->joint(k_); }
    Iterator& operator++() {
      ++k_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return k_ == other.k_; }

   private:
    const Mechanism* mechanism_;
    int k_;
  };

  explicit JointRange(const Mechanism& mechanism) : mechanism_(mechanism) {}
  Iterator begin() const { return {mechanism_, mechanism_.base_bodies()}; }
  Iterator end() const { return {mechanism_, mechanism_.size()}; }
  std::size_t size() const { return static_cast<std::size_t>(mechanism_.size() - mechanism_.base_bodies()); }
  const Body& operator[](std::size_t k) const {
    return mechanism_.joint(static_cast<int>(k) + mechanism_.base_bodies());
  }

 private:
  const Mechanism& mechanism_;
};

inline JointRange Mechanism::joints() const { return JointRange(*this); }

// The bodies on the path from body `from` (-1: the base), which is left out, outwards to `body`, which is the last.
// `from` must be on the path from the base.
std::vector<int> path_to(const Mechanism& mechanism, int body, int from = -1);

// R_i^parent at q = 0, without the joint's own motion: Rz(beta) Rx(alpha) Rz(theta). For the first body of a spherical
// joint, that of the quaternion (1, 0, 0, 0).
Mat3 constant_rotation(const Body& body);

// Robot → Mechanism. Throws Failure(unsupported) for a robot that cannot be made canonical.
Mechanism make_mechanism(const Robot& robot);

}  // namespace flatdyn
