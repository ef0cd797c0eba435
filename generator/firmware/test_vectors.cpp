// SPDX-License-Identifier: GPL-2.0-or-later
#include "firmware/test_vectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verify/expected.hpp"
#include "verify/values.hpp"

namespace flatdyn {
namespace {

constexpr int kRandomStates = 8, kEdgeStates = 4;
constexpr unsigned kSeed = 1;

std::vector<State> chosen_states(const Mechanism& mechanism, const SymbolValues& symbols, const std::string& scalar) {
  std::vector<State> states = random_states(mechanism, kRandomStates, kSeed);
  const std::vector<State> edges = edge_states(mechanism);
  for (std::size_t k = 0; k < kEdgeStates && !edges.empty(); ++k) {
    states.push_back(edges[k * (edges.size() - 1) / (kEdgeStates - 1)]);
  }
  states = with_parameters(std::move(states), symbols);
  if (scalar == "float") {
    for (State& state : states) state = in_float(state);
  }
  return states;
}

// Sums of parallel joints' angles are rounded, too: where angles are of more than a turn, the sum's last place is worth
// this many of an angle's below 1.
double angle_rounding(const State& state) {
  double sum = 1;
  for (const double q : state.q) sum += std::abs(q) > 2 * std::numbers::pi ? std::abs(q) : 0;
  return sum;
}

ExpectedEntry entry_of(const Real50& value, double allowed) {
  const auto exact = value.convert_to<double>();
  return {exact, Real50(value - exact).convert_to<double>(), allowed};
}

}  // namespace

TestVectors test_vectors(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                         const std::string& scalar) {
  const double epsilon =
      scalar == "float" ? double(std::numeric_limits<float>::epsilon()) : std::numeric_limits<double>::epsilon();
  const ExpectedValues values(robot, mechanism, kSeed);
  std::vector<Expected> expected;
  for (const Function& function : functions) expected.push_back(values.of(function));
  TestVectors result;
  for (State& state : chosen_states(mechanism, values.symbols(), scalar)) {
    // Where a function has no value, nothing is to be tested.
    const bool is_regular =
        std::all_of(expected.begin(), expected.end(), [&state](const Expected& e) { return e.is_regular(state); });
    if (is_regular) result.states.push_back(std::move(state));
  }
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const Function& function = functions[f];
    result.expected.emplace_back();
    for (const State& given : result.states) {
      const State state = state_for(function, given);
      const std::vector<Real50> exact = expected[f].exact(state);
      const std::vector<double> scale = expected[f].scale(state);
      const double units = kAllowedUnits * angle_rounding(state);
      std::size_t k = 0;
      for (const Output& output : function.outputs) {
        for (std::size_t e = 0; e < output.entries.size(); ++e, ++k) {
          const double allowed = output.leaves_out(e) ? -1 : units * epsilon * scale[k];
          result.expected.back().push_back(entry_of(exact[k], allowed));
        }
      }
    }
  }
  return result;
}

}  // namespace flatdyn
