// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/coordinates.hpp"

#include <optional>

#include "derivation/loops/loops.hpp"

namespace flatdyn {
namespace {

std::string names_of(int i, int k) { return "_" + label(i) + "_" + label(k); }

// The matrix A G of closed loops next to the identity block of a floating base.
Rows factors_of_loops(const Mechanism& mechanism, Derivation& derivation) {
  const Rows G = ClosedLoops(mechanism, derivation).motion();
  const int base = mechanism.base_bodies();
  Rows result;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    result.emplace_back(static_cast<std::size_t>(mechanism.size()), 0);
    if (i < base) result.back()[static_cast<std::size_t>(i)] = 1;
    for (int k = base; k < mechanism.size(); ++k) {
      Number sum = 0;
      for (std::size_t p = 0; p < G.size(); ++p) {
        sum += mechanism.coupling[static_cast<std::size_t>(i)][p] * G[p][static_cast<std::size_t>(k - base)];
      }
      result.back()[static_cast<std::size_t>(k)] = derivation.named(sum, "A" + names_of(i - base, k - base));
    }
  }
  return result;
}

// The matrix A, or A G with closed loops: row i is the rate of body i's joint per rate of each coordinate. nullopt
// where coordinates and joints are the same.
std::optional<Rows> factors_of(const Mechanism& mechanism, Derivation& derivation) {
  if (!mechanism.is_coupled()) return std::nullopt;
  return mechanism.has_loops() ? factors_of_loops(mechanism, derivation) : mechanism.rate_coupling();
}

std::vector<Number> column_of(const Rows& rows, int k) {
  std::vector<Number> result;
  for (const std::vector<Number>& row : rows) result.push_back(row[static_cast<std::size_t>(k)]);
  return result;
}

// The bodies that coordinate k moves directly, with their factors.
std::vector<std::pair<int, Number>> moved_by(const Rows& factors, int k) {
  std::vector<std::pair<int, Number>> result;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const Number& factor = factors[i][static_cast<std::size_t>(k)];
    if (!vanishes(factor)) result.emplace_back(static_cast<int>(i), factor);
  }
  return result;
}

std::vector<Number> inputs_of(const Mechanism& mechanism, Derivation& derivation, InputKind kind) {
  return inputs(derivation, with_base(kind, mechanism.has_quasi_velocities()), mechanism.size());
}

std::vector<Number> rates_of(const Mechanism& mechanism, Derivation& derivation, InputKind kind) {
  static const std::map<InputKind, const char*> names = {{InputKind::qd, "qd_"}, {InputKind::qd_r, "qd_r_"}};
  return joint_motion(mechanism, derivation, inputs_of(mechanism, derivation, kind), names.at(kind));
}

// The accelerations of all bodies' joints while those of the coordinates are zero, for motions that close the loops.
std::vector<Number> drift_along(const Mechanism& mechanism, Derivation& derivation, const std::vector<Number>& rates,
                                const std::vector<Number>& rates_r, const std::string& name) {
  const std::vector<Number> drift = ClosedLoops(mechanism, derivation).drift(rates, rates_r, name);
  std::vector<Number> result;
  for (std::size_t i = 0; i < mechanism.coupling.size(); ++i) {
    const std::string n = name + "_j" + label(static_cast<int>(i));
    result.push_back(derivation.named(sum_of(mechanism.coupling[i], drift), n));
  }
  return result;
}

}  // namespace

std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation,
                                 const std::vector<Number>& coordinates, const std::string& name) {
  const std::optional<Rows> factors = factors_of(mechanism, derivation);
  if (!factors) return coordinates;
  std::vector<Number> result;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    result.push_back(derivation.named(sum_of((*factors)[static_cast<std::size_t>(i)], coordinates), name + label(i)));
  }
  return result;
}

std::vector<Number> joint_drift(const Mechanism& mechanism, Derivation& derivation, InputKind kind_r) {
  if (!mechanism.has_loops()) return std::vector<Number>(static_cast<std::size_t>(mechanism.body_count()), 0);
  return drift_along(mechanism, derivation, rates_of(mechanism, derivation, InputKind::qd),
                     rates_of(mechanism, derivation, kind_r), "drift");
}

