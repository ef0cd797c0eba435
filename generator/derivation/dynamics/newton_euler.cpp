// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/newton_euler.hpp"

#include "derivation/dynamics/dry_friction.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// Quantities that a body shares with its parent: points on the joint's axis have the same acceleration as parts of
// either, so U_i z = U_parent z. In axes of frame i: that column, and ω and ω̇_z of the parent's body.
struct AxisMotion {
  Vec3 omega = zero_vector(), U_z = zero_vector();
  Number domega_z = 0;
};

AxisMotion axis_motion(Frames& frames, int i, const LinkMotion& parent) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(i);
  const Vec3 z = frames.axis_in_parent(i);
  const Vec3 column = d.named(parent.U * z, "Uz_o_" + n);
  return {frames.to_child(i, parent.omega, "omega_r_" + n), frames.to_child(i, column, "Uz_" + n),
          d.named(dot(z, parent.domega), "domega_r_" + n + "_z")};
}

// Computes U = S(ω̇) + S(ω)² and ω̇ from the column U z and ω̇_z.
void complete_motion(Derivation& d, LinkMotion& link, const Vec3& U_z, const Number& domega_z, const std::string& i) {
  const auto square = [&](std::size_t a, std::size_t b, const char* name) {
    return d.named(link.omega[a] * link.omega[b], "omega_" + i + name);
  };
  const Number xx = square(0, 0, "_xx"), zz = square(2, 2, "_zz"), xy = square(0, 1, "_xy"), xz = square(0, 2, "_xz"),
               yz = square(1, 2, "_yz");
  const auto entry = [&](const Number& value, const char* name) { return d.named(value, "U_" + i + "_" + name); };
  link.domega = d.named(Vec3{yz - U_z[1], U_z[0] - xz, domega_z}, "domega_" + i);
  const Number difference = d.named(xx - zz, "omega_" + i + "_xx_zz");
  link.U = {Vec3{entry(U_z[2] + difference, "xx"), entry(xy - domega_z, "xy"), U_z[0]},
            Vec3{entry(xy + domega_z, "yx"), entry(-xx - zz, "yy"), U_z[1]},
            Vec3{entry(xz - link.domega[1], "zx"), entry(yz + link.domega[0], "zy"), U_z[2]}};
}

LinkMotion link_motion(Frames& frames, int i, const LinkMotion& parent, const Motion& motion) {
  Derivation& d = frames.derivation();
  const auto k = static_cast<std::size_t>(i);
  const std::string n = frames.label(i);
  const bool prismatic = frames.body(i).prismatic;
  const Number &qd = motion.qd[k], &qdd = motion.qdd[k];
  const AxisMotion axis = axis_motion(frames, i, parent);
  LinkMotion link;
  link.omega = prismatic ? axis.omega : d.named(axis.omega + Vec3{0, 0, qd}, "omega_" + n);
  complete_motion(d, link, axis.U_z, prismatic ? axis.domega_z : d.named(axis.domega_z + qdd, "domega_" + n + "_z"), n);
  const Vec3 ddp_o = d.named(parent.ddp + parent.U * frames.p(i), "ddp_o_" + n);
  link.ddp = frames.to_child(i, ddp_o, "ddp_" + n);
  if (prismatic) {
    const Number twice = d.named(2 * qd, "qd_2_" + n);
    const Vec3 coriolis = {twice * link.omega[1], -twice * link.omega[0], qdd};  // 2 q̇ ω × z + q̈ z
    link.ddp = d.named(link.ddp + frames.slide(i) * axis.U_z + coriolis, "ddp_s_" + n);
  }
  return link;
}

