// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/velocities.hpp"

namespace flatdyn {
namespace {

Velocity link_velocity(Frames& frames, int i, const Velocity& parent, const Number& qd) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(i);
  const Vec3 v_o = d.named(parent.v + cross(parent.omega, frames.p(i)), "v_o_" + n);
  const Vec3 omega = frames.to_child(i, parent.omega, "omega_r_" + n);
  const Vec3 v = frames.to_child(i, v_o, "v_r_" + n);
  if (!frames.body(i).prismatic) return {d.named(omega + Vec3{0, 0, qd}, "omega_" + n), v};
  const Number q = frames.slide(i);
  return {omega, d.named(v + Vec3{q * omega[1], -q * omega[0], qd}, "v_" + n)};
}

}  // namespace

std::vector<Velocity> link_velocities(Frames& frames, const std::vector<Number>& rates) {
  std::vector<Velocity> links;
  for (int i = 0; i < frames.mechanism().body_count(); ++i) {
    const int parent = frames.body(i).parent;
    const Velocity before = parent < 0 ? Velocity{} : links[static_cast<std::size_t>(parent)];
    links.push_back(link_velocity(frames, i, before, rates[static_cast<std::size_t>(i)]));
  }
  return links;
}

}  // namespace flatdyn
