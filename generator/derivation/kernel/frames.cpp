// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/kernel/frames.hpp"

#include <algorithm>

#include "derivation/kernel/axis_rotations.hpp"
#include "robot/model/angles.hpp"
#include "robot/model/rational_rotation.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {

namespace {

// Rz(a) T Rz(a)^T in 8 multiplications: with g = c (T_xx - T_yy) - 2 s T_xy, only c g and s g are added.
Mat3 turned_tensor_z(Derivation& d, const PlanarRotation& a, const Mat3& T, const std::string& name) {
  if (vanishes(a.s) || vanishes(a.c)) {
    const Mat3 R = {Vec3{a.c, -a.s, 0}, Vec3{a.s, a.c, 0}, Vec3{0, 0, 1}};
    return expanded(R * T * transpose(R));
  }
  const Number difference = d.named(T[0][0] - T[1][1], name + "_d");
  const Number twice = d.named(2 * T[0][1], name + "_e");
  const Number g = d.named(a.c * difference - a.s * twice, name + "_g");
  const Number cg = d.named(a.c * g, name + "_cg");
  Mat3 result;
  result[0][0] = T[1][1] + cg;
  result[1][1] = T[0][0] - cg;
  result[0][1] = result[1][0] = T[0][1] + a.s * g;
  result[0][2] = result[2][0] = a.c * T[0][2] - a.s * T[1][2];
  result[1][2] = result[2][1] = a.s * T[0][2] + a.c * T[1][2];
  result[2][2] = T[2][2];
  return result;
}

Mat3 turn_tensor_z(Derivation& d, const PlanarRotation& a, const Mat3& T, const std::string& name) {
  return d.named_symmetric(turned_tensor_z(d, a, T, name), name);
}

Mat3 turn_tensor_x(Derivation& d, const PlanarRotation& a, const Mat3& T, const std::string& name) {
  return with_axes_cycled(with_axes_cycled(turn_tensor_z(d, a, with_axes_cycled(T), name)));
}

}  // namespace

bool can_be_still(const Mechanism& mechanism, int i) {
  if (mechanism.bodies[static_cast<std::size_t>(i)].prismatic || mechanism.is_around_pose(i)) return false;
  return std::all_of(mechanism.bodies.begin(), mechanism.bodies.end(), [i](const Body& body) {
    return body.parent != i || (vanishes(body.alpha.s) && body.spherical == 0);
  });
}

Frames::Frames(const Mechanism& mechanism, Derivation& derivation, const std::vector<Axes>& axes)
    : mechanism_(mechanism), derivation_(derivation) {
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    turns_.push_back(turn_by_joint(i));
    slide_.push_back(body.prismatic ? joint_position(mechanism, derivation, i) : Number(0));
    p_.push_back(derivation.named(body.p, "p_" + label(i)));
    p_in_own_axes_.emplace_back();
    inertia_.push_back(body.inertia);
    rotor_axis_.push_back(body.rotor ? derivation.named(body.rotor->axis, "z_m" + label(i)) : zero_vector());
  }
  for (int i = 0; i < mechanism.body_count() && !axes.empty(); ++i) {
    if (axes[static_cast<std::size_t>(i)] == Axes::still && can_be_still(mechanism, i)) hold(i);
  }
}

Frames::Turn Frames::turn_by_joint(int i) {
  const Body& body = mechanism_.bodies[static_cast<std::size_t>(i)];
  const auto constant = [&](const PlanarRotation& a, const char* name) {
    return named(derivation_, a, name + label(i));
  };
  Turn turn{constant(body.beta, "beta"), constant(body.alpha, "alpha"), constant(body.theta, "theta"), ""};
  turn.constant = turn.gamma;
  if (body.spherical == 1) turn_freely(i, turn);
  if (body.prismatic || mechanism_.is_around_pose(i)) return turn;
  turn.angles = label(i);
  if (mechanism_.is_coupled()) {
    turn.multiples = angle_factors(mechanism_, i);
    turn.gamma =
        named(derivation_, rotation_by(mechanism_, derivation_, turn.multiples) * turn.constant, label(i) + "t");
    return turn;
  }
  const Number q = joint_position(mechanism_, derivation_, i);
  const PlanarRotation joint = {derivation_.cos(q, "c_" + label(i)), derivation_.sin(q, "s_" + label(i))};
  turn.gamma = named(derivation_, joint * turn.gamma, label(i) + "t");
  return turn;
}

