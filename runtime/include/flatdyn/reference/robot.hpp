// SPDX-License-Identifier: BSD-3-Clause
// The robot as written, for the numeric reference: links are not merged, frames not moved, fixed joints kept.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace flatdyn::reference {

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;
template <class S>
using VectorX = Eigen::Matrix<S, Eigen::Dynamic, 1>;
template <class S>
using MatrixX = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

// A rigid body fixed to a link, such as a still rotor.
template <class S>
struct Inertial {
  S mass = S(0);                            // kg
  Vector3<S> r_C = Vector3<S>::Zero();      // centre of mass, link frame, m
  Matrix3<S> inertia = Matrix3<S>::Zero();  // about the centre of mass, link axes, kg m^2
};

template <class S>
struct Link {
  std::vector<Inertial<S>> inertials;
};

// A rotor that turns at k_r q̇ about z_m relative to the link that carries it, (7.23).
template <class S>
struct Rotor {
  int carrier = 0;                        // link
  S gear_ratio = S(1);                    // k_r
  S inertia = S(0);                       // I_m, kg m^2
  Vector3<S> axis = Vector3<S>::UnitZ();  // z_m, carrier's frame, unit
};

enum class JointType { fixed, revolute, prismatic, spherical };

// How the dry friction of a joint depends on its rate v: F_s (s - s_0) + E s/(1 + (v/v_s)²) + D s², where s is sgn(v)
// or, with a speed v_0, tanh((v + φ)/v_0), and s_0 is tanh(φ/v_0).
template <class S>
struct DryFriction {
  S speed = S(0);           // v_0; 0: a sign
  S offset = S(0);          // φ
  S excess = S(0);          // E
  S stribeck_speed = S(0);  // v_s; 0: no excess
  S asymmetry = S(0);       // D
  S load = S(0);            // c, the share of its torque that the drive loses
};

// A joint. The child frame in the parent frame is (R_0, p_0) · motion(axis, q) · (R_1, p_1). A spherical joint turns by
// its orientation; it has three entries of q̇, the angular velocity of the child relative to the parent, along the axes
// that the frame has after turning, and three of q̈ and τ. Three zeros stand for its position among those of the joints.
template <class S>
struct Joint {
  JointType type = JointType::fixed;
  int parent = 0, child = 0;  // links
  int index = -1;             // among the moving joints, after a floating base's six; -1 for a fixed joint
  Matrix3<S> R_0 = Matrix3<S>::Identity(), R_1 = Matrix3<S>::Identity();
  Vector3<S> p_0 = Vector3<S>::Zero(), p_1 = Vector3<S>::Zero();
  Vector3<S> axis = Vector3<S>::UnitZ();  // in the joint frame (after R_0), unit
  S viscous = S(0), coulomb = S(0), armature = S(0);
  Rotor<S> rotor;       // inertia 0: none
  S stiffness = S(0);   // k of a spring, N m/rad or N/m
  S spring_q_0 = S(0);  // the joint's position where the spring exerts nothing, less a coupled one's constant part
  Matrix3<S> orientation = Matrix3<S>::Identity();  // of a spherical joint
  DryFriction<S> dry = {};

  // The number of its entries of q̇.
  int size() const { return index < 0 ? 0 : type == JointType::spherical ? 3 : 1; }
};

// A closed loop, cut where a point of one link meets a point of another. The displacement between them is measured
// along the columns of `axes`, which are fixed to a link with which the whole loop moves.
template <class S>
struct Loop {
  int links[2] = {0, 0};
  Vector3<S> points[2] = {Vector3<S>::Zero(), Vector3<S>::Zero()};  // in the links' frames, m
  int carrier = 0;                                                  // link
  Matrix3<S> axes = Matrix3<S>::Identity();                         // in the carrier's frame
  // Where axes meet as well: two directions across the first link's, and the second's axis, unit, in the links' frames.
  Vector3<S> across[2] = {Vector3<S>::Zero(), Vector3<S>::Zero()};
  Vector3<S> axis = Vector3<S>::Zero();
  std::vector<int> rows;       // the components, 0 to 4, that joints change
  std::vector<int> dependent;  // indices into q, one per row
};

