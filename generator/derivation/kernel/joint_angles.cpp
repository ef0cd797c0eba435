// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/kernel/joint_angles.hpp"

#include <cstdlib>

#include "robot/model/rational_rotation.hpp"

namespace flatdyn {
namespace {

// The label of a sum of multiples: "m1_2x3" for minus coordinate 1 plus twice coordinate 3.
std::string turn_label(const std::vector<Number>& multiples) {
  std::string text;
  for (std::size_t k = 0; k < multiples.size(); ++k) {
    const int times = GiNaC::ex_to<GiNaC::numeric>(multiples[k]).to_int();
    if (times == 0) continue;
    text += (text.empty() ? "" : "_") + std::string(times < 0 ? "m" : "");
    if (std::abs(times) > 1) text += std::to_string(std::abs(times)) + "x";
    text += label(static_cast<int>(k));
  }
  return text;
}

// The rotation by k times an angle, by doubling: twice the rotation by half of k, and once more if k is odd.
PlanarRotation multiple(Derivation& d, const PlanarRotation& a, int times, const std::string& name) {
  if (times == 1) return a;
  const PlanarRotation half = multiple(d, a, times / 2, name);
  const std::string n = name + "x" + std::to_string(times);
  const PlanarRotation even = named(d, half * half, n);
  return times % 2 == 0 ? even : named(d, even * a, n + "o");
}

Number angle_at(const Mechanism& mechanism, Derivation& derivation, int k) {
  if (k < mechanism.position_count()) return derivation.input(InputKind::q, k);
  const CoordinateMultiple& angle = mechanism.angles[static_cast<std::size_t>(k - mechanism.position_count())];
  return angle.factor * derivation.input(InputKind::q, angle.position);
}

}  // namespace

std::string label(int i, int base_bodies) {
  if (i >= base_bodies) return std::to_string(i - base_bodies + 1);
  return i + 1 == base_bodies ? "b" : "b" + std::to_string(i + 1);
}

std::vector<Number> inputs(Derivation& derivation, InputKind kind, int size) {
  std::vector<Number> values;
  for (int i = 0; i < size; ++i) values.push_back(derivation.input(kind, i));
  return values;
}

Number sum_of(const std::vector<Number>& factors, const std::vector<Number>& values) {
  Number sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k) sum += factors[k] * values[k];
  return sum;
}

PlanarRotation named(Derivation& derivation, const PlanarRotation& rotation, const std::string& name) {
  return {derivation.named(rotation.c, "c_" + name), derivation.named(rotation.s, "s_" + name)};
}

PlanarRotation rotation_by(const Mechanism& mechanism, Derivation& d, const std::vector<Number>& multiples) {
  std::vector<Number> so_far(multiples.size(), 0);
  PlanarRotation total;
  for (std::size_t k = 0; k < multiples.size(); ++k) {
    const int times = GiNaC::ex_to<GiNaC::numeric>(multiples[k]).to_int();
    if (times == 0) continue;
    const Number angle = angle_at(mechanism, d, static_cast<int>(k));
    const std::string n = label(static_cast<int>(k));
    const PlanarRotation step = multiple(d, {d.cos(angle, "c_" + n), d.sin(angle, "s_" + n)}, std::abs(times), n);
    so_far[k] = multiples[k];
    total = named(d, total * (times < 0 ? inverse(step) : step), turn_label(so_far));
  }
  return total;
}

Number joint_position(const Mechanism& mechanism, Derivation& derivation, int i) {
  if (mechanism.is_around_pose(i)) return 0;
  if (!mechanism.is_coupled()) return derivation.input(InputKind::q, mechanism.position_of(i));
  const std::vector<Number> q = inputs(derivation, InputKind::q, mechanism.position_count());
  return derivation.named(sum_of(mechanism.coupling[static_cast<std::size_t>(i)], q), "q_" + label(i));
}

}  // namespace flatdyn