std::vector<Number> joint_curvature(const Mechanism& mechanism, Derivation& derivation, int j, int k) {
  const Rows factors = factors_of_loops(mechanism, derivation);
  return drift_along(mechanism, derivation, column_of(factors, j), column_of(factors, k), "H" + names_of(j, k));
}

Rows joint_motion_rate(const Mechanism& mechanism, Derivation& derivation) {
  const Rows factors = factors_of_loops(mechanism, derivation);
  const std::vector<Number> rates = rates_of(mechanism, derivation, InputKind::qd);
  Rows result(factors.size(), std::vector<Number>(static_cast<std::size_t>(mechanism.size()), 0));
  for (int k = mechanism.base_bodies(); k < mechanism.size(); ++k) {
    const std::string name = "dA_" + label(k - mechanism.base_bodies());
    const std::vector<Number> column = drift_along(mechanism, derivation, rates, column_of(factors, k), name);
    for (std::size_t i = 0; i < column.size(); ++i) result[i][static_cast<std::size_t>(k)] = column[i];
  }
  return result;
}

std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation, InputKind kind) {
  if (kind == InputKind::qd || kind == InputKind::qd_r) return rates_of(mechanism, derivation, kind);
  const bool of_reference = kind == InputKind::qdd_r;
  const std::string name = of_reference ? "qdd_r_" : "qdd_";
  std::vector<Number> result = joint_motion(mechanism, derivation, inputs_of(mechanism, derivation, kind), name);
  if (!mechanism.has_loops()) return result;
  const std::vector<Number> drift = joint_drift(mechanism, derivation, of_reference ? InputKind::qd_r : InputKind::qd);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = derivation.named(result[i] + drift[i], name + label(static_cast<int>(i)) + "a");
  }
  return result;
}

std::vector<Number> at_coordinates(const Mechanism& mechanism, Derivation& derivation, const std::vector<Number>& tau,
                                   const std::string& name) {
  const std::optional<Rows> factors = factors_of(mechanism, derivation);
  if (!factors) return tau;
  std::vector<Number> result;
  for (int k = 0; k < mechanism.size(); ++k) {
    Number sum = 0;
    for (const auto& [i, factor] : moved_by(*factors, k)) sum += factor * tau[static_cast<std::size_t>(i)];
    result.push_back(derivation.named(sum, name + "_q" + label(k)));
  }
  return result;
}

Rows rows_at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix,
                         const std::string& name) {
  const std::optional<Rows> factors = factors_of(mechanism, derivation);
  if (!factors) return matrix;
  Rows result;
  for (int k = 0; k < mechanism.size(); ++k) {
    result.emplace_back(matrix.front().size(), 0);
    for (std::size_t column = 0; column < matrix.front().size(); ++column) {
      Number sum = 0;
      for (const auto& [i, factor] : moved_by(*factors, k)) sum += factor * matrix[static_cast<std::size_t>(i)][column];
      result.back()[column] = derivation.named(sum, name + names_of(k, static_cast<int>(column)) + "h");
    }
  }
  return result;
}

Rows at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix, Shape shape,
                    const std::string& name) {
  const std::optional<Rows> factors = factors_of(mechanism, derivation);
  if (!factors) return matrix;
  const Rows half = rows_at_coordinates(mechanism, derivation, matrix, name);
  Rows result(half.size(), std::vector<Number>(half.size(), 0));
  for (int k = 0; k < mechanism.size(); ++k) {
    for (int l = shape == Shape::symmetric ? k : 0; l < mechanism.size(); ++l) {
      Number sum = 0;
      for (const auto& [i, factor] : moved_by(*factors, l)) {
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
  const std::optional<Rows> factors = factors_of(mechanism, derivation);
  if (!factors) return c;
  const auto row = [&](int i) -> const std::vector<Number>& { return (*factors)[static_cast<std::size_t>(i)]; };
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
  const std::optional<Rows> factors = factors_of(mechanism, derivation);
  if (!factors) return columns;
  std::vector<JacobianColumn> result;
  for (int k = 0; k < mechanism.size(); ++k) {
    JacobianColumn sum;
    for (const auto& [i, factor] : moved_by(*factors, k)) {
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
