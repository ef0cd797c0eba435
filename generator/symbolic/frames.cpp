// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/frames.hpp"

#include "symbolic/turns.hpp"

namespace flatdyn {

std::string label(int i) { return std::to_string(i + 1); }

Frames::Frames(const Mechanism& mechanism, Derivation& derivation) : mechanism_(mechanism), derivation_(derivation) {
  for (int i = 0; i < mechanism.size(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    const auto constant = [&](const PlanarRotation& a, const std::string& name) {
      return PlanarRotation{derivation.named(a.c, "c_" + name + label(i)),
                            derivation.named(a.s, "s_" + name + label(i))};
    };
    Turn turn{constant(body.beta, "beta"), constant(body.alpha, "alpha"), constant(body.theta, "theta")};
    const Number q = derivation.input(InputKind::q, i);
    if (!body.prismatic) {
      const Number c = derivation.cos(q, "c_" + label(i)), s = derivation.sin(q, "s_" + label(i));
      const PlanarRotation theta = turn.gamma;
      turn.gamma = {derivation.named(c * theta.c - s * theta.s, "c_" + label(i) + "t"),
                    derivation.named(s * theta.c + c * theta.s, "s_" + label(i) + "t")};
    }
    turns_.push_back(turn);
    slide_.push_back(body.prismatic ? q : Number(0));
    p_.push_back(derivation.named(body.p, "p_" + label(i)));
  }
}

namespace {

// Rz(a) T Rz(a)^T in 8 multiplications: with g = c (T_xx - T_yy) - 2 s T_xy, only c g and s g are added.
Mat3 turn_tensor_z(Derivation& d, const PlanarRotation& a, const Mat3& T, const std::string& name) {
  if (vanishes(a.s) || vanishes(a.c)) {
    const Mat3 R = {Vec3{a.c, -a.s, 0}, Vec3{a.s, a.c, 0}, Vec3{0, 0, 1}};
    return d.named_symmetric(R * T * transpose(R), name);
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
  return d.named_symmetric(result, name);
}

Mat3 turn_tensor_x(Derivation& d, const PlanarRotation& a, const Mat3& T, const std::string& name) {
  return cycled(cycled(turn_tensor_z(d, a, cycled(T), name)));
}

}  // namespace

Vec3 Frames::down(int i, const Vec3& v, const std::string& name) {
  return derivation_.named(turn_z(back(turn_of(i).gamma), down_to_axis(i, v, name)), name);
}

Vec3 Frames::up(int i, const Vec3& v, const std::string& name) { return up_from_axis(i, up_to_axis(i, v, name), name); }

Vec3 Frames::down_to_axis(int i, const Vec3& v, const std::string& name) {
  const Vec3 a = derivation_.named(turn_z(back(turn_of(i).beta), v), name + "_b");
  return derivation_.named(turn_x(back(turn_of(i).alpha), a), name + "_a");
}

Vec3 Frames::up_to_axis(int i, const Vec3& v, const std::string& name) {
  return derivation_.named(turn_z(turn_of(i).gamma, v), name + "_t");
}

Vec3 Frames::up_from_axis(int i, const Vec3& v, const std::string& name) {
  const Vec3 b = derivation_.named(turn_x(turn_of(i).alpha, v), name + "_a");
  return derivation_.named(turn_z(turn_of(i).beta, b), name);
}

Mat3 Frames::up(int i, const Mat3& tensor, const std::string& name) {
  const Turn& turn = turn_of(i);
  const Mat3 a = turn_tensor_z(derivation_, turn.gamma, tensor, name + "_t");
  const Mat3 b = turn_tensor_x(derivation_, turn.alpha, a, name + "_a");
  return turn_tensor_z(derivation_, turn.beta, b, name);
}

Vec3 Frames::axis_in_parent(int i) const {
  const Turn& turn = turn_of(i);
  return turn_z(turn.beta, turn_x(turn.alpha, {0, 0, 1}));
}

}  // namespace flatdyn
