// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/body_motion.hpp"

#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

bool is_same(const Vec3& a, const Vec3& b) { return a[0].is_equal(b[0]) && a[1].is_equal(b[1]) && a[2].is_equal(b[2]); }

Number polarised(const Number& a, const Number& b, const Number& a_r, const Number& b_r) {
  if (a.is_equal(a_r) && b.is_equal(b_r)) return a * b;
  return (a * b_r + a_r * b) / 2;
}

// The half of a × b_r + a_r × b, which is a × b if there is one rate.
Vec3 polarised_cross(const Vec3& a, const Vec3& b, const Vec3& a_r, const Vec3& b_r) {
  Vec3 result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    result[k] = polarised(a[i], b[j], a_r[i], b_r[j]) - polarised(a[j], b[i], a_r[j], b_r[i]);
  }
  return result;
}

// ½ ω × ω_r: in the coordinates of a turn that have the angular velocity ω at zero, ω̇ is ω̇_r and this.
Vec3 half_bracket(const Vec3& omega, const Vec3& omega_r) {
  if (is_same(omega, omega_r)) return zero_vector();
  return Number(1) / 2 * cross(omega, omega_r);
}

Vec3 three(const std::vector<Number>& entries, std::size_t first) {
  return {entries[first], entries[first + 1], entries[first + 2]};
}

Mat3 products_of(Derivation& d, const BodyMotion& body, const std::string& n) {
  Mat3 products;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      products[a][b] = polarised(body.omega[a], body.omega[b], body.omega_r[a], body.omega_r[b]);
      products[b][a] = products[a][b];
    }
  }
  return d.named_symmetric(products, "omega_" + n);
}

Mat3 acceleration_matrix(Derivation& d, const Mat3& products, const Vec3& domega, const std::string& n) {
  static const char* const kAxes[] = {"x", "y", "z"};
  const Number square = products[0][0] + products[1][1] + products[2][2];
  const Mat3 turn = skew(domega);
  Mat3 U;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      const Number entry = turn[a][b] + products[a][b] - (a == b ? square : Number(0));
      U[a][b] = d.named(entry, "U_" + n + "_" + kAxes[a] + kAxes[b]);
    }
  }
  return U;
}

BodyMotion moved(Frames& frames, int i, const BodyMotion& parent, const JointMotion& motion) {
  Derivation& d = frames.derivation();
  const auto k = static_cast<std::size_t>(i);
  const std::string n = frames.label(i);
  const bool prismatic = frames.mechanism().bodies[k].prismatic;
  BodyMotion body;
  const bool one_rate = is_same(parent.omega, parent.omega_r);
  body.omega = frames.to_child(i, parent.omega, "omega_f_" + n);
  body.omega_r = one_rate ? body.omega : frames.to_child(i, parent.omega_r, "omega_r_" + n);
  const Vec3 domega = frames.to_child(i, parent.domega, "domega_f_" + n);
  const Vec3 carried = rate_times_omega(motion, i, body.omega, body.omega_r);
  const Vec3 turned = prismatic ? zero_vector() : Vec3{carried[1], -carried[0], motion.qdd_r[k]};  // q̇ ω × z + q̈ z
  body.domega = d.named(domega + turned, "domega_" + n);
  if (!prismatic) {
    body.omega = d.named(body.omega + Vec3{0, 0, motion.qd[k]}, "omega_" + n);
    body.omega_r = d.named(body.omega_r + Vec3{0, 0, motion.qd_r[k]}, "omega_r_" + n);
  }
  body.products = products_of(d, body, n);
  body.U = acceleration_matrix(d, body.products, body.domega, n);
  const Vec3 at_origin = d.named(parent.ddp + parent.U * frames.p(i), "ddp_o_" + n);
  body.ddp = frames.to_child(i, at_origin, "ddp_" + n);
  if (prismatic) {
    const Number q = frames.slide(i);
    const Vec3 along = {body.U[0][2] * q + 2 * carried[1], body.U[1][2] * q - 2 * carried[0],
                        body.U[2][2] * q + motion.qdd_r[k]};  // 2 q̇ ω × z + q̈ z
    body.ddp = d.named(body.ddp + along, "ddp_s_" + n);
  }
  return body;
}

