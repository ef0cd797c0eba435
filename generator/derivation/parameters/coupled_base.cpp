// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/coupled_base.hpp"

#include <algorithm>
#include <iterator>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/kernel/elimination.hpp"
#include "derivation/parameters/regressor.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

// The regressor of the tree's base parameters, at the coordinates.
Function sampled_function(const Mechanism& mechanism, const BaseParameters& base) {
  DerivationContext context(mechanism);
  const std::vector<Number> qd = context.joint_motion(InputKind::qd);
  const JointMotion motion{qd, qd, context.joint_motion(InputKind::qdd), mechanism.gravity};
  const Rows Y = regressor(context.frames, motion, base.columns);
  const std::vector<NodeId> entries = context.nodes(rows_at_coordinates(mechanism, context.derivation, Y, "y"));
  return finished(context, {matrix_output("Y_b", context.size(), base.size(), entries, "")});
}

using F = ModP<kMersenne61>;

// The number of sampled states beyond the number of columns. A general state adds a new row as long as there is one;
// but some rows, such as that of a last prismatic joint, depend on few parameters.
constexpr std::uint64_t kSpareStates = 4;

std::uint64_t most_states(const Function& function) {
  return static_cast<std::uint64_t>(function.outputs.front().cols) + kSpareStates;
}

// Whether an angle is a coordinate or a multiple of one, without symbols of the robot.
bool is_coordinate(const Graph& graph, NodeId angle) {
  const Node& node = graph[graph.is_scaled(angle) ? graph[angle].terms.front().node : angle];
  return node.op == Op::input && node.input.kind == InputKind::q;
}

Number exact(const Rational& value) { return GiNaC::numeric(value.str().c_str()); }

// A state of random rational numbers in which the robot's own symbols are kept.
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
  // Any function does: which parameters can be told apart does not depend on it.
  Number tanh(const Number& value) const {
    GiNaC::exmap numbers;
    for (const FreeSymbol& each : mechanism_.symbols) numbers[each.symbol] = GiNaC::numeric(7, 5);
    return sign(value.subs(numbers));
  }

 private:
  const Mechanism& mechanism_;
  RationalArithmetic drawn_;
};

// Y_b at one state, row by row.
template <class State>
std::vector<std::vector<typename State::Scalar>> sampled_rows(const Function& function, State state) {
  const std::vector<typename State::Scalar> values = evaluate(function, state);
  const Output& Y = function.outputs.front();
  std::vector<std::vector<typename State::Scalar>> rows(static_cast<std::size_t>(Y.rows));
  for (int i = 0; i < Y.rows; ++i) {
    for (int k = 0; k < Y.cols; ++k) {
      const NodeId entry = Y.entries[static_cast<std::size_t>(i * Y.cols + k)];
      rows[static_cast<std::size_t>(i)].push_back(
          simplified<typename State::Scalar>(values[static_cast<std::size_t>(entry)]));
    }
  }
  return rows;
}

// A state modulo a large prime. Symbols have the same values in all states.
class DrawnState {
 public:
  using Arithmetic = ModPArithmetic<>;
  using Scalar = Arithmetic::Scalar;

  explicit DrawnState(std::uint64_t seed) : drawn_(seed) {}

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

// The rank of Y_b over all states, computed modulo a large prime, where that is cheap: exact elimination is not, with
// symbols and closed loops.
std::size_t rank_of(const Function& function) {
  RowSpace<F> space;
  const auto columns = static_cast<std::size_t>(function.outputs.front().cols);
  for (std::uint64_t seed = 1; seed <= most_states(function) && space.rank() < columns; ++seed) {
    for (std::vector<F>& row : sampled_rows(function, DrawnState(seed))) space.extend(std::move(row));
  }
  return space.rank();
}

// The echelon form of as many exact rows as the rank, each independent of those before it.
Echelon<Number> sampled_echelon(const Mechanism& mechanism, const Function& function, std::size_t rank) {
  ModPArithmetic<> arithmetic(1);
  const NumberMap<ModPArithmetic<>> field(mechanism.symbols, arithmetic);
  RowSpace<F> space;
  Rows rows;
  for (std::uint64_t seed = 1; seed <= most_states(function) && rows.size() < rank; ++seed) {
    for (std::vector<Number>& row : sampled_rows(function, SampledState(mechanism, seed))) {
      std::vector<F> image;
      std::transform(row.begin(), row.end(), std::back_inserter(image), field);
      if (space.extend(std::move(image))) rows.push_back(std::move(row));
    }
  }
  return reduced_echelon(std::move(rows), [&field](const Number& x) { return field(x) == F(0); });
}

// Sorts parameters so that elimination keeps the preferred ones: joint by joint, and within a joint by preference.
BaseParameters sorted_by_preference(const BaseParameters& base) {
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

void add_scaled(ParameterForm& form, const Number& factor, const ParameterForm& other) {
  for (const auto& [index, coefficient] : other) form[index] += factor * coefficient;
}

}  // namespace

BaseParameters reduced_at_coordinates(const Mechanism& mechanism, const BaseParameters& base) {
  if (base.columns.empty()) return base;
  const BaseParameters tree = sorted_by_preference(base);
  const Function sampled = sampled_function(mechanism, tree);
  const std::size_t rank = rank_of(sampled);
  if (rank == base.columns.size()) return base;
  const Echelon<Number> echelon = sampled_echelon(mechanism, sampled, rank);
  std::map<int, ParameterForm> kept;
  for (std::size_t r = 0; r < echelon.rows.size(); ++r) {
    ParameterForm& form = kept[tree.columns[echelon.pivots[r]]];
    for (std::size_t k = 0; k < echelon.rows[r].size(); ++k) {
      const Number& factor = echelon.rows[r][k];
      if (!factor.is_zero()) add_scaled(form, factor, tree.combination[k]);
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
