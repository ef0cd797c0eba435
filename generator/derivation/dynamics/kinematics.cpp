// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/kinematics.hpp"

#include "derivation/dynamics/coordinates.hpp"
#include "derivation/dynamics/velocities.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// A free vector of body `body` in base axes.
Vec3 to_base(Frames& frames, int body, Vec3 v, const std::string& name) {
  for (int i = body; i >= 0; i = frames.body(i).parent) v = frames.to_parent(i, v, name + "_" + frames.label(i));
  return v;
}

// A point of body `body` in the base frame.
Vec3 point_in_base(Frames& frames, int body, Vec3 r, const std::string& name) {
  Derivation& d = frames.derivation();
  for (int i = body; i >= 0; i = frames.body(i).parent) {
    const std::string n = name + "_" + frames.label(i);
    r = d.named(r + Vec3{0, 0, frames.slide(i)}, n + "s");
    r = d.named(frames.to_parent(i, r, n + "u") + frames.p(i), n);
  }
  return r;
}

Vec3 column(const Mat3& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j]}; }

}  // namespace

SymbolicPose pose(Frames& frames, const LinkFrame& link) {
  Mat3 columns;
  for (std::size_t j = 0; j < 3; ++j) {
    static const char* const kNames[] = {"n", "s", "a"};  // normal, sliding, approach
    columns[j] = to_base(frames, link.body, column(link.R, j), kNames[j]);
  }
  return {transpose(columns), position(frames, link)};
}

std::vector<SymbolicPose> link_poses(Frames& frames) {
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  std::vector<SymbolicPose> bodies;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const int parent = frames.body(i).parent;
    const SymbolicPose before = parent < 0 ? SymbolicPose{} : bodies[static_cast<std::size_t>(parent)];
    const std::string n = frames.label(i);
    SymbolicPose here;
    const Vec3 along = before.R * frames.p(i) + frames.slide(i) * (before.R * frames.axis_in_parent(i));
    here.p = d.named(before.p + along, "p_" + n);
    for (std::size_t k = 0; k < 3; ++k) here.R[k] = frames.to_child(i, before.R[k], "R_" + n + std::to_string(k));
    bodies.push_back(here);
  }
  std::vector<SymbolicPose> links;
  for (const LinkFrame& link : mechanism.links) {
    const SymbolicPose body = link.body < 0 ? SymbolicPose{} : bodies[static_cast<std::size_t>(link.body)];
    links.push_back({body.R * link.R, body.p + body.R * link.p});
  }
  return links;
}

Vec3 position(Frames& frames, const LinkFrame& link) { return point_in_base(frames, link.body, link.p, "p"); }

std::vector<JacobianColumn> jacobian(Frames& frames, const LinkFrame& link) {
  Derivation& d = frames.derivation();
  std::vector<JacobianColumn> columns(static_cast<std::size_t>(frames.mechanism().body_count()));
  const Vec3 p_e = position(frames, link);
  // Goes from the base outwards: two columns of each frame's rotation are needed to place the next axis and origin.
  SymbolicPose here;
  for (const int i : path_to(frames.mechanism(), link.body)) {
    const std::string n = frames.label(i);
    const bool is_spherical = frames.body(i).spherical > 0;
    const Vec3 z = is_spherical ? zero_vector() : d.named(here.R * frames.axis_in_parent(i), "z_" + n);
    const Vec3 origin = d.named(here.p + here.R * frames.p(i) + frames.slide(i) * z, "p_" + n);
    JacobianColumn& J = columns[static_cast<std::size_t>(i)];
    const auto turning_about = [&](const Vec3& axis) {
      const Vec3 lever = d.named(p_e - origin, "r_" + n);
      return JacobianColumn{d.named(cross(axis, lever), "J_P" + n), axis};
    };
    if (frames.body(i).prismatic) {
      J.linear = z;
    } else if (!is_spherical) {
      J = turning_about(z);
    }
    Mat3 rows;  // rows of R_i: each is a row of R_(i-1) expressed in frame i
    for (std::size_t k = 0; k < 3; ++k) rows[k] = frames.to_child(i, here.R[k], "R_" + n + std::to_string(k));
    if (is_spherical) J = turning_about(column(rows, 2));
    here = {rows, origin};
  }
  return columns;
}