// The part of Î ω̇ + ω × Î ω that comes from the diagonal of Î. With the pseudo-inertia Σ = (tr Î / 2) 1 - Î it is a
// sum of entries of U, shorter where Σ_zz has been regrouped away; otherwise products of ω are used.
Vec3 diagonal_moment(Derivation& d, const Mat3& I, const LinkMotion& link, const std::string& n) {
  const Mat3& U = link.U;
  const Vec3 &w = link.omega, &dw = link.domega;
  const Number half_trace = ((I[0][0] + I[1][1] + I[2][2]) / 2).expand();
  if (vanishes(half_trace - I[2][2])) {
    const Number sx = d.named(half_trace - I[0][0], "sigma_" + n + "_xx"),
                 sy = d.named(half_trace - I[1][1], "sigma_" + n + "_yy");
    return {U[2][1] * sy, -U[2][0] * sx, U[1][0] * sx - U[0][1] * sy};
  }
  const auto product = [&](std::size_t a, std::size_t b) {
    return d.named(w[a] * w[b], "omega_" + n + "_" + std::to_string(a) + std::to_string(b));
  };
  const auto entry = [&](std::size_t a) { return d.named(I[a][a], "I_" + n + "_" + std::to_string(a)); };
  const Number xx = entry(0), yy = entry(1), zz = entry(2);
  return {xx * dw[0] + (zz - yy) * product(1, 2), yy * dw[1] + (xx - zz) * product(0, 2),
          zz * dw[2] + (yy - xx) * product(0, 1)};
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

}  // namespace

Wrench inertial_wrench(Derivation& d, const InertialParameters& body, const LinkMotion& link, const std::string& n) {
  const Vec3 h = d.named(body.first_moment, "mr_" + n);
  const Number m = d.named(body.mass, "m_" + n);
  const Mat3 I = d.named_symmetric(body.inertia, "I_" + n);
  const Vec3 F = d.named(m * link.ddp + link.U * h, "F_" + n);
  return {F, d.named(diagonal_moment(d, body.inertia, link, n) + product_moment(d, I, link, n) + cross(h, link.ddp),
                     "N_" + n)};
}

namespace {

// The reaction of joint i's spinning rotor on the link that carries it, last two terms of (7.105).
Vec3 rotor_reaction(Frames& frames, int i, const LinkMotion& carrier, const Motion& motion) {
  Derivation& d = frames.derivation();
  const Rotor& rotor = *frames.body(i).rotor;
  const auto k = static_cast<std::size_t>(i);
  const Number krI = d.named(rotor.gear_ratio * rotor.inertia, "kI_" + frames.label(i));
  const Number spin = d.named(krI * motion.qdd[k], "kIqdd_" + frames.label(i));
  const Number momentum = d.named(krI * motion.qd[k], "kIqd_" + frames.label(i));
  const Vec3& z = frames.rotor_axis(i);
  return spin * z + momentum * cross(carrier.omega, z);
}

}  // namespace

LinkMotion base_motion(Frames& frames, const Motion& motion) {
  LinkMotion base;
  base.ddp = frames.derivation().named(Number(-1) * motion.gravity, "ddp_0");  // so that gravity acts on every link
  return base;
}

Vec3 gravity_of(const Mechanism& mechanism, Derivation& derivation) {
  if (!mechanism.has_base_gravity()) return mechanism.gravity;
  const std::vector<Number> g = inputs(derivation, InputKind::g_b, 3);
  return {g[0], g[1], g[2]};
}

