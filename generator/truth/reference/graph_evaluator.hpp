// SPDX-License-Identifier: GPL-2.0-or-later
// The value of a function at a state, from its graph.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/states.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

// Evaluates one function's graph at many states, converting its constants once. The function must outlive this object.
template <class S>
class GraphEvaluator {
 public:
  explicit GraphEvaluator(const Function& function) : function_(function) {}

  // The entries of all outputs, in order; nullopt if a condition of the function does not hold (a pivot of B that is
  // not positive).
  std::optional<std::vector<S>> operator()(const StateOf<S>& state);

 private:
  const Function& function_;
  std::unordered_map<const Rational*, S> constants_;
};

// The values, among those of all entries of all outputs, that are not left out.
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

// The state at which the function holds: q̇ = 0 if it holds at rest only.
template <class S>
StateOf<S> state_for(const Function& function, StateOf<S> state) {
  if (function.at_rest) state.qd.assign(state.qd.size(), S(0));
  return state;
}

}  // namespace flatdyn
