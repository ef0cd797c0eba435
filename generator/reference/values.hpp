// SPDX-License-Identifier: GPL-2.0-or-later
// The value of a function at a state, from its graph and from the reference; and the magnitude that its error is
// measured against.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "graph/function.hpp"
#include "model/states.hpp"
#include "reference/reference_model.hpp"

namespace flatdyn {

// Evaluates one function's graph at many states: its constants are converted once. The function must outlive it.
template <class S>
class GraphEvaluator {
 public:
  explicit GraphEvaluator(const Function& function) : function_(function) {}

  // Entries of all outputs, in order; nullopt where a condition of the function does not hold (a pivot of B that is not
  // positive).
  std::optional<std::vector<S>> operator()(const StateOf<S>& state);

 private:
  const Function& function_;
  std::unordered_map<const Rational*, S> constants_;
};

// The same entries from the recursive Newton–Euler reference.
template <class S>
std::vector<S> reference_values(const Function& function, const reference::Robot<S>& robot, const StateOf<S>& state);

// The robot as a function sees it: one of a named link ("jacobian:hand") takes that link's frame for the tip.
template <class S>
reference::Robot<S> seen_by(const Function& function, const Robot& written, reference::Robot<S> robot) {
  const std::size_t colon = function.name.find(':');
  if (colon == std::string::npos) return robot;
  for (std::size_t l = 0; l < written.links.size(); ++l) {
    if (written.links[l].name == function.name.substr(colon + 1)) robot.tip = static_cast<int>(l);
  }
  robot.R_tip.setIdentity();
  robot.p_tip.setZero();
  return robot;
}

// The values that are not left out, of all entries of all outputs.
template <class T>
std::vector<T> kept_values(const Function& function, const std::vector<T>& all) {
  std::vector<T> kept;
  std::size_t k = 0;
  for (const Output& output : function.outputs) {
    for (std::size_t e = 0; e < output.entries.size(); ++e, ++k) {
      if (!output.leaves_out(e)) kept.push_back(all[k]);
    }
  }
  return kept;
}

// The state in which the function holds.
template <class S>
StateOf<S> state_for(const Function& function, StateOf<S> state) {
  if (function.at_rest) state.qd.assign(state.qd.size(), S(0));
  return state;
}

// The sum of the absolute values of each entry's own terms (flatdyn/reference/magnitude.hpp).
std::vector<double> magnitudes(const Function& function, const reference::Robot<double>& robot, const State& state);

}  // namespace flatdyn
