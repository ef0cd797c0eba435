// SPDX-License-Identifier: GPL-2.0-or-later
// Changes of positions during a step, over any scalar, by quaternions alone: one number for each entry of q̇, as
// derivation/dynamics/step_chart.hpp says them. Tangents come from dual numbers.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "robot/model/field_vector.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

template <class S>
S halved(const S& x) {
  return x / (S(1) + S(1));
}

template <class S>
using Quaternion4 = std::array<S, 4>;  // (w, x, y, z)

template <class S>
Quaternion4<S> product(const Quaternion4<S>& a, const Quaternion4<S>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

template <class S>
Quaternion4<S> conjugate(const Quaternion4<S>& a) {
  return {a[0], -a[1], -a[2], -a[3]};
}

// E x E⁻¹ for a vector x and a unit quaternion.
template <class S>
Vector3<S> turned_by(const Quaternion4<S>& E, const Vector3<S>& x) {
  const Quaternion4<S> y = product(product(E, {S(0), x[0], x[1], x[2]}), conjugate(E));
  return {y[1], y[2], y[3]};
}

// The square of (1, σ), by the square of its length: a turn with the modified Rodrigues parameters σ.
template <class S>
Quaternion4<S> turn_by_parameters(const Vector3<S>& sigma) {
  const Quaternion4<S> root = {S(1), sigma[0], sigma[1], sigma[2]};
  Quaternion4<S> E = product(root, root);
  for (S& entry : E) entry = entry / (S(1) + dot(sigma, sigma));
  return E;
}

// The parts of a robot that turn: the first entry of their angular velocity in q̇, and of their quaternion in q.
struct TurningPart {
  std::size_t rate;
  int quaternion;  // -1: the base
};
inline std::vector<TurningPart> turning_parts(const Mechanism& mechanism) {
  std::vector<TurningPart> parts;
  if (mechanism.floating_base) parts.push_back({3, -1});
  for (const int first : mechanism.spherical) {
    parts.push_back({static_cast<std::size_t>(first), mechanism.quaternion_of(first)});
  }
  return parts;
}

inline bool is_joint_of_one_axis(const Mechanism& mechanism, int k) {
  return !mechanism.is_around_pose(mechanism.body_of(k));
}

template <class S>
Vector3<S> three_of(const std::vector<S>& entries, std::size_t first) {
  return {entries[first], entries[first + 1], entries[first + 2]};
}

template <class S>
void put_three(const Vector3<S>& x, std::size_t first, std::vector<S>& to) {
  for (std::size_t k = 0; k < 3; ++k) to[first + k] = x[k];
}

// A change of positions: how far joints of one axis move, the base's displacement in its axes at the start, and turns.
template <class S>
struct ChangeOfPositions {
  std::vector<S> entries;  // by entry of q̇; those of turns are not used
  std::vector<Quaternion4<S>> turns;
};

// With the parameters σ in the entries.
template <class S>
ChangeOfPositions<S> change_in_chart(const Mechanism& mechanism, std::vector<S> c) {
  ChangeOfPositions<S> change{std::move(c), {}};
  for (const TurningPart& part : turning_parts(mechanism)) {
    change.turns.push_back(turn_by_parameters(three_of(change.entries, part.rate)));
  }
  return change;
}

// For w = h (v, ω, ...): once E(ω h / 8), to the middle of a step.
template <class S>
ChangeOfPositions<S> change_to_the_middle(const Mechanism& mechanism, std::vector<S> w) {
  ChangeOfPositions<S> change;
  for (const TurningPart& part : turning_parts(mechanism)) {
    change.turns.push_back(turn_by_parameters(scaled(halved(halved(halved(S(1)))), three_of(w, part.rate))));
  }
  for (S& entry : w) entry = halved(entry);
  change.entries = std::move(w);
  return change;
}

// Twice this, with the base's displacement h v along its axes in the middle.
template <class S>
ChangeOfPositions<S> change_along(const Mechanism& mechanism, std::vector<S> w) {
  ChangeOfPositions<S> change = change_to_the_middle(mechanism, w);
  if (mechanism.floating_base) put_three(turned_by(change.turns[0], three_of(w, 0)), 0, w);
  for (Quaternion4<S>& E : change.turns) E = product(E, E);
  change.entries = std::move(w);
  return change;
}

// The rates of such numbers c for velocities v at c: ḋ = E v, and from Ė = E (0, ω) / 2 with E = (e, r), σ = r / (1 +
// e): σ̇ = (ṙ (1 + e) - r ė) / (1 + e)².
template <class S>
std::vector<S> rates_in_chart(const Mechanism& mechanism, const std::vector<S>& c, std::vector<S> v) {
  const ChangeOfPositions<S> change = change_in_chart(mechanism, c);
  const std::vector<TurningPart> parts = turning_parts(mechanism);
  if (mechanism.floating_base) put_three(turned_by(change.turns[0], three_of(v, 0)), 0, v);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const Quaternion4<S>& E = change.turns[part];
    const Vector3<S> omega = three_of(v, parts[part].rate);
    const Quaternion4<S> twice = product(E, {S(0), omega[0], omega[1], omega[2]});
    const S divisor = S(1) + E[0];
    for (std::size_t k = 0; k < 3; ++k) {
      const S numerator = twice[k + 1] * divisor - E[k + 1] * twice[0];
      v[parts[part].rate + k] = halved(numerator) / (divisor * divisor);
    }
  }
  return v;
}

