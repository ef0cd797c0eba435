// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/energy.hpp"

namespace flatdyn {
namespace {

struct Velocity {
  Vec3 omega = zero_vector(), v = zero_vector();
};

Velocity moved(Frames& frames, int i, const Velocity& parent, const Number& qd) {
  Derivation& d = frames.derivation();
  const std::string n = label(i);
  const Vec3 v_o = d.named(parent.v + cross(parent.omega, frames.p(i)), "v_o_" + n);
  const Vec3 omega = frames.down(i, parent.omega, "omega_r_" + n);
  const Vec3 v = frames.down(i, v_o, "v_r_" + n);
  if (!frames.mechanism().bodies[static_cast<std::size_t>(i)].prismatic) {
    return {d.named(omega + Vec3{0, 0, qd}, "omega_" + n), v};
  }
  const Number q = frames.slide(i);
  return {omega, d.named(v + Vec3{q * omega[1], -q * omega[0], qd}, "v_" + n)};
}

// m v² + ω·(Î ω + 2 m r × v): twice the kinetic energy of an augmented link, (7.70).
Number twice_link_energy(Derivation& d, const InertialParameters& body, const Velocity& link, const std::string& n) {
  const Vec3 &w = link.omega, &v = link.v;
  const Vec3 twice_h = d.named(Number(2) * body.first_moment, "mr_2_" + n);
  const Mat3 I = d.named_symmetric(body.inertia, "I_" + n);
  const Vec3 momentum = d.named(I * w + cross(twice_h, v), "L_" + n);
  return d.named(body.mass, "m_" + n) * d.named(dot(v, v), "v_v_" + n) + dot(w, momentum);
}

Number twice_rotor_energy(Derivation& d, const Body& body, const std::vector<Velocity>& links, const Number& qd,
                          const std::string& n) {
  Number reflected = body.armature;
  Number coupling = 0;
  if (body.rotor) {
    const Rotor& rotor = *body.rotor;
    reflected += rotor.gear_ratio * rotor.gear_ratio * rotor.inertia;
    if (rotor.carrier >= 0) {
      const Number omega = dot(d.named(rotor.axis, "z_m" + n), links[static_cast<std::size_t>(rotor.carrier)].omega);
      coupling = d.named(2 * rotor.gear_ratio * rotor.inertia, "kI_2_" + n) * d.named(omega, "omega_m" + n);
    }
  }
  return qd * d.named(d.named(reflected, "I_r" + n) * qd + coupling, "L_m" + n);
}

}  // namespace

Number kinetic_energy(Frames& frames) {
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  std::vector<Velocity> links;
  Number twice = 0;
  for (int i = 0; i < mechanism.size(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    const Number qd = d.input(InputKind::qd, i);
    links.push_back(moved(frames, i, body.parent < 0 ? Velocity{} : links[static_cast<std::size_t>(body.parent)], qd));
    twice += d.named(twice_link_energy(d, body.inertia, links.back(), label(i)), "T_" + label(i));
    twice += d.named(twice_rotor_energy(d, body, links, qd, label(i)), "T_m" + label(i));
  }
  return d.named(d.named(twice, "T_2") / 2, "T");
}

Number potential_energy(Frames& frames) {
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  std::vector<Vec3> h;
  std::vector<Number> mass;
  for (const Body& body : mechanism.bodies) {
    h.push_back(body.inertia.first_moment);
    mass.push_back(body.inertia.mass);
  }
  Vec3 h_base = mechanism.base.first_moment;
  for (int i = mechanism.size() - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    const std::string n = label(i);
    const Number m = d.named(mass[k], "mc_" + n);
    const Vec3 slid = d.named(h[k] + m * Vec3{0, 0, frames.slide(i)}, "hc_" + n);
    const Vec3 carried = frames.up(i, slid, "hu_" + n) + m * frames.p(i);
    const int parent = mechanism.bodies[k].parent;
    Vec3& target = parent < 0 ? h_base : h[static_cast<std::size_t>(parent)];
    target = target + carried;
    if (parent >= 0) mass[static_cast<std::size_t>(parent)] += m;
  }
  return d.named(-dot(d.named(mechanism.gravity, "g_0"), d.named(h_base, "hc_0")), "U");
}

}  // namespace flatdyn
