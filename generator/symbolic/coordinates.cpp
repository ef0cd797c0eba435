// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/coordinates.hpp"

#include <cstdlib>

#include "model/rational_rotation.hpp"

namespace flatdyn {
namespace {

std::string names_of(int i, int k) { return "_" + label(i) + "_" + label(k); }

// The bodies that coordinate k moves directly, with their factors.
std::vector<std::pair<int, Number>> moved_by(const Mechanism& mechanism, int k) {
  std::vector<std::pair<int, Number>> result;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const Number& factor = mechanism.coupling[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    if (!vanishes(factor)) result.emplace_back(i, factor);
  }
  return result;
}

Number joint_value(const Mechanism& mechanism, const std::vector<Number>& coordinates, int i) {
  Number sum = 0;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    sum += mechanism.coupling[static_cast<std::size_t>(i)][k] * coordinates[k];
  }
  return sum;
}

// "m1_2x3": back by coordinate 1, twice by coordinate 3.
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

// k times an angle: half of k, twice, and once more if k is odd.
PlanarRotation multiple(Derivation& d, const PlanarRotation& a, int times, const std::string& name) {
  if (times == 1) return a;
  const PlanarRotation half = multiple(d, a, times / 2, name);
  const std::string n = name + "x" + std::to_string(times);
  const PlanarRotation even = named(d, half * half, n);
  return times % 2 == 0 ? even : named(d, even * a, n + "o");
}

}  // namespace

PlanarRotation turn_by(Derivation& d, const std::vector<Number>& multiples) {
  std::vector<Number> so_far(multiples.size(), 0);
  PlanarRotation total;
  for (std::size_t k = 0; k < multiples.size(); ++k) {
    const int times = GiNaC::ex_to<GiNaC::numeric>(multiples[k]).to_int();
    if (times == 0) continue;
    const Number q = d.input(InputKind::q, static_cast<int>(k));
    const std::string n = label(static_cast<int>(k));
    const PlanarRotation step = multiple(d, {d.cos(q, "c_" + n), d.sin(q, "s_" + n)}, std::abs(times), n);
    so_far[k] = multiples[k];
    total = named(d, total * (times < 0 ? inverse(step) : step), turn_label(so_far));
  }
  return total;
}

Number joint_position(const Mechanism& mechanism, Derivation& derivation, int i) {
  if (!mechanism.is_coupled()) return derivation.input(InputKind::q, i);
  const std::vector<Number> q = inputs(derivation, InputKind::q, mechanism.size());
  return derivation.named(joint_value(mechanism, q, i), "q_" + label(i));
}

std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation,
                                 const std::vector<Number>& coordinates, const std::string& name) {
  if (!mechanism.is_coupled()) return coordinates;
  std::vector<Number> result;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    result.push_back(derivation.named(joint_value(mechanism, coordinates, i), name + label(i)));
  }
  return result;
}

Number joint_rate(const Mechanism& mechanism, Derivation& derivation, int i) {
  if (!mechanism.is_coupled()) return derivation.input(InputKind::qd, i);
  const std::vector<Number> qd = inputs(derivation, InputKind::qd, mechanism.size());
  return derivation.named(joint_value(mechanism, qd, i), "qd_" + label(i));
}

std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation, InputKind kind) {
  const std::map<InputKind, const char*> names = {
      {InputKind::qd, "qd_"}, {InputKind::qdd, "qdd_"}, {InputKind::qd_r, "qd_r_"}, {InputKind::qdd_r, "qdd_r_"}};
  return joint_motion(mechanism, derivation, inputs(derivation, kind, mechanism.size()), names.at(kind));
}

