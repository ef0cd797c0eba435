// SPDX-License-Identifier: GPL-2.0-or-later
// What a function is compared with at a state, and how far a result is from it.
#pragma once

#include <functional>
#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/states.hpp"
#include "reference/reference_model.hpp"

namespace flatdyn {

struct Expected {
  std::function<std::vector<Real50>(const State&)> exact;           // from the recursive reference
  std::function<std::vector<double>(const State&)> rounded, scale;  // the reference in double; magnitudes
  std::function<std::vector<double>(const State&)> in_float;        // the reference in float
  // Whether the function has a value there; near a singularity of its task, or of a closed loop, it has none that
  // doubles could hold.
  std::function<bool(const State&)> is_regular;
};

// The recursive reference of one robot, with values for its free symbols.
class ExpectedValues {
 public:
  // All three must outlive it. `seed` draws the symbols' values.
  ExpectedValues(const Robot& robot, const Mechanism& mechanism, unsigned seed);

  const SymbolValues& symbols() const { return symbols_; }
  // The function must outlive the result.
  Expected of(const Function& function) const;
  // With dependent joints where they close the loops, if they can; states near a singularity of a loop are left out.
  // The functions have values at any others, too.
  std::vector<State> with_closed_loops(std::vector<State> states) const;

 private:
  bool is_clear_of_singular_loops(const State& state) const;
  Expected torques_and_poses(const Function& function) const;
  Expected regressor_of(const Function& function) const;

  const Robot& robot_;
  const Mechanism& mechanism_;
  SymbolValues symbols_;
  reference::Robot<Real50> exact_;
  reference::Robot<double> rounded_;
  reference::Robot<float> in_float_;
};

// Symbols by polarisation cost n² recursions each, regressors one per column.
bool costs_many_recursions(const Function& function);

// In 50 digits fewer states where n is large, and of functions that cost many recursions. At most `wanted`.
std::size_t affordable_states(const Function& function, std::size_t joints, std::size_t wanted);

// The largest over the entries of abs(x - exact) / (ε · magnitude), ε that of double. An entry with magnitude 0 must be
// 0 to the last bit.
double scaled_error(const std::vector<double>& x, const std::vector<Real50>& truth, const std::vector<double>& scale);

// Infinite for what is not a number.
double absolute_error(double x, const Real50& truth);

struct ErrorSummary {
  double largest = 0;
  double percentile_99 = 0;
};

// Of errors; zero if there are none.
ErrorSummary summary(std::vector<double> errors);

}  // namespace flatdyn
