// SPDX-License-Identifier: GPL-2.0-or-later
// How far results in float or double are from the truth, on the scale of the terms that make them up.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graph/tape.hpp"
#include "reference/expected.hpp"
#include "reference/values.hpp"

namespace flatdyn {

// Of the entry with the largest scaled error. Its condition is the size of its terms over its own size: with it,
// rounding errors of the terms, which nobody can avoid, become relative errors of the entry.
struct RoundingError {
  double scaled = 0;  // in units of the last place of the scalar, of the terms' size; infinite where it should be zero
  double condition = 1;  // infinite where the entry is zero, and not its terms
  double relative = 0;   // error over the entry, in units of the last place of the scalar
};

// What an entry has to be, and the sum of the absolute values of its terms.
template <class Wide>
struct EntryTruth {
  std::vector<Wide> values;
  std::vector<double> scale;
};

class RoundingJudge {
 public:
  // Both must outlive it. `scalar`: "float" or "double".
  RoundingJudge(const Function& function, Expected expected, const std::string& scalar);

  // The state as this scalar holds it.
  State given(const State& state) const { return is_float_ ? in_float(state) : state; }
  // From the function's own graph in long double, which is enough to see errors of the scalars; fast.
  // Nothing where the function does not hold.
  std::optional<EntryTruth<long double>> truth(const State& given);
  // From the recursive reference in 50 digits.
  EntryTruth<Real50> exact_truth(const State& given) const;
  // What the recursive reference comes to in this scalar.
  std::vector<double> reference(const State& given) const;

  template <class Wide>
  RoundingError error(const std::vector<double>& values, const EntryTruth<Wide>& truth) const;

  double epsilon() const { return epsilon_; }

 private:
  bool is_float_;
  double epsilon_, underflow_;
  Expected expected_;
  TapeOf<long double> graph_;
};

extern template RoundingError RoundingJudge::error(const std::vector<double>&, const EntryTruth<long double>&) const;
extern template RoundingError RoundingJudge::error(const std::vector<double>&, const EntryTruth<Real50>&) const;

}  // namespace flatdyn
