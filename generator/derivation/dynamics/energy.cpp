// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/energy.hpp"

#include <algorithm>

#include "derivation/dynamics/coordinates.hpp"
#include "derivation/dynamics/newton_euler.hpp"
#include "derivation/dynamics/velocities.hpp"

namespace flatdyn {
namespace {

// m v² + ω·(Î ω + 2 m r × v): twice the kinetic energy of an augmented link, (7.70).
Number twice_link_energy(Derivation& d, const InertialParameters& body, const Velocity& link, const std::string& n) {
  const Vec3 &w = link.omega, &v = link.v;
  const Vec3 twice_h = d.named(Number(2) * body.first_moment, "mr_2_" + n);
  const Mat3 I = d.named_symmetric(body.inertia, "I_" + n);
  const Vec3 momentum = d.named(I * w + cross(twice_h, v), "L_" + n);
  return d.named(body.mass, "m_" + n) * d.named(dot(v, v), "v_v_" + n) + dot(w, momentum);
}

Number twice_rotor_energy(Derivation& d, const Body& body, const Vec3& axis, const std::vector<Velocity>& links,
                          const Number& qd, const std::string& n) {
  Number coupling = 0;
  if (body.rotor && body.rotor->carrier >= 0) {
    const Rotor& rotor = *body.rotor;
    const Number omega = dot(axis, links[static_cast<std::size_t>(rotor.carrier)].omega);
    coupling = d.named(2 * rotor.gear_ratio * rotor.inertia, "kI_2_" + n) * d.named(omega, "omega_m" + n);
  }
  return qd * d.named(d.named(reflected_inertia(body), "I_r" + n) * qd + coupling, "L_m" + n);
}

}  // namespace

Number kinetic_energy(Frames& frames) {
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  const std::vector<Number> rates = joint_motion(mechanism, d, InputKind::qd);
  const std::vector<Velocity> links = link_velocities(frames, rates);
  Number twice = 0;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    twice += d.named(twice_link_energy(d, frames.inertia(i), links[k], frames.label(i)), "T_" + frames.label(i));
    twice += d.named(twice_rotor_energy(d, frames.body(i), frames.rotor_axis(i), links, rates[k], frames.label(i)),
                     "T_m" + frames.label(i));
  }
  return d.named(d.named(twice, "T_2") / 2, "T");
}

namespace {

// First moments and masses of composite bodies. at_axis: about the origin of frame i at q_i = 0, in axes that do not
// turn with the joint; base: of the whole robot about the base frame's origin.
struct FirstMoments {
  std::vector<Vec3> at_axis;
  std::vector<Number> mass;
  Vec3 base = zero_vector();
};

FirstMoments first_moments(Frames& frames, const Number& unit) {  // in `unit` kg m, kg
  Derivation& d = frames.derivation();
  const Mechanism& mechanism = frames.mechanism();
  const auto n = static_cast<std::size_t>(mechanism.body_count());
  FirstMoments sum{std::vector<Vec3>(n), std::vector<Number>(n), mechanism.base.first_moment};
  std::vector<Vec3> h;
  for (std::size_t k = 0; k < n; ++k) h.push_back(1 / unit * frames.inertia(static_cast<int>(k)).first_moment);
  for (std::size_t k = n; k-- > 0;) {
    const int i = static_cast<int>(k), parent = frames.body(i).parent;
    sum.mass[k] = d.named(sum.mass[k] + frames.inertia(i).mass / unit, "mc_" + frames.label(i));
    const Vec3 slid = d.named(h[k] + sum.mass[k] * Vec3{0, 0, frames.slide(i)}, "hc_" + frames.label(i));
    sum.at_axis[k] = frames.up_to_axis(i, slid, "hu_" + frames.label(i));
    const Vec3 carried = frames.up_from_axis(i, sum.at_axis[k], "hu_" + frames.label(i)) + sum.mass[k] * frames.p(i);
    Vec3& target = parent < 0 ? sum.base : h[static_cast<std::size_t>(parent)];
    target = target + carried;
    if (parent >= 0) sum.mass[static_cast<std::size_t>(parent)] += sum.mass[k];
  }
  return sum;
}

}  // namespace

Number potential_energy(Frames& frames) {
  Derivation& d = frames.derivation();
  const Vec3 h_base = d.named(first_moments(frames, 1).base, "hc_0");
  Number U = -dot(d.named(gravity_of(frames.mechanism(), d), "g_0"), h_base);
  for (int i = 0; i < frames.mechanism().body_count(); ++i) {
    const Number& stiffness = frames.body(i).stiffness;
    if (vanishes(stiffness)) continue;
    const Number stretch = spring_stretch(frames, i);
    U += d.named(stiffness / 2, "k_" + frames.label(i) + "_h") *
         d.named(stretch * stretch, "stretch2_" + frames.label(i));
  }
  return d.named(U, "U");
}

namespace {

// The absolute value of the largest entry of g_0, if all are numbers: in units of it, a vertical g_0 costs no
// multiplications.
Number unit_of_gravity(const Vec3& g) {
  GiNaC::numeric largest = 0;
  for (const Number& entry : g) {
    if (!GiNaC::is_a<GiNaC::numeric>(entry)) return 1;
    largest = std::max(largest, GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(entry)));
  }
  return largest.is_zero() ? 1 : largest;
}

}  // namespace

std::vector<Number> gravity_torques(Frames& frames) {
  Derivation& d = frames.derivation();
  const Vec3 gravity = gravity_of(frames.mechanism(), d);
  const Number unit = unit_of_gravity(gravity);
  const FirstMoments sum = first_moments(frames, 1 / unit);
  const Vec3 g_base = d.named(1 / unit * gravity, "g_0");
  std::vector<Vec3> g;
  std::vector<Number> torques;
  for (int i = 0; i < frames.mechanism().body_count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int parent = frames.body(i).parent;
    const Vec3& before = parent < 0 ? g_base : g[static_cast<std::size_t>(parent)];
    const Vec3 here = frames.down_to_axis(i, before, "g_" + frames.label(i));
    g.push_back(frames.to_child(i, before, "g_" + frames.label(i)));
    const Vec3& h = sum.at_axis[k];
    torques.push_back(frames.body(i).prismatic ? -sum.mass[k] * here[2] : h[1] * here[0] - h[0] * here[1]);
  }
  return torques;
}

}  // namespace flatdyn