template <class S>
struct PositionsOfStep {
  std::vector<S> q;
  Vector3<S> g_b;  // gravity in axes of a floating base
};

template <class S>
PositionsOfStep<S> positions_after(const Mechanism& mechanism, PositionsOfStep<S> at,
                                   const ChangeOfPositions<S>& change) {
  for (int k = 0; k < mechanism.size(); ++k) {
    if (!is_joint_of_one_axis(mechanism, k)) continue;
    at.q[static_cast<std::size_t>(mechanism.position_of(k))] += change.entries[static_cast<std::size_t>(k)];
  }
  const std::vector<TurningPart> parts = turning_parts(mechanism);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].quaternion < 0) {
      at.g_b = turned_by(conjugate(change.turns[part]), at.g_b);
      continue;
    }
    const auto first = at.q.begin() + parts[part].quaternion;
    const Quaternion4<S> next = product({first[0], first[1], first[2], first[3]}, change.turns[part]);
    std::copy(next.begin(), next.end(), first);
  }
  return at;
}

// How positions after a change move, in tangent spaces, as those before it move by δ and the change is a dual number:
// R E = R E exp(S(δ')), p + R d → δ_p' = Eᵀ (δ_p + δ × d + ḋ).
template <class F>
std::vector<F> tangent_after(const Mechanism& mechanism, std::vector<F> delta,
                             const ChangeOfPositions<Dual<F>>& change) {
  const std::vector<TurningPart> parts = turning_parts(mechanism);
  const auto part_of = [](const Quaternion4<Dual<F>>& E, auto member) {
    return Quaternion4<F>{E[0].*member, E[1].*member, E[2].*member, E[3].*member};
  };
  if (mechanism.floating_base) {
    const Vector3<Dual<F>> d = three_of(change.entries, 0);
    const Vector3<F> value = {d[0].value, d[1].value, d[2].value},
                     rate = {d[0].derivative, d[1].derivative, d[2].derivative};
    const Vector3<F> moved = plus(plus(three_of(delta, 0), cross(three_of(delta, 3), value)), rate);
    put_three(turned_by(conjugate(part_of(change.turns[0], &Dual<F>::value)), moved), 0, delta);
  }
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const Quaternion4<F> back = conjugate(part_of(change.turns[part], &Dual<F>::value)),
                         rate = product(back, part_of(change.turns[part], &Dual<F>::derivative));
    Vector3<F> turn = turned_by(back, three_of(delta, parts[part].rate));
    for (std::size_t k = 0; k < 3; ++k) turn[k] += rate[k + 1] + rate[k + 1];
    put_three(turn, parts[part].rate, delta);
  }
  for (int k = 0; k < mechanism.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (is_joint_of_one_axis(mechanism, k)) delta[at] += change.entries[at].derivative;
  }
  return delta;
}

}  // namespace flatdyn
