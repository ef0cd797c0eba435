// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/coupled_base.hpp"

#include <algorithm>

#include "diagnostics/diagnostics.hpp"
#include "graph/mod_p.hpp"
#include "model/field_mechanism.hpp"
#include "symbolic/elimination.hpp"
#include "symbolic/regressor.hpp"
#include "symbolic/workbench.hpp"

namespace flatdyn {
namespace {

// The regressor of the tree's base parameters, at the coordinates.
Function sampled_function(const Mechanism& mechanism, const BaseParameters& base) {
  Workbench bench(mechanism);
  const std::vector<Number> qd = bench.joint_motion(InputKind::qd);
  const JointMotion motion{qd, qd, bench.joint_motion(InputKind::qdd), mechanism.gravity};
  const Rows Y = regressor(bench.frames, motion, base.columns);
  const std::vector<NodeId> entries = bench.nodes(rows_at_coordinates(mechanism, bench.derivation, Y, "y"));
  return finished(bench, {InputKind::q, InputKind::qd, InputKind::qdd},
                  {matrix_output("Y_b", bench.size(), base.size(), entries, "")});
}

constexpr std::size_t kSpareRows = 4;  // beyond the number of columns: then the rank is full, as good as surely

// A coordinate's angle, or a multiple of one; none of the robot's symbols.
bool is_coordinate(const Graph& graph, NodeId angle) {
  const Node& node = graph[graph.is_scaled(angle) ? graph[angle].terms.front().node : angle];
  return node.op == Op::input && node.input.kind == InputKind::q;
}

Number exact(const Rational& value) { return GiNaC::numeric(value.str().c_str()); }

// A state of random rational numbers, the robot's own symbols kept.
class SampledState {
 public:
  using Scalar = Number;

  SampledState(const Mechanism& mechanism, std::uint64_t seed) : mechanism_(mechanism), drawn_(seed) {}

  Number constant(const Rational& value) const { return exact(value); }
  Number input(const Input& input) const {
    if (input.kind == InputKind::parameter) return mechanism_.symbols[static_cast<std::size_t>(input.index)].symbol;
    return exact(drawn_.input(input));
  }
  Number divide(const Number& a, const Number& b) const { return a / b; }
  Number sin(const Graph& graph, NodeId angle, const Number& value) const {
    return is_coordinate(graph, angle) ? exact(drawn_.sin(graph, angle, 0)) : Number(GiNaC::sin(value));
  }
  Number cos(const Graph& graph, NodeId angle, const Number& value) const {
    return is_coordinate(graph, angle) ? exact(drawn_.cos(graph, angle, 0)) : Number(GiNaC::cos(value));
  }
  Number sqrt(const Number& value) const { return GiNaC::sqrt(value); }
  Number sign(const Number& rate) const { return exact(drawn_.sign(to_rational(rate))); }

 private:
  const Mechanism& mechanism_;
  RationalArithmetic drawn_;
};

void add_sample(const Mechanism& mechanism, const Function& function, std::uint64_t seed, Rows& rows) {
  SampledState state(mechanism, seed);
  const std::vector<Number> values = evaluate(function, state);
  const Output& Y = function.outputs.front();
  for (int i = 0; i < Y.rows; ++i) {
    rows.emplace_back();
    for (int k = 0; k < Y.cols; ++k) {
      const NodeId entry = Y.entries[static_cast<std::size_t>(i * Y.cols + k)];
      rows.back().push_back(simplified<Number>(values[static_cast<std::size_t>(entry)]));
    }
  }
}

// A state modulo a large prime. Symbols have the same values in all.
class FieldState {
 public:
  using Arithmetic = ModPArithmetic<>;
  using Scalar = Arithmetic::Scalar;

  explicit FieldState(std::uint64_t seed) : drawn_(seed) {}

  Scalar constant(const Rational& value) const { return drawn_.constant(value); }
  Scalar input(const Input& input) const {
    return (input.kind == InputKind::parameter ? symbols_ : drawn_).input(input);
  }
  Scalar divide(const Scalar& a, const Scalar& b) const { return a / b; }
  Scalar sin(const Graph& graph, NodeId angle, const Scalar& value) const {
    return of(graph, angle).sin(graph, angle, value);
  }
  Scalar cos(const Graph& graph, NodeId angle, const Scalar& value) const {
    return of(graph, angle).cos(graph, angle, value);
  }
  Scalar sqrt(const Scalar& value) const { return drawn_.sqrt(value); }
  Scalar sign(const Scalar& rate) const { return drawn_.sign(rate); }