namespace {

// ω̇ of a body from the joints' own q̇ ω × z, and from their accelerations. It is not taken from U, where it is added to
// ω², which may be far larger.
Vec3 angular_acceleration(Frames& frames, int body, const std::vector<LinkMotion>& links, const Motion& motion) {
  Derivation& d = frames.derivation();
  Vec3 domega = zero_vector();
  for (const int i : path_to(frames.mechanism(), body)) {
    const auto k = static_cast<std::size_t>(i);
    domega = frames.to_child(i, domega, "domega_f_" + frames.label(i));
    if (frames.mechanism().is_of_base(i)) {
      domega = links[k].domega;  // not given before the base link
      continue;
    }
    if (frames.body(i).prismatic) continue;
    if (const int part = frames.body(i).spherical; part > 0) {
      if (part < kSphericalBodies) continue;
      const Vec3 w = {motion.qd[k - 2], motion.qd[k - 1], motion.qd[k]},
                 dw = {motion.qdd[k - 2], motion.qdd[k - 1], motion.qdd[k]};
      domega = d.named(domega + dw + cross(links[k].omega, w), "domega_q_" + frames.label(i));
      continue;
    }
    const Number& qd = motion.qd[k];
    const Vec3 carried = {qd * links[k].omega[1], -qd * links[k].omega[0], motion.qdd[k]};
    domega = d.named(domega + carried, "domega_q_" + frames.label(i));
  }
  return domega;
}

JacobianColumn acceleration_by(Frames& frames, const LinkFrame& link, const Motion& motion) {
  if (link.body < 0) return {};
  Derivation& d = frames.derivation();
  const std::vector<LinkMotion> links = link_motions(frames, motion);
  const LinkMotion& body = links[static_cast<std::size_t>(link.body)];
  const Vec3 ddp = d.named(body.ddp + body.U * link.p, "ddp_e");
  return {to_base(frames, link.body, ddp, "a"),
          to_base(frames, link.body, angular_acceleration(frames, link.body, links, motion), "domega_e")};
}

}  // namespace

JacobianColumn frame_velocity(Frames& frames, const LinkFrame& link) {
  if (link.body < 0) return {};
  Derivation& d = frames.derivation();
  const auto [omega, v] =
      link_velocities(frames, joint_motion(frames.mechanism(), d, InputKind::qd))[static_cast<std::size_t>(link.body)];
  const Vec3 of_origin = d.named(v + cross(omega, d.named(link.p, "p_e")), "v_e");
  return {to_base(frames, link.body, of_origin, "v"), to_base(frames, link.body, omega, "omega_e")};
}

JacobianColumn frame_acceleration(Frames& frames, const LinkFrame& link) {
  const std::vector<Number> qd = joint_motion(frames.mechanism(), frames.derivation(), InputKind::qd),
                            qdd = joint_motion(frames.mechanism(), frames.derivation(), InputKind::qdd);
  return acceleration_by(frames, link, {qd, qdd, zero_vector(), false});
}

JacobianColumn jacobian_dot_qd(Frames& frames, const LinkFrame& link) {
  const std::vector<Number> qd = joint_motion(frames.mechanism(), frames.derivation(), InputKind::qd),
                            drift = joint_drift(frames.mechanism(), frames.derivation(), InputKind::qd);
  return acceleration_by(frames, link, {qd, drift, zero_vector(), false});
}

Wrench wrench_on_body(Frames& frames, const LinkFrame& link, const Wrench& wrench) {
  if (link.body < 0) return {};
  Wrench local = wrench;
  for (const int i : path_to(frames.mechanism(), link.body)) {
    local = {frames.to_child(i, local.f, "f_e" + frames.label(i)),
             frames.to_child(i, local.mu, "mu_e" + frames.label(i))};
  }
  return {local.f, local.mu + cross(frames.derivation().named(link.p, "p_e"), local.f)};
}

}  // namespace flatdyn