// A point of a link, or the link with it, that touches something which does not move.
template <class S>
struct Contact {
  int link = 0;
  Vector3<S> point = Vector3<S>::Zero();  // in the link's frame, m
  bool is_surface = false;                // whether the link cannot turn, either
  // Conditions of friction, row · (force, moment) <= 0, in axes of the contact: the link's or, where its normal is
  // against gravity, those of axes_against_gravity().
  std::vector<std::array<S, 6>> cone = {};
  bool is_against_gravity = false;

  int rows() const { return is_surface ? 6 : 3; }
};

template <class S>
struct Robot {
  std::vector<Link<S>> links;
  std::vector<Joint<S>> joints;  // a link's own joint comes before those on it
  int root = 0;
  Vector3<S> gravity = Vector3<S>(S(0), S(0), S(-9.81));  // g_0, base frame, m/s^2
  int tip = 0;                                            // link
  Matrix3<S> R_tip = Matrix3<S>::Identity();              // tip frame in the tip link
  Vector3<S> p_tip = Vector3<S>::Zero();
  // For coupled joints, the positions of the moving joints are coupling · q; constants are part of R_0 and p_0. Empty
  // if the positions are q.
  MatrixX<S> coupling;
  // The loops, in the order in which they find their dependent joints. With loops, q̇, q̈ and τ are those of the
  // independent entries of q.
  std::vector<Loop<S>> loops;
  std::vector<int> independent;
  // Whether the root link moves freely. The first six entries of q̇, q̈ and τ are then its twist (velocity of its origin,
  // angular velocity), the derivatives of these components, and the force and moment about its origin, all in its axes;
  // joints have indices from 6 on. "The base frame" is the root's, and gravity is given in its axes.
  bool floating_base = false;
  // Added to the floating base's entries: the armature times the acceleration of the root's origin for an observer at
  // rest and the derivative of its angular velocity, both without gravity; viscous friction times its twist; Coulomb
  // friction against the turns about its axes.
  S base_armature = S(0), base_viscous = S(0), base_coulomb = S(0);
  std::vector<Contact<S>> contacts;
  S contact_damping = S(0);  // λ of J B^-1 Jᵀ + λ² 1

  int base_size() const { return floating_base ? 6 : 0; }
  int joint_count() const {
    int n = 0;
    for (const Joint<S>& joint : joints) n += joint.size();
    return n;
  }
  // The length of q.
  int position_count() const { return coupling.size() > 0 ? static_cast<int>(coupling.cols()) : joint_count(); }
  // The length of q̇.
  int size() const { return base_size() + (loops.empty() ? position_count() : static_cast<int>(independent.size())); }
};

template <class S>
bool has_spherical_joints(const Robot<S>& robot) {
  for (const Joint<S>& joint : robot.joints) {
    if (joint.type == JointType::spherical) return true;
  }
  return false;
}

// Values of the moving joints by those of the coordinates, without a floating base's; stored in `room` if joints are
// coupled.
template <class S>
const VectorX<S>& of_joints(const Robot<S>& robot, const VectorX<S>& q, VectorX<S>& room) {
  if (robot.coupling.size() == 0) return q;
  room = robot.coupling.lazyProduct(q);
  return room;
}

// A matrix of the joints, extended by the identity block of a floating base.
template <class S>
MatrixX<S> beside_base(const Robot<S>& robot, const MatrixX<S>& of_joints) {
  if (!robot.floating_base) return of_joints;
  const Eigen::Index base = robot.base_size();
  MatrixX<S> A = MatrixX<S>::Zero(base + of_joints.rows(), base + of_joints.cols());
  A.topLeftCorner(base, base).setIdentity();
  A.bottomRightCorner(of_joints.rows(), of_joints.cols()) = of_joints;
  return A;
}