namespace {

// U = S(ω̇) + S(ω)².
Mat3 acceleration_field(Derivation& d, const Vec3& w, const Vec3& a, const std::string& n) {
  const auto square = [&](std::size_t i, std::size_t k, const char* name) {
    return d.named(w[i] * w[k], "omega_" + n + name);
  };
  const Number xx = square(0, 0, "_xx"), yy = square(1, 1, "_yy"), zz = square(2, 2, "_zz"), xy = square(0, 1, "_xy"),
               xz = square(0, 2, "_xz"), yz = square(1, 2, "_yz");
  const auto entry = [&](const Number& value, const char* name) { return d.named(value, "U_" + n + "_" + name); };
  return {Vec3{entry(-yy - zz, "xx"), entry(xy - a[2], "xy"), entry(xz + a[1], "xz")},
          Vec3{entry(xy + a[2], "yx"), entry(-xx - zz, "yy"), entry(yz - a[0], "yz")},
          Vec3{entry(xz - a[1], "zx"), entry(yz + a[0], "zy"), entry(-xx - yy, "zz")}};
}

// The motion of the link of a floating base. Its acceleration is v̇ + ω × v, as v̇ are derivatives of components in
// axes that turn.
LinkMotion floating_motion(Derivation& d, const Motion& motion) {
  const auto part = [](const std::vector<Number>& twist, std::size_t first) {
    return Vec3{twist[first], twist[first + 1], twist[first + 2]};
  };
  LinkMotion base;
  base.omega = part(motion.qd, 3);
  base.domega = part(motion.qdd, 3);
  base.ddp = d.named(part(motion.qdd, 0) + cross(base.omega, part(motion.qd, 0)) - motion.gravity, "ddp_b");
  base.U = acceleration_field(d, base.omega, base.domega, "b");
  return base;
}

// The motions of the bodies of a floating base, the base link last.
std::vector<LinkMotion> motions_of_base(Frames& frames, const Motion& motion) {
  std::vector<LinkMotion> links(static_cast<std::size_t>(frames.mechanism().base_bodies()));
  if (links.empty()) return links;
  links.back() = floating_motion(frames.derivation(), motion);
  for (std::size_t k = links.size() - 1; k > 0; --k) {
    const int i = static_cast<int>(k);
    links[k - 1].omega = frames.to_parent(i, links[k].omega, "omega_b" + frames.label(i));
  }
  return links;
}

// The motion of the link that a spherical joint moves, the last of the joint's bodies: ω = Rᵀ ω_parent + w and
// ω̇ = Rᵀ ω̇_parent + ẇ + Rᵀ ω_parent × w. Its origin moves with the parent.
LinkMotion motion_past_spherical_joint(Frames& frames, int first, const LinkMotion& parent, const Motion& motion) {
  Derivation& d = frames.derivation();
  const auto k = static_cast<std::size_t>(first);
  const std::string n = frames.label(first + kSphericalBodies - 1);
  const auto in_link = [&](Vec3 v, const std::string& name) {
    for (int i = first; i < first + kSphericalBodies; ++i) v = frames.to_child(i, v, name);
    return v;
  };
  const Vec3 w = {motion.qd[k], motion.qd[k + 1], motion.qd[k + 2]},
             dw = {motion.qdd[k], motion.qdd[k + 1], motion.qdd[k + 2]};
  LinkMotion link;
  link.omega_r = in_link(parent.omega, "omega_r_" + n);
  link.domega_r = in_link(parent.domega, "domega_r_" + n);
  link.omega = d.named(link.omega_r + w, "omega_" + n);
  link.domega = d.named(link.domega_r + dw + cross(link.omega_r, w), "domega_" + n);
  link.ddp = in_link(d.named(parent.ddp + parent.U * frames.p(first), "ddp_o_" + n), "ddp_" + n);
  link.U = acceleration_field(d, link.omega, link.domega, n);
  return link;
}

}  // namespace

std::vector<LinkMotion> link_motions(Frames& frames, const Motion& motion) {
  const LinkMotion base = base_motion(frames, motion);
  std::vector<LinkMotion> links = motions_of_base(frames, motion);
  LinkMotion at_joint;  // of the parent of the last spherical joint
  for (int i = frames.mechanism().base_bodies(); i < frames.mechanism().body_count(); ++i) {
    const int parent = frames.body(i).parent;
    const LinkMotion before = parent < 0 ? base : links[static_cast<std::size_t>(parent)];
    const int part = frames.body(i).spherical;
    if (part == 0) {
      links.push_back(link_motion(frames, i, before, motion));
    } else {
      const bool is_last = part == kSphericalBodies;
      links.push_back(is_last ? motion_past_spherical_joint(frames, i + 1 - part, at_joint, motion) : LinkMotion{});
      if (part == 1) at_joint = before;
    }
  }
  return links;
}

Wrench to_parent(Frames& frames, int i, const Wrench& wrench, const std::string& name) {
  Derivation& d = frames.derivation();
  const Number q = frames.slide(i);  // moment arm along z of frame i, for a prismatic joint
  const Vec3 mu = d.named(wrench.mu + Vec3{-q * wrench.f[1], q * wrench.f[0], 0}, "mu_s_" + name);
  const Vec3 f = frames.to_parent(i, wrench.f, "f_u_" + name);
  const Vec3 turned = frames.to_parent(i, mu, "mu_u_" + name);
  Vec3 levered = cross(frames.p(i), f);
  // For parallel axes the z entry does not need the rotated f.
  if (const auto& p = frames.p_in_own_axes(i)) levered[2] = frames.axis_in_parent(i)[2] * cross(*p, wrench.f)[2];
  return {f, turned + levered};
}

