// SPDX-License-Identifier: GPL-2.0-or-later
// The deviation of results in float or double from the truth, measured against the size of the terms that they are sums
// of.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "functions/deviation/expected.hpp"
#include "graph/tape.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {

// The error of the entry with the largest scaled error. Its condition is the size of its terms divided by its own size:
// by this factor, unavoidable rounding errors of the terms become relative errors of the entry.
struct RoundingError {
  // In units of the last place of the scalar at the terms' size; infinite if the entry should be zero.
  double scaled = 0;
  double condition = 1;  // infinite if the entry is zero but its terms are not
  double relative = 0;   // error divided by the entry, in units of the last place of the scalar
};

// The true value of an entry, and the sum of the absolute values of its terms.
template <class Wide>
struct EntryTruth {
  std::vector<Wide> values;
  std::vector<double> scale;
};

class RoundingErrorMeter {
 public:
  // The function, and the objects behind `expected`, must outlive this object. `scalar`: "float" or "double".
  RoundingErrorMeter(const Function& function, Expected expected, const std::string& scalar);

  // The state rounded to this scalar, with unit quaternions.
  State given(const State& state) const {
    const State turned = with_unit_quaternions(expected_.quaternions, state);
    return is_float_ ? in_float(turned) : turned;
  }
  // The truth from the function's own graph in long double, which is fast and accurate enough to see errors of the
  // scalars. Nothing if the function has no value at the state.
  std::optional<EntryTruth<long double>> truth(const State& given);
  // The truth from the recursive reference in 50 digits.
  EntryTruth<Real50> exact_truth(const State& given) const;
  // The result of the recursive reference in this scalar.
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

extern template RoundingError RoundingErrorMeter::error(const std::vector<double>&,
                                                        const EntryTruth<long double>&) const;
extern template RoundingError RoundingErrorMeter::error(const std::vector<double>&, const EntryTruth<Real50>&) const;

}  // namespace flatdyn
