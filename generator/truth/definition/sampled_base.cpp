// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/sampled_base.hpp"

#include <random>

#include "derivation/kernel/elimination.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/joint_points.hpp"
#include "truth/definition/joint_signs.hpp"
#include "truth/definition/lagrangian_regressor.hpp"

namespace flatdyn {
namespace {

template <std::uint64_t P>
class Samples {
 public:
  using F = ModP<P>;
  using Rows = std::vector<std::vector<F>>;

  Samples(const Mechanism& mechanism, std::uint64_t seed)
      : arithmetic_(seed), engine_(seed), mechanism_(mechanism), field_(mechanism_over(mechanism, arithmetic_)) {}

  // Appends the rows of Y at one random state, with the columns listed.
  void append(const std::vector<int>& columns, Rows& rows) {
    ModPArithmetic<P> state(engine_());
    const LagrangianRegressor<F> lagrangian(field_, joint_points(mechanism_, state));
    const auto n = static_cast<std::size_t>(mechanism_.size());
    const Matrix<F> Y = lagrangian.regressor(drawn(n), drawn(n), joint_signs(mechanism_, state, InputKind::qd));
    for (int i = 0; i < Y.rows(); ++i) {
      std::vector<F> row;
      for (const int column : columns) row.push_back(Y(i, column));
      rows.push_back(std::move(row));
    }
  }

  ModPArithmetic<P>& arithmetic() { return arithmetic_; }

 private:
  std::vector<F> drawn(std::size_t count) {
    std::vector<F> values;
    for (std::size_t k = 0; k < count; ++k) values.emplace_back(engine_());
    return values;
  }

  ModPArithmetic<P> arithmetic_;
  std::mt19937_64 engine_;
  const Mechanism& mechanism_;
  MechanismOver<F> field_;
};

// The columns in the order in which base_parameters() keeps them.
std::vector<int> columns_of(const Mechanism& mechanism, ParameterSet set) {
  const std::vector<bool> present = parameters_in(mechanism, set);
  std::vector<int> columns;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    for (const Parameter p : kPreference) {
      if (present[static_cast<std::size_t>(index_of(i, p))]) columns.push_back(index_of(i, p));
    }
  }
  return columns;
}

// The echelon form of samples; sampling ends when two more states bring no new row.
template <std::uint64_t P>
Echelon<ModP<P>> sampled_echelon(Samples<P>& samples, const std::vector<int>& columns, int joints) {
  const auto is_zero = [](const ModP<P>& x) { return x == ModP<P>(0); };
  typename Samples<P>::Rows rows;
  const int states = joints == 0 ? 0 : static_cast<int>(columns.size()) / joints + 1;
  for (int k = 0; k < states; ++k) samples.append(columns, rows);
  Echelon<ModP<P>> echelon = reduced_echelon(std::move(rows), is_zero);
  for (;;) {
    const std::size_t rank = echelon.rows.size();
    rows = std::move(echelon.rows);
    samples.append(columns, rows);
    samples.append(columns, rows);
    echelon = reduced_echelon(std::move(rows), is_zero);
    if (echelon.rows.size() == rank) return echelon;
  }
}

template <std::uint64_t P>
SampledComparison compare_modulo(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set,
                                 std::uint64_t seed) {
  using F = ModP<P>;
  Samples<P> samples(mechanism, seed);
  const std::vector<int> columns = columns_of(mechanism, set);
  const Echelon<F> echelon = sampled_echelon(samples, columns, mechanism.size());
  SampledComparison result{static_cast<int>(echelon.rows.size()), echelon.rows.size() == base.columns.size()};
  const NumberMap<ModPArithmetic<P>> field(mechanism.symbols, samples.arithmetic());
  for (std::size_t r = 0; r < echelon.rows.size() && result.equal; ++r) {
    const int kept = columns[echelon.pivots[r]];
    const auto found = std::find(base.columns.begin(), base.columns.end(), kept);
    if (found == base.columns.end()) result.equal = false;
    if (!result.equal) break;
    const ParameterForm& form = base.combination[static_cast<std::size_t>(found - base.columns.begin())];
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto term = form.find(columns[c]);
      const F expected = term == form.end() ? F(0) : field(term->second);
      if (!(expected == echelon.rows[r][c])) result.equal = false;
    }
  }
  return result;
}

}  // namespace

SampledComparison compare_with_samples(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set,
                                       std::uint64_t seed) {
  SampledComparison result = compare_modulo<kMersenne61>(mechanism, base, set, seed);
  for (const SampledComparison& other : {compare_modulo<kPrime61b>(mechanism, base, set, seed + 1),
                                         compare_modulo<kPrime61c>(mechanism, base, set, seed + 2)}) {
    result.equal = result.equal && other.equal && other.rank == result.rank;
  }
  return result;
}

}  // namespace flatdyn