Vec3 rotor_momentum(Frames& frames, int i) {
  Derivation& d = frames.derivation();
  const Rotor& rotor = *frames.body(i).rotor;
  return d.named(rotor.gear_ratio * rotor.inertia, "kI_" + frames.label(i)) * frames.rotor_axis(i);
}

Number reflected_inertia(const Body& body) {
  Number inertia = body.armature;
  if (body.rotor) inertia += body.rotor->gear_ratio * body.rotor->gear_ratio * body.rotor->inertia;
  return inertia;
}

Number own_acceleration(Frames& frames, int i, const Motion& motion) {
  const auto k = static_cast<std::size_t>(i);
  if (!frames.mechanism().is_of_base(i) || !frames.body(i).prismatic || vanishes(frames.body(i).armature)) {
    return motion.qdd[k];
  }
  const std::vector<Number>& twist = motion.qd;
  const Vec3 turning = cross({twist[3], twist[4], twist[5]}, {twist[0], twist[1], twist[2]});
  return frames.derivation().named(motion.qdd[k] + turning[k], "ddp_a" + frames.label(i));
}

Number joint_component(Frames& frames, int i, const Wrench& wrench) {
  return frames.body(i).prismatic ? wrench.f[2] : wrench.mu[2];
}

std::vector<Wrench> rotor_reactions(Frames& frames, const Motion& motion, const std::vector<LinkMotion>& links) {
  std::vector<Wrench> wrenches(links.size());
  for (int i = 0; i < frames.mechanism().body_count(); ++i) {
    const auto& rotor = frames.body(i).rotor;
    if (!rotor || rotor->carrier < 0) continue;
    const auto carrier = static_cast<std::size_t>(rotor->carrier);
    wrenches[carrier].mu = wrenches[carrier].mu + rotor_reaction(frames, i, links[carrier], motion);
  }
  return wrenches;
}

Number spring_stretch(Frames& frames, int i) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(i);
  const Number q = joint_position(frames.mechanism(), d, i);
  return d.named(q - d.named(frames.body(i).spring_reference, "q_0" + n), "stretch_" + n);
}

Number spring_torque(Frames& frames, int i) {
  const Number& stiffness = frames.body(i).stiffness;
  if (vanishes(stiffness)) return 0;
  return frames.derivation().named(stiffness, "k_" + frames.label(i)) * spring_stretch(frames, i);
}

Number joint_torque(Frames& frames, int i, const Wrench& wrench, const std::vector<LinkMotion>& links,
                    const Motion& motion) {
  Derivation& d = frames.derivation();
  const Body& body = frames.body(i);
  const auto k = static_cast<std::size_t>(i);
  const std::string n = frames.label(i);
  Number tau = joint_component(frames, i, wrench);
  if (body.rotor && body.rotor->carrier >= 0) {
    const Rotor& rotor = *body.rotor;
    const Number krI = d.named(rotor.gear_ratio * rotor.inertia, "kI_" + n);
    const Vec3& z = frames.rotor_axis(i);
    tau += krI * d.named(dot(z, links[static_cast<std::size_t>(rotor.carrier)].domega), "domega_m" + n);
  }
  tau += d.named(reflected_inertia(body), "I_r" + n) * own_acceleration(frames, i, motion);
  if (motion.passive) {
    tau += d.named(body.viscous, "F_v" + n) * motion.qd[k];
    tau += dry_friction(d, body, motion.qd[k], n);
    tau += spring_torque(frames, i);
  }
  return d.named(tau, "tau_" + n);
}

std::vector<Wrench> joint_wrenches(Frames& frames, const Motion& motion, const std::vector<LinkMotion>& links,
                                   const std::optional<Wrench>& tip) {
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  std::vector<Wrench> wrenches = rotor_reactions(frames, motion, links);
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Wrench own = inertial_wrench(d, frames.inertia(i), links[k], frames.label(i));
    wrenches[k] = {own.f, own.mu + wrenches[k].mu};
  }
  if (tip && mechanism.tip.body >= 0) {
    Wrench& at_tip = wrenches[static_cast<std::size_t>(mechanism.tip.body)];
    at_tip = {at_tip.f + tip->f, at_tip.mu + tip->mu};
  }
  for (std::size_t i = wrenches.size(); i-- > 0;) {
    const std::string name = frames.label(static_cast<int>(i));
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