// Sets the rotation of a spherical joint, which is that of the quaternion (robot/model/spherical_joint.hpp).
void Frames::turn_freely(int i, Turn& turn) {
  Derivation& d = derivation_;
  const std::string n = label(i);
  const int first = mechanism_.quaternion_of(i);
  const auto entry = [&](int k) { return d.input(InputKind::q, first + k); };
  const Number w = entry(0);
  const Vec3 r = {entry(1), entry(2), entry(3)};
  const Vec3 twice = d.named(Number(2) * r, "r_2_" + n);
  const auto product = [&](std::size_t a, std::size_t b) {
    return d.named(twice[a] * r[b], "r_" + n + "_" + "xyz"[a] + "xyz"[b]);
  };
  const Number xx = product(0, 0), yy = product(1, 1), zz = product(2, 2), xy = product(0, 1), xz = product(0, 2),
               yz = product(1, 2);
  const Vec3 s = d.named(w * twice, "r_" + n + "_w");
  const Mat3 R = {Vec3{1 - (yy + zz), xy - s[2], xz + s[1]}, Vec3{xy + s[2], 1 - (xx + zz), yz - s[0]},
                  Vec3{xz - s[1], yz + s[0], 1 - (xx + yy)}};
  Mat3 entries;
  for (std::size_t k = 0; k < 3; ++k) entries[k] = d.named(R[k], "R_" + n + "_" + "xyz"[k]);
  turn.free = with_columns_cycled(entries);
  const Vec3 axis = {entries[0][0], entries[1][0], entries[2][0]};
  turn.axis = d.named(rotate_z(turn.beta, rotate_x(turn.alpha, rotate_z(turn.gamma, axis))), "z_p" + n);
}

// Makes the axes of link i still, and expresses its parameters in them. The inertia is not named entry by entry, so
// that its trace stays a number.
void Frames::hold(int i) {
  const auto k = static_cast<std::size_t>(i);
  const std::string n = label(i);
  const Turn held = turns_[k];
  InertialParameters& body = inertia_[k];
  body.first_moment = derivation_.named(rotate_z(held.gamma, body.first_moment), "mr_" + n);
  body.inertia =
      turned_tensor_z(derivation_, held.gamma, derivation_.named_symmetric(body.inertia, "I_" + n), "I_t" + n);
  turns_[k].gamma = {};
  p_in_own_axes_[k].reset();
  for (int other = 0; other < mechanism_.body_count(); ++other) {
    const Body& each = mechanism_.bodies[static_cast<std::size_t>(other)];
    if (each.parent == i) pass_to_child(held, other);
    if (!each.rotor || each.rotor->carrier != i) continue;
    Vec3& axis = rotor_axis_[static_cast<std::size_t>(other)];
    axis = derivation_.named(rotate_z(held.gamma, axis), "z_m" + label(other));
  }
}

// Transfers the angle of a link with still axes to a child with a parallel axis: Rz(held) Rz(beta) Rx(alpha) Rz(gamma),
// alpha = 0 or pi, is Rx(alpha) followed by a rotation by the sum of all these angles, in which the first ones change
// sign if alpha = pi.
void Frames::pass_to_child(const Turn& held, int child) {
  const auto k = static_cast<std::size_t>(child);
  Turn& turn = turns_[k];
  const Vec3 in_own_axes =
      rotate_z(inverse(turn.gamma), rotate_x(inverse(turn.alpha), rotate_z(inverse(turn.beta), p_[k])));
  p_in_own_axes_[k] = derivation_.named(in_own_axes, "p_own_" + label(child));
  p_[k] = derivation_.named(rotate_z(held.gamma, p_[k]), "p_" + label(child));
  if (mechanism_.is_coupled()) return pass_multiples_to_child(held, child);
  const std::string before = held.angles + "_b" + label(child);
  PlanarRotation first = named(derivation_, held.gamma * turn.beta, before);
  if (turn.alpha.c.is_equal(-1)) first = inverse(first);
  turn.angles = held.angles + (turn.angles.empty() ? "" : "_" + turn.angles);
  turn.gamma = named(derivation_, first * turn.gamma, turn.angles);
  turn.beta = {};
}

// The same for coupled joints: the multiples of coordinates are added up first, as some may cancel.
void Frames::pass_multiples_to_child(const Turn& held, int child) {
  Turn& turn = turns_[static_cast<std::size_t>(child)];
  const bool flips = turn.alpha.c.is_equal(-1);
  PlanarRotation constant = held.constant * turn.beta;
  if (flips) constant = inverse(constant);
  turn.constant = constant * turn.constant;
  turn.multiples.resize(held.multiples.size(), 0);  // a prismatic joint has none
  for (std::size_t k = 0; k < held.multiples.size(); ++k) {
    turn.multiples[k] += flips ? -held.multiples[k] : held.multiples[k];
  }
  turn.angles = held.angles + "_" + label(child);
  turn.gamma = named(derivation_, rotation_by(mechanism_, derivation_, turn.multiples) * turn.constant, turn.angles);
  turn.beta = {};
}