std::vector<Number> at_coordinates(const Mechanism& mechanism, Derivation& derivation, const std::vector<Number>& tau,
                                   const std::string& name) {
  if (!mechanism.is_coupled()) return tau;
  std::vector<Number> result;
  for (int k = 0; k < mechanism.size(); ++k) {
    Number sum = 0;
    for (const auto& [i, factor] : moved_by(mechanism, k)) sum += factor * tau[static_cast<std::size_t>(i)];
    result.push_back(derivation.named(sum, name + "_q" + label(k)));
  }
  return result;
}

Rows rows_at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix,
                         const std::string& name) {
  if (!mechanism.is_coupled()) return matrix;
  Rows result;
  for (int k = 0; k < mechanism.size(); ++k) {
    result.emplace_back(matrix.front().size(), 0);
    for (std::size_t column = 0; column < matrix.front().size(); ++column) {
      Number sum = 0;
      for (const auto& [i, factor] : moved_by(mechanism, k))
        sum += factor * matrix[static_cast<std::size_t>(i)][column];
      result.back()[column] = derivation.named(sum, name + names_of(k, static_cast<int>(column)) + "h");
    }
  }
  return result;
}

Rows at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix, Shape shape,
                    const std::string& name) {
  if (!mechanism.is_coupled()) return matrix;
  const Rows half = rows_at_coordinates(mechanism, derivation, matrix, name);
  Rows result(half.size(), std::vector<Number>(half.size(), 0));
  for (int k = 0; k < mechanism.size(); ++k) {
    for (int l = shape == Shape::symmetric ? k : 0; l < mechanism.size(); ++l) {
      Number sum = 0;
      for (const auto& [i, factor] : moved_by(mechanism, l)) {
        sum += factor * half[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
      }
      Number& entry = result[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)];
      entry = derivation.named(sum, name + names_of(k, l) + "q");
      if (shape == Shape::symmetric) result[static_cast<std::size_t>(l)][static_cast<std::size_t>(k)] = entry;
    }
  }
  return result;
}

ChristoffelSymbols at_coordinates(const Mechanism& mechanism, Derivation& derivation, const ChristoffelSymbols& c) {
  if (!mechanism.is_coupled()) return c;
  const auto row = [&](int i) -> const std::vector<Number>& { return mechanism.coupling[static_cast<std::size_t>(i)]; };
  ChristoffelSymbols sums;
  const auto add = [&](int r, int s, int t, const Number& value) {
    for (int i = 0; i < mechanism.size(); ++i) {
      for (int j = 0; j < mechanism.size(); ++j) {
        for (int k = j; k < mechanism.size(); ++k) {
          const auto at = [](int index) { return static_cast<std::size_t>(index); };
          const Number factor = row(r)[at(i)] * row(s)[at(j)] * row(t)[at(k)];
          if (!vanishes(factor)) sums[{i, j, k}] += factor * value;
        }
      }
    }
  };
  for (const auto& [key, value] : c) {
    const auto [r, s, t] = key;
    add(r, s, t, value);
    if (s != t) add(r, t, s, value);
  }
  ChristoffelSymbols result;
  for (const auto& [key, sum] : sums) {
    const auto [i, j, k] = key;
    result[key] = derivation.named(sum, "c_q" + label(i) + names_of(j, k));
  }
  return result;
}

std::vector<JacobianColumn> at_coordinates(const Mechanism& mechanism, Derivation& derivation,
                                           const std::vector<JacobianColumn>& columns) {
  if (!mechanism.is_coupled()) return columns;
  std::vector<JacobianColumn> result;
  for (int k = 0; k < mechanism.size(); ++k) {
    JacobianColumn sum;
    for (const auto& [i, factor] : moved_by(mechanism, k)) {
      const JacobianColumn& column = columns[static_cast<std::size_t>(i)];
      sum.linear = sum.linear + factor * column.linear;
      sum.angular = sum.angular + factor * column.angular;
    }
    const std::string n = "_q" + label(k);
    result.push_back({derivation.named(sum.linear, "J_P" + n), derivation.named(sum.angular, "J_O" + n)});
  }
  return result;
}

}  // namespace flatdyn
