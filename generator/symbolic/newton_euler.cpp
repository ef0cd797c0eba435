// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/newton_euler.hpp"

namespace flatdyn {
namespace {

// U = S(ω̇) + S(ω)², its products of ω named once each.
Mat3 acceleration_matrix(Derivation& d, const Vec3& omega, const Vec3& domega, const std::string& i) {
  const Number xx = d.named(omega[0] * omega[0], "omega_" + i + "_xx"),
               yy = d.named(omega[1] * omega[1], "omega_" + i + "_yy"),
               zz = d.named(omega[2] * omega[2], "omega_" + i + "_zz"),
               xy = d.named(omega[0] * omega[1], "omega_" + i + "_xy"),
               xz = d.named(omega[0] * omega[2], "omega_" + i + "_xz"),
               yz = d.named(omega[1] * omega[2], "omega_" + i + "_yz");
  const auto entry = [&](const Number& value, const char* name) { return d.named(value, "U_" + i + "_" + name); };
  return {Vec3{entry(-yy - zz, "xx"), entry(xy - domega[2], "xy"), entry(xz + domega[1], "xz")},
          Vec3{entry(xy + domega[2], "yx"), entry(-xx - zz, "yy"), entry(yz - domega[0], "yz")},
          Vec3{entry(xz - domega[1], "zx"), entry(yz + domega[0], "zy"), entry(-xx - yy, "zz")}};
}

LinkMotion moved(Frames& frames, int i, const LinkMotion& parent, const Motion& motion) {
  Derivation& d = frames.derivation();
  const auto k = static_cast<std::size_t>(i);
  const std::string n = label(i);
  const Number &qd = motion.qd[k], &qdd = motion.qdd[k];
  const Vec3 omega_r = frames.down(i, parent.omega, "omega_r_" + n);
  const Vec3 domega_r = frames.down(i, parent.domega, "domega_r_" + n);
  const Vec3 ddp_o = d.named(parent.ddp + parent.U * frames.p(i), "ddp_o_" + n);
  LinkMotion link;
  link.ddp = frames.down(i, ddp_o, "ddp_" + n);
  if (frames.body(i).prismatic) {
    link.omega = omega_r;
    link.domega = domega_r;
    link.U = acceleration_matrix(d, link.omega, link.domega, n);
    const Vec3 along = {link.U[0][2] * frames.slide(i), link.U[1][2] * frames.slide(i), link.U[2][2] * frames.slide(i)};
    const Number twice = d.named(2 * qd, "qd_2_" + n);
    const Vec3 coriolis = {twice * omega_r[1], -twice * omega_r[0], qdd};  // 2 q̇ ω × z + q̈ z
    link.ddp = d.named(link.ddp + along + coriolis, "ddp_s_" + n);
    return link;
  }
  link.omega = d.named(omega_r + Vec3{0, 0, qd}, "omega_" + n);
  link.domega = d.named(domega_r + Vec3{qd * omega_r[1], -qd * omega_r[0], qdd}, "domega_" + n);
  link.U = acceleration_matrix(d, link.omega, link.domega, n);
  return link;
}

// The part of Î ω̇ + ω × Î ω that comes from the diagonal of Î. With the pseudo-inertia Σ = (tr Î / 2) 1 - Î it is a sum
// of entries of U, shorter where Σ_zz has been regrouped away; otherwise products of ω serve.
Vec3 diagonal_moment(Derivation& d, const Mat3& I, const LinkMotion& link, const std::string& n) {
  const Mat3& U = link.U;
  const Vec3 &w = link.omega, &dw = link.domega;
  const Number half_trace = ((I[0][0] + I[1][1] + I[2][2]) / 2).expand();
  if (vanishes(half_trace - I[2][2])) {
    const Number sx = half_trace - I[0][0], sy = half_trace - I[1][1];
    return {U[2][1] * sy, -U[2][0] * sx, U[1][0] * sx - U[0][1] * sy};
  }
  const auto product = [&](std::size_t a, std::size_t b) {
    return d.named(w[a] * w[b], "omega_" + n + "_" + std::to_string(a) + std::to_string(b));
  };
  return {I[0][0] * dw[0] + (I[2][2] - I[1][1]) * product(1, 2), I[1][1] * dw[1] + (I[0][0] - I[2][2]) * product(0, 2),
          I[2][2] * dw[2] + (I[1][1] - I[0][0]) * product(0, 1)};
}

// The part of Î ω̇ + ω × Î ω that comes from the products of inertia.
Vec3 product_moment(Derivation& d, const Mat3& I, const LinkMotion& link, const std::string& n) {
  static const char* const kAxes[] = {"x", "y", "z"};
  const Mat3& U = link.U;
  const auto difference = [&](std::size_t a, std::size_t b) {
    return d.named(U[b][b] - U[a][a], "U_" + n + "_" + kAxes[b] + kAxes[b] + "_" + kAxes[a] + kAxes[a]);
  };
  const Number &xy = I[0][1], &xz = I[0][2], &yz = I[1][2];
  return {difference(2, 1) * yz - U[2][0] * xy + U[1][0] * xz, difference(0, 2) * xz - U[0][1] * yz + U[2][1] * xy,
          difference(1, 0) * xy - U[1][2] * xz + U[0][2] * yz};
}

Wrench inertial_wrench(Frames& frames, int i, const LinkMotion& link) {
  Derivation& d = frames.derivation();
  const InertialParameters& body = frames.body(i).inertia;
  const std::string n = label(i);
  const Vec3 h = d.named(body.first_moment, "mr_" + n);
  const Number m = d.named(body.mass, "m_" + n);
  const Mat3 I = d.named_symmetric(body.inertia, "I_" + n);
  const Vec3 F = d.named(m * link.ddp + link.U * h, "F_" + n);
  return {F, d.named(diagonal_moment(d, I, link, n) + product_moment(d, I, link, n) + cross(h, link.ddp), "N_" + n)};
}

// What the spinning rotor of joint i does to the link that carries it, last two terms of (7.105).
Vec3 rotor_reaction(Frames& frames, int i, const LinkMotion& carrier, const Motion& motion) {
  Derivation& d = frames.derivation();
  const Rotor& rotor = *frames.body(i).rotor;
  const auto k = static_cast<std::size_t>(i);
  const Number krI = d.named(rotor.gear_ratio * rotor.inertia, "kI_" + label(i));
  const Number spin = d.named(krI * motion.qdd[k], "kIqdd_" + label(i));
  const Number momentum = d.named(krI * motion.qd[k], "kIqd_" + label(i));
  const Vec3 z = d.named(rotor.axis, "z_m" + label(i));
  return spin * z + momentum * cross(carrier.omega, z);
}

Number joint_torque(Frames& frames, int i, const Wrench& wrench, const std::vector<LinkMotion>& links,
                    const Motion& motion) {
  Derivation& d = frames.derivation();
  const Body& body = frames.body(i);
  const auto k = static_cast<std::size_t>(i);
  const std::string n = label(i);
  Number tau = felt(frames, i, wrench);
  if (body.rotor && body.rotor->carrier >= 0) {
    const Rotor& rotor = *body.rotor;
    const Number krI = d.named(rotor.gear_ratio * rotor.inertia, "kI_" + n);
    const Vec3 z = d.named(rotor.axis, "z_m" + n);
    tau += krI * d.named(dot(z, links[static_cast<std::size_t>(rotor.carrier)].domega), "domega_m" + n);
  }
  tau += d.named(reflected_inertia(body), "I_r" + n) * motion.qdd[k];
  if (motion.friction) {
    tau += d.named(body.viscous, "F_v" + n) * motion.qd[k];
    if (!vanishes(body.coulomb)) tau += d.named(body.coulomb, "F_s" + n) * d.sign(motion.qd[k], "sgn_" + n);
  }
  return d.named(tau, "tau_" + n);
}

}  // namespace

std::vector<Number> inputs(Derivation& derivation, InputKind kind, int size) {
  std::vector<Number> result;
  for (int i = 0; i < size; ++i) result.push_back(derivation.input(kind, i));
  return result;
}

std::vector<LinkMotion> link_motions(Frames& frames, const Motion& motion) {
  Derivation& d = frames.derivation();
  LinkMotion base;
  base.ddp = d.named(Number(-1) * motion.gravity, "ddp_0");  // so that gravity acts on every link
  std::vector<LinkMotion> links;
  for (int i = 0; i < frames.mechanism().size(); ++i) {
    const int parent = frames.body(i).parent;
    const LinkMotion before = parent < 0 ? base : links[static_cast<std::size_t>(parent)];
    links.push_back(moved(frames, i, before, motion));
  }
  return links;
}

Wrench to_parent(Frames& frames, int i, const Wrench& wrench, const std::string& name) {
  Derivation& d = frames.derivation();
  const Number q = frames.slide(i);  // lever along z of frame i, for a prismatic joint
  const Vec3 mu = d.named(wrench.mu + Vec3{-q * wrench.f[1], q * wrench.f[0], 0}, "mu_s_" + name);
  const Vec3 f = frames.up(i, wrench.f, "f_u_" + name);
  const Vec3 turned = frames.up(i, mu, "mu_u_" + name);
  return {f, turned + cross(frames.p(i), f)};
}

Vec3 rotor_momentum(Frames& frames, int i) {
  Derivation& d = frames.derivation();
  const Rotor& rotor = *frames.body(i).rotor;
  return d.named(rotor.gear_ratio * rotor.inertia, "kI_" + label(i)) * d.named(rotor.axis, "z_m" + label(i));
}

Number reflected_inertia(const Body& body) {
  Number inertia = body.armature;
  if (body.rotor) inertia += body.rotor->gear_ratio * body.rotor->gear_ratio * body.rotor->inertia;
  return inertia;
}

Number felt(Frames& frames, int i, const Wrench& wrench) {
  return frames.body(i).prismatic ? wrench.f[2] : wrench.mu[2];
}

std::vector<Wrench> joint_wrenches(Frames& frames, const Motion& motion, const std::vector<LinkMotion>& links,
                                   const std::optional<Wrench>& tip) {
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  std::vector<Wrench> wrenches;
  for (int i = 0; i < mechanism.size(); ++i) {
    wrenches.push_back(inertial_wrench(frames, i, links[static_cast<std::size_t>(i)]));
  }
  for (int i = 0; i < mechanism.size(); ++i) {
    const auto& rotor = frames.body(i).rotor;
    if (!rotor || rotor->carrier < 0) continue;
    const auto carrier = static_cast<std::size_t>(rotor->carrier);
    wrenches[carrier].mu = wrenches[carrier].mu + rotor_reaction(frames, i, links[carrier], motion);
  }
  if (tip && mechanism.tip.body >= 0) {
    Wrench& at_tip = wrenches[static_cast<std::size_t>(mechanism.tip.body)];
    at_tip = {at_tip.f + tip->f, at_tip.mu + tip->mu};
  }
  for (std::size_t i = wrenches.size(); i-- > 0;) {
    const std::string name = label(static_cast<int>(i));
    wrenches[i] = {d.named(wrenches[i].f, "f_" + name), d.named(wrenches[i].mu, "mu_" + name)};
    const int parent = mechanism.bodies[i].parent;
    if (parent < 0) continue;
    const Wrench carried = to_parent(frames, static_cast<int>(i), wrenches[i], name);
    Wrench& at_parent = wrenches[static_cast<std::size_t>(parent)];
    at_parent = {at_parent.f + carried.f, at_parent.mu + carried.mu};
  }
  return wrenches;
}

std::vector<Number> torques(Frames& frames, const Motion& motion, const std::optional<Wrench>& tip) {
  const std::vector<LinkMotion> links = link_motions(frames, motion);
  const std::vector<Wrench> wrenches = joint_wrenches(frames, motion, links, tip);
  std::vector<Number> tau;
  for (std::size_t i = 0; i < links.size(); ++i) {
    tau.push_back(joint_torque(frames, static_cast<int>(i), wrenches[i], links, motion));
  }
  return tau;
}

}  // namespace flatdyn