Vec3 Frames::to_child(int i, const Vec3& v, const std::string& name) {
  if (turn_of(i).free) return down_to_axis(i, v, name);
  return derivation_.named(rotate_z(inverse(turn_of(i).gamma), down_to_axis(i, v, name)), name);
}

Vec3 Frames::to_parent(int i, const Vec3& v, const std::string& name) {
  return up_from_axis(i, up_to_axis(i, v, name), name);
}

Vec3 Frames::down_to_axis(int i, const Vec3& v, const std::string& name) {
  const Vec3 a = derivation_.named(rotate_z(inverse(turn_of(i).beta), v), name + "_b");
  const Vec3 b = derivation_.named(rotate_x(inverse(turn_of(i).alpha), a), name + "_a");
  if (!turn_of(i).free) return b;
  const Vec3 before = derivation_.named(rotate_z(inverse(turn_of(i).gamma), b), name + "_j");
  return derivation_.named(transpose(*turn_of(i).free) * before, name);
}

Vec3 Frames::up_to_axis(int i, const Vec3& v, const std::string& name) {
  if (turn_of(i).free) return v;
  return derivation_.named(rotate_z(turn_of(i).gamma, v), name + "_t");
}

Vec3 Frames::up_from_axis(int i, const Vec3& vector, const std::string& name) {
  Vec3 v = vector;
  if (turn_of(i).free) {
    v = derivation_.named(*turn_of(i).free * v, name + "_j");
    v = derivation_.named(rotate_z(turn_of(i).gamma, v), name + "_t");
  }
  const Vec3 b = derivation_.named(rotate_x(turn_of(i).alpha, v), name + "_a");
  return derivation_.named(rotate_z(turn_of(i).beta, b), name);
}

// Rotates the columns, then the rows.
Mat3 Frames::down_to_axis(int i, const Mat3& tensor, const std::string& name) {
  static const char* const kAxes[] = {"_x", "_y", "_z"};
  Mat3 half, result;
  const Mat3 columns = transpose(tensor);
  for (std::size_t k = 0; k < 3; ++k) half[k] = down_to_axis(i, columns[k], name + kAxes[k] + "h");
  const Mat3 rows = transpose(half);
  for (std::size_t k = 0; k < 3; ++k) result[k] = down_to_axis(i, rows[k], name + kAxes[k]);
  return result;
}

// R T Rᵀ of a symmetric tensor: what T has beyond T_zz 1 is rotated, and the trace stays.
Mat3 Frames::turned_freely(const Mat3& R, const Mat3& T, const std::string& name) {
  static const char* const kAxes[] = {"_x", "_y", "_z"};
  Mat3 rest = T, half, result;
  for (std::size_t k = 0; k < 3; ++k) rest[k][k] = derivation_.named(T[k][k] - T[2][2], name + kAxes[k] + "d");
  for (std::size_t k = 0; k < 3; ++k) half[k] = derivation_.named(rest * R[k], name + kAxes[k] + "h");
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) result[a][b] = result[b][a] = dot(R[a], half[b]);
  }
  const Number xx = derivation_.named(result[0][0], name + "_xxr"), yy = derivation_.named(result[1][1], name + "_yyr");
  result[0][0] = xx + T[2][2];
  result[1][1] = yy + T[2][2];
  result[2][2] = rest[0][0] + rest[1][1] + T[2][2] - xx - yy;
  return derivation_.named_symmetric(result, name);
}

Mat3 Frames::up_to_axis(int i, const Mat3& tensor, const std::string& name) {
  if (turn_of(i).free) return tensor;
  return turn_tensor_z(derivation_, turn_of(i).gamma, tensor, name + "_t");
}

Mat3 Frames::to_parent(int i, const Mat3& tensor, const std::string& name) {
  const Turn& turn = turn_of(i);
  Mat3 a = up_to_axis(i, tensor, name);
  if (turn.free)
    a = turn_tensor_z(derivation_, turn.gamma, turned_freely(*turn.free, tensor, name + "_j"), name + "_t");
  const Mat3 b = turn_tensor_x(derivation_, turn.alpha, a, name + "_a");
  return turn_tensor_z(derivation_, turn.beta, b, name);
}

Vec3 Frames::axis_in_parent(int i) const {
  const Turn& turn = turn_of(i);
  return turn.free ? turn.axis : rotate_z(turn.beta, rotate_x(turn.alpha, {0, 0, 1}));
}

}  // namespace flatdyn
