// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/pivot_ratio.hpp"

#include <algorithm>

#include "graph/arithmetic.hpp"
#include "robot/model/joint_points.hpp"
#include "robot/model/states.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {
namespace {

double smallest_pivot_ratio(Matrix<double> B) {
  double smallest = 1;
  std::vector<double> diagonal;
  for (int k = 0; k < B.rows(); ++k) diagonal.push_back(B(k, k));
  for (int k = B.rows() - 1; k >= 0; --k) {
    const double pivot = B(k, k), share = pivot / diagonal[static_cast<std::size_t>(k)];
    if (!(share > 0)) return 0;
    smallest = std::min(smallest, share);
    for (int i = 0; i < k; ++i) {
      for (int j = 0; j < k; ++j) B(i, j) -= B(k, i) / pivot * B(k, j);
    }
  }
  return smallest;
}

}  // namespace

double smallest_pivot_ratio(const Mechanism& mechanism) {
  constexpr int kPositions = 40;
  constexpr double kQuarterTurn = 1.5707963267948966;
  if (!mechanism.symbols.empty() || mechanism.has_loops()) return 1;
  std::vector<State> states = random_states(mechanism, kPositions, 1);
  for (const double q : {0.0, kQuarterTurn, -kQuarterTurn}) {
    states.emplace_back();
    states.back().q.assign(static_cast<std::size_t>(mechanism.position_count()), q);
    turn_spherical_joints(mechanism, q, states.back());
  }
  const State* at = nullptr;
  RealArithmetic<double> numbers(
      [&at](const Input& input) { return at->of(input.kind)[static_cast<std::size_t>(input.index)]; });
  double smallest = 1;
  for (const State& state : states) {
    at = &state;
    Lagrangian<double> lagrangian(mechanism_over(mechanism, numbers), joint_points(mechanism, numbers));
    smallest = std::min(smallest, smallest_pivot_ratio(lagrangian.inertia()));
  }
  return smallest;
}

}  // namespace flatdyn