// The motion of the link that a spherical joint moves, past the joint's three bodies: ω = Rᵀ ω_parent + w and
// ω̇ = Rᵀ ω̇_parent + ẇ + Rᵀ ω_parent × w, for two rates as bilinear forms.
BodyMotion moved_by_spherical(Frames& frames, int last, const BodyMotion& parent, const JointMotion& motion) {
  Derivation& d = frames.derivation();
  const int first = last + 1 - kSphericalBodies;
  const auto k = static_cast<std::size_t>(first);
  const std::string n = frames.label(last);
  const auto in_link = [&](Vec3 v, const std::string& name) {
    for (int i = first; i <= last; ++i) v = frames.to_child(i, v, name);
    return v;
  };
  const Vec3 w = three(motion.qd, k), w_r = three(motion.qd_r, k), dw = three(motion.qdd_r, k);
  const Vec3 carried = in_link(parent.omega, "omega_f_" + n);
  const bool one_rate = is_same(parent.omega, parent.omega_r);
  const Vec3 carried_r = one_rate ? carried : in_link(parent.omega_r, "omega_fr_" + n);
  BodyMotion body;
  body.omega = d.named(carried + w, "omega_" + n);
  body.omega_r = d.named(carried_r + w_r, "omega_r_" + n);
  const Vec3 turned = polarised_cross(carried, w, carried_r, w_r) + half_bracket(w, w_r);
  body.domega = d.named(in_link(parent.domega, "domega_f_" + n) + dw + turned, "domega_" + n);
  body.products = products_of(d, body, n);
  body.U = acceleration_matrix(d, body.products, body.domega, n);
  body.ddp = in_link(d.named(parent.ddp + parent.U * frames.p(first), "ddp_o_" + n), "ddp_" + n);
  return body;
}

// The motion of the link of a floating base. Its origin's acceleration is v̇ + ω × v, as v̇ has the derivatives of
// components in axes that turn; for two rates, v̇_r + ω × v_r.
BodyMotion motion_of_floating_base(Frames& frames, const JointMotion& motion) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(frames.mechanism().base_bodies() - 1);
  BodyMotion base;
  base.omega = three(motion.qd, 3);
  base.omega_r = three(motion.qd_r, 3);
  base.domega = d.named(three(motion.qdd_r, 3) + half_bracket(base.omega, base.omega_r), "domega_" + n);
  base.ddp = d.named(three(motion.qdd_r, 0) + cross(base.omega, three(motion.qd_r, 0)) - motion.gravity, "ddp_" + n);
  base.products = products_of(d, base, n);
  base.U = acceleration_matrix(d, base.products, base.domega, n);
  return base;
}

}  // namespace

Vec3 rate_times_omega(const JointMotion& motion, int i, const Vec3& omega, const Vec3& omega_r) {
  const auto k = static_cast<std::size_t>(i);
  Vec3 result;
  for (std::size_t a = 0; a < 3; ++a) result[a] = polarised(motion.qd[k], omega[a], motion.qd_r[k], omega_r[a]);
  return result;
}

std::vector<BodyMotion> body_motions(Frames& frames, const JointMotion& motion) {
  BodyMotion base;
  base.ddp = frames.derivation().named(Number(-1) * motion.gravity, "ddp_0");  // so that gravity acts on every body
  std::vector<BodyMotion> bodies(static_cast<std::size_t>(frames.mechanism().base_bodies()));
  if (frames.mechanism().floating_base) bodies.back() = motion_of_floating_base(frames, motion);
  for (int i = frames.mechanism().base_bodies(); i < frames.mechanism().body_count(); ++i) {
    const int parent = parent_of_joint(frames.mechanism(), i), part = frames.body(i).spherical;
    const BodyMotion& before = parent < 0 ? base : bodies[static_cast<std::size_t>(parent)];
    bodies.push_back(is_inside_joint(frames.body(i)) ? BodyMotion{}
                     : part > 0                      ? moved_by_spherical(frames, i, before, motion)
                                                     : moved(frames, i, before, motion));
  }
  return bodies;
}

}  // namespace flatdyn
