// SPDX-License-Identifier: GPL-2.0-or-later
// The values that a function is compared with at a state, and the deviation of a result from them.
#pragma once

#include <functional>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

struct Expected {
  std::function<std::vector<Real50>(const State&)> exact;  // by the recursive reference
  // By the reference in double; magnitudes of the terms.
  std::function<std::vector<double>(const State&)> rounded, scale;
  std::function<std::vector<double>(const State&)> in_float;  // by the reference in 24 bits, as float has
  // Whether the function has a value at the state. Near a singularity of its task, or of a closed loop, it has none
  // that doubles could hold.
  std::function<bool(const State&)> is_regular;
  std::vector<int> quaternions = {};  // the first entries in q of those of spherical joints
};

// The recursive reference of one robot, with values of its free symbols.
class ExpectedValues {
 public:
  // The robot and the mechanism must outlive this object. `seed` determines the symbols' values.
  ExpectedValues(const Robot& robot, const Mechanism& mechanism, unsigned seed);

  const SymbolValues& symbols() const { return symbols_; }
  // The expected values of a function, which must outlive the result.
  Expected of(const Function& function) const;
  // Sets dependent joints so that the loops are closed, where that is possible; leaves out states near a singularity of
  // a loop. The functions have values at states with open loops, too.
  std::vector<State> with_closed_loops(std::vector<State> states) const;

 private:
  Expected of_derivatives(const Function& function) const;
  std::function<std::vector<double>(const State&)> in_float(const Function& function) const;
  std::function<bool(const State&)> regularity(const Function& function) const;
  bool is_clear_of_singular_loops(const State& state) const;

  const Robot& robot_;
  const Mechanism& mechanism_;
  SymbolValues symbols_;
  reference::Robot<Real50> exact_;
  reference::Robot<double> rounded_;
};

// The row's NumericReference::needs_many_recursions.
bool costs_many_recursions(const Function& function);

// The number of states, at most `wanted`, for a comparison in 50 digits: fewer for large n and for functions that need
// many recursions.
std::size_t affordable_states(const Function& function, std::size_t joints, std::size_t wanted);

// The largest abs(x - exact) / (ε · magnitude) over the entries, with ε that of double. An entry with magnitude 0 must
// be exactly 0.
double scaled_error(const std::vector<double>& x, const std::vector<Real50>& truth, const std::vector<double>& scale);

// abs(x - truth); infinite if x is not a number.
double absolute_error(double x, const Real50& truth);

struct ErrorSummary {
  double largest = 0;
  double percentile_99 = 0;
};

// The summary of errors; zero if there are none.
ErrorSummary summary(std::vector<double> errors);

}  // namespace flatdyn