 private:
  const Arithmetic& of(const Graph& graph, NodeId angle) const {
    return is_coordinate(graph, angle) ? drawn_ : symbols_;
  }

  Arithmetic drawn_, symbols_{0};
};

// Whether no column depends on others: decided modulo a large prime, where that is cheap. With symbols, and where loops
// are closed, exact elimination is not.
bool are_independent(const Function& function) {
  using F = ModP<kMersenne61>;
  const Output& Y = function.outputs.front();
  const auto columns = static_cast<std::size_t>(Y.cols);
  std::vector<std::vector<F>> rows;
  for (std::uint64_t seed = 1; rows.size() < columns + kSpareRows; ++seed) {
    FieldState state(seed);
    const std::vector<F> values = evaluate(function, state);
    for (std::size_t i = 0; i < static_cast<std::size_t>(Y.rows); ++i) {
      rows.emplace_back();
      for (std::size_t k = 0; k < columns; ++k) {
        rows.back().push_back(values[static_cast<std::size_t>(Y.entries[i * columns + k])]);
      }
    }
  }
  return reduced_echelon(std::move(rows), [](const F& x) { return x == F(0); }).pivots.size() == columns;
}

Echelon<Number> sampled_echelon(const Mechanism& mechanism, const Function& function) {
  const auto columns = static_cast<std::size_t>(function.outputs.front().cols);
  Rows rows;
  for (std::uint64_t seed = 1; rows.size() < columns + kSpareRows; ++seed) add_sample(mechanism, function, seed, rows);
  ModPArithmetic<> arithmetic(1);
  const NumberMap<ModPArithmetic<>> field(mechanism.symbols, arithmetic);
  return reduced_echelon(std::move(rows), [&field](const Number& x) { return field(x) == ModP<kMersenne61>(0); });
}

// Elimination keeps what comes first: joint by joint, and of a joint's parameters those that are preferred.
BaseParameters by_preference(const BaseParameters& base) {
  std::vector<std::pair<std::pair<int, std::ptrdiff_t>, std::size_t>> order;
  for (std::size_t k = 0; k < base.columns.size(); ++k) {
    const auto* place = std::find(std::begin(kPreference), std::end(kPreference), parameter_of(base.columns[k]));
    order.push_back({{joint_of(base.columns[k]), place - std::begin(kPreference)}, k});
  }
  std::sort(order.begin(), order.end());
  BaseParameters sorted;
  for (const auto& [rank, k] : order) {
    sorted.columns.push_back(base.columns[k]);
    sorted.combination.push_back(base.combination[k]);
  }
  return sorted;
}

void add_multiple(ParameterForm& form, const Number& factor, const ParameterForm& other) {
  for (const auto& [index, coefficient] : other) form[index] += factor * coefficient;
}

}  // namespace

BaseParameters reduced_at_coordinates(const Mechanism& mechanism, const BaseParameters& base) {
  if (base.columns.empty()) return base;
  const BaseParameters tree = by_preference(base);
  const Function sampled = sampled_function(mechanism, tree);
  if (are_independent(sampled)) return base;
  const Echelon<Number> echelon = sampled_echelon(mechanism, sampled);
  std::map<int, ParameterForm> kept;
  for (std::size_t r = 0; r < echelon.rows.size(); ++r) {
    ParameterForm& form = kept[tree.columns[echelon.pivots[r]]];
    for (std::size_t k = 0; k < echelon.rows[r].size(); ++k) {
      const Number& factor = echelon.rows[r][k];
      if (!factor.is_zero()) add_multiple(form, factor, tree.combination[k]);
    }
    for (auto& [index, coefficient] : form) coefficient = simplified<Number>(coefficient);
    std::erase_if(form, [](const auto& term) { return vanishes(term.second); });
  }
  BaseParameters reduced{{}, {}, base.shifts};
  for (auto& [column, form] : kept) {
    reduced.columns.push_back(column);
    reduced.combination.push_back(std::move(form));
  }
  return reduced;
}

}  // namespace flatdyn