// The rates of the moving joints, after a floating base's, by the entries of q̇, without loops. Only of coupled joints.
template <class S>
MatrixX<S> rate_coupling(const Robot<S>& robot) {
  return beside_base(robot, robot.coupling);
}

// The positions of the moving joints by their indices; stored in `room` if joints are coupled or the base floats.
template <class S>
const VectorX<S>& positions_of_joints(const Robot<S>& robot, const VectorX<S>& q, VectorX<S>& room) {
  if (!robot.floating_base) return of_joints(robot, q, room);
  VectorX<S> coupled;
  const VectorX<S>& joints = of_joints(robot, q, coupled);
  room = VectorX<S>::Zero(robot.base_size() + joints.size());
  room.tail(joints.size()) = joints;
  return room;
}

// The rotation by an angle about a unit axis (Rodrigues).
template <class S>
Matrix3<S> rotation_about(const Vector3<S>& u, const S& angle) {
  using std::cos;
  using std::sin;
  const S c = cos(angle), s = sin(angle);
  Matrix3<S> K;
  K << S(0), -u.z(), u.y(), u.z(), S(0), -u.x(), -u.y(), u.x(), S(0);
  return Matrix3<S>::Identity() + s * K + (S(1) - c) * (K * K);
}

// The rotation of a unit quaternion (w, x, y, z): 1 + 2 w S(r) + 2 S(r)², r = (x, y, z).
template <class S>
Matrix3<S> rotation_of_quaternion(const S& w, const Vector3<S>& r) {
  Matrix3<S> K;
  K << S(0), -r.z(), r.y(), r.z(), S(0), -r.x(), -r.y(), r.x(), S(0);
  return Matrix3<S>::Identity() + S(2) * w * K + S(2) * (K * K);
}

// A state in which the orientations of spherical joints are those of the robot and not of q, and such a robot. q, with
// a quaternion (w, x, y, z) of any length for each spherical joint, becomes positions of all moving joints, in order.
// Without spherical joints, q stays; with them, no joints may be coupled.
template <class S>
void take_orientations(Robot<S>& robot, VectorX<S>& q) {
  if (!has_spherical_joints(robot)) return;
  VectorX<S> positions = VectorX<S>::Zero(robot.joint_count());
  Eigen::Index entry = 0;
  for (Joint<S>& joint : robot.joints) {
    if (joint.index < 0) continue;
    if (joint.type == JointType::spherical) {
      const Eigen::Matrix<S, 4, 1> unit = q.template segment<4>(entry).normalized();
      joint.orientation = rotation_of_quaternion<S>(unit[0], unit.template tail<3>());
      entry += 4;
    } else {
      positions[joint.index - robot.base_size()] = q[entry++];
    }
  }
  q = positions;
}

// The placement of a joint at position q: the rotation of the child frame in the parent frame, the joint's axis in
// parent and child axes, and two displacements: the first, including that of a prismatic joint, in parent axes, the
// second in child axes.
template <class S>
struct JointPlacement {
  Matrix3<S> R;
  Vector3<S> z_parent, z_child, before, after;
};

template <class S>
JointPlacement<S> placement(const Joint<S>& joint, const S& q) {
  const bool turns = joint.type == JointType::revolute;
  Matrix3<S> turned = turns ? Matrix3<S>(joint.R_0 * rotation_about(joint.axis, q)) : joint.R_0;
  if (joint.type == JointType::spherical) turned = Matrix3<S>(turned * joint.orientation);
  JointPlacement<S> place;
  place.R = turned * joint.R_1;
  place.z_parent = joint.R_0 * joint.axis;
  place.z_child = joint.R_1.transpose() * joint.axis;
  place.before = joint.p_0;
  if (joint.type == JointType::prismatic) place.before += q * place.z_parent;
  place.after = joint.R_1.transpose() * joint.p_1;
  return place;
}

}  // namespace flatdyn::reference
