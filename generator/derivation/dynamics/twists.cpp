// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/twists.hpp"

namespace flatdyn {
namespace {

Twist unit_twist(Frames& frames, int i) {
  if (frames.body(i).prismatic) return {zero_vector(), {0, 0, 1}};
  return {{0, 0, 1}, zero_vector()};
}

Twist to_child(Frames& frames, int k, const Twist& parent, const std::string& name) {
  Derivation& d = frames.derivation();
  const Vec3 v = d.named(parent.v + cross(parent.omega, frames.p(k)), "v_o_" + name);
  const Vec3 omega = frames.to_child(k, parent.omega, "w_" + name);
  const Vec3 turned = frames.to_child(k, v, "v_" + name);
  const Number q = frames.slide(k);
  return {omega, d.named(turned + Vec3{q * omega[1], -q * omega[0], 0}, "v_s_" + name)};
}

}  // namespace

std::vector<std::map<int, Twist>> unit_twists(Frames& frames) {
  std::vector<std::map<int, Twist>> twists(static_cast<std::size_t>(frames.mechanism().body_count()));
  for (int k = 0; k < frames.mechanism().body_count(); ++k) {
    auto& here = twists[static_cast<std::size_t>(k)];
    const int parent = frames.body(k).parent;
    if (parent >= 0) {
      for (const auto& [i, twist] : twists[static_cast<std::size_t>(parent)]) {
        here[i] = to_child(frames, k, twist, frames.label(i) + "_" + frames.label(k));
      }
    }
    here[k] = unit_twist(frames, k);
  }
  return twists;
}

Number power(const Twist& twist, const Wrench& wrench) { return dot(twist.v, wrench.f) + dot(twist.omega, wrench.mu); }

}  // namespace flatdyn
