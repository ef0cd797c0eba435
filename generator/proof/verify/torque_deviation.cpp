// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/torque_deviation.hpp"

#include <algorithm>
#include <cmath>

#include "functions/planning/formulations.hpp"
#include "robot/model/states.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

void push_to_limit(double& rate, const std::optional<Value>& limit) {
  if (limit) rate = std::copysign(nearest_double(limit->number), rate);
}

std::vector<State> states_within(const Mechanism& mechanism, bool at_rest, int count) {
  std::vector<State> states = random_states(mechanism, count, 1);
  for (std::size_t k = 0; k < states.size(); ++k) {
    State& state = states[k];
    for (std::size_t i = 0; i < state.qd.size() && k % 2 == 1; ++i) {
      const Limits& limits = mechanism.joint(static_cast<int>(i)).limits;
      push_to_limit(state.qd[i], limits.velocity);
      push_to_limit(state.qdd[i], limits.acceleration);
    }
    if (at_rest) std::fill(state.qd.begin(), state.qd.end(), 0.0);
  }
  return states;
}

}  // namespace

// Compared in double, so that rounding errors count, too.
bool TorqueDeviation::is_within(const Abbreviation& abbreviation) const {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    if (largest[i] > abbreviation.bound[i] + kRounding * (1 + abbreviation.budget[i])) return false;
  }
  return true;
}

TorqueDeviation torque_deviation(const Mechanism& whole, const Mechanism& part, bool at_rest, int states) {
  const Function of_whole = derive_function(whole, "inverse_dynamics"),
                 of_part = derive_function(part, "inverse_dynamics");
  GraphEvaluator<double> tau_whole(of_whole), tau_part(of_part);
  TorqueDeviation result{states, std::vector<double>(static_cast<std::size_t>(whole.size()), 0)};
  for (const State& state : states_within(whole, at_rest, states)) {
    const std::vector<double> x = *tau_whole(state), y = *tau_part(state);
    for (std::size_t i = 0; i < x.size(); ++i) result.largest[i] = std::max(result.largest[i], std::abs(x[i] - y[i]));
  }
  return result;
}

AbbreviationReport verify_abbreviated(const Mechanism& whole, const Abbreviation& abbreviation,
                                      const std::vector<Function>& functions, bool at_rest) {
  AbbreviationReport report;
  report.seen = torque_deviation(whole, abbreviation.mechanism, at_rest);
  report.passed = report.seen.is_within(abbreviation);
  for (const Function& function : functions) {
    report.exactly.push_back({function.name, prove_exactly(abbreviation.mechanism, function)});
    report.passed = report.passed && report.exactly.back().result.equal;
  }
  return report;
}

}  // namespace flatdyn
