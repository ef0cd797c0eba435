// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/body_motion.hpp"

namespace flatdyn {
namespace {

bool is_same(const Vec3& a, const Vec3& b) { return a[0].is_equal(b[0]) && a[1].is_equal(b[1]) && a[2].is_equal(b[2]); }

Number polarised(const Number& a, const Number& b, const Number& a_r, const Number& b_r) {
  if (a.is_equal(a_r) && b.is_equal(b_r)) return a * b;
  return (a * b_r + a_r * b) / 2;
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

// U and ω̇, of which the column U z and ω̇_z are known.
void complete_motion(Derivation& d, BodyMotion& body, const Vec3& U_z, const Number& domega_z, const std::string& n) {
  const Mat3& W = body.products;
  const auto entry = [&](const Number& value, const char* axes) { return d.named(value, "U_" + n + "_" + axes); };
  body.domega = d.named(Vec3{W[1][2] - U_z[1], U_z[0] - W[0][2], domega_z}, "domega_" + n);
  const Number difference = d.named(W[0][0] - W[2][2], "omega_" + n + "_xx_zz");
  body.U = {Vec3{entry(U_z[2] + difference, "xx"), entry(W[0][1] - domega_z, "xy"), U_z[0]},
            Vec3{entry(W[0][1] + domega_z, "yx"), entry(-W[0][0] - W[2][2], "yy"), U_z[1]},
            Vec3{entry(W[0][2] - body.domega[1], "zx"), entry(W[1][2] + body.domega[0], "zy"), U_z[2]}};
}

// Points of the joint's axis are accelerated alike as parts of either body: U z is that of the parent.
BodyMotion moved(Frames& frames, int i, const BodyMotion& parent, const JointMotion& motion) {
  Derivation& d = frames.derivation();
  const auto k = static_cast<std::size_t>(i);
  const std::string n = label(i);
  const bool prismatic = frames.mechanism().bodies[k].prismatic;
  BodyMotion body;
  const bool one_rate = is_same(parent.omega, parent.omega_r);
  body.omega = frames.down(i, parent.omega, "omega_f_" + n);
  body.omega_r = one_rate ? body.omega : frames.down(i, parent.omega_r, "omega_r_" + n);
  const Vec3 z = frames.axis_in_parent(i);
  const Vec3 U_z = frames.down(i, d.named(parent.U * z, "Uz_o_" + n), "Uz_" + n);
  Number domega_z = d.named(dot(z, parent.domega), "domega_f_" + n + "_z");
  if (!prismatic) {
    body.omega = d.named(body.omega + Vec3{0, 0, motion.qd[k]}, "omega_" + n);
    body.omega_r = d.named(body.omega_r + Vec3{0, 0, motion.qd_r[k]}, "omega_r_" + n);
    domega_z = d.named(domega_z + motion.qdd_r[k], "domega_" + n + "_z");
  }
  body.products = products_of(d, body, n);
  complete_motion(d, body, U_z, domega_z, n);
  const Vec3 at_origin = d.named(parent.ddp + parent.U * frames.p(i), "ddp_o_" + n);
  body.ddp = frames.down(i, at_origin, "ddp_" + n);
  if (prismatic) {
    const Vec3 carried = rate_times_omega(motion, i, body.omega, body.omega_r);
    const Vec3 coriolis = {2 * carried[1], -2 * carried[0], motion.qdd_r[k]};  // 2 q̇ ω × z + q̈ z
    body.ddp = d.named(body.ddp + frames.slide(i) * U_z + coriolis, "ddp_s_" + n);
  }
  return body;
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
  std::vector<BodyMotion> bodies;
  for (int i = 0; i < frames.mechanism().size(); ++i) {
    const int parent = frames.mechanism().bodies[static_cast<std::size_t>(i)].parent;
    bodies.push_back(moved(frames, i, parent < 0 ? base : bodies[static_cast<std::size_t>(parent)], motion));
  }
  return bodies;
}

}  // namespace flatdyn
