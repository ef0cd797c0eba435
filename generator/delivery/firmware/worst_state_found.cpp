// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/firmware/worst_state_found.hpp"

#include <algorithm>
#include <cmath>

#include "code/readback/straight_line_values.hpp"
#include "laboratory/stress/worst_state.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

// Evaluations in 50 digits; more of them find little more (docs/firmware.md).
constexpr int kEvaluations = 400;
constexpr unsigned kSearchSeed = 1;

class Search {
 public:
  Search(const Function& function, const StraightLine& text, const Expected& expected, bool is_float)
      : function_(function), text_(text), expected_(expected), is_float_(is_float), exact_(function) {}

  State given(const State& state) const { return state_for(function_, is_float_ ? in_float(state) : state); }

  // The scaled error; 0 if the function has no value in either arithmetic.
  double error(const State& searched) {
    const State state = given(searched);
    if (!expected_.is_regular(state)) return 0;
    const std::optional<std::vector<Real50>> truth = exact_(widened<Real50>(state));
    if (!truth) return 0;
    const double error = scaled_error(kept_values(function_, executed(state)), kept_values(function_, *truth),
                                      kept_values(function_, expected_.scale(state)));
    return std::isfinite(error) ? error : 0;
  }

 private:
  std::vector<double> executed(const State& state) const {
    return is_float_ ? outputs_of<float>(text_, state, sines<float>(state))
                     : outputs_of<double>(text_, state, sines<double>(state));
  }

  template <class T>
  static SinesAndCosines sines(const State& state) {
    SinesAndCosines all;
    for (const double q : state.q) {
      all.sine.push_back(sin(Real50(q)).convert_to<T>());
      all.cosine.push_back(cos(Real50(q)).convert_to<T>());
    }
    return all;
  }

  const Function& function_;
  const StraightLine& text_;
  const Expected& expected_;
  bool is_float_;
  GraphEvaluator<Real50> exact_;
};

}  // namespace

std::optional<State> worst_state_found(const Function& function, const StraightLine& text, const Expected& expected,
                                       const std::vector<State>& pool, const std::string& scalar) {
  Search search(function, text, expected, scalar == "float");
  const SearchedState found =
      worst_state([&search](const State& state) { return search.error(state); }, pool, kEvaluations, kSearchSeed);
  if (!(found.error > 0)) return std::nullopt;
  return search.given(found.state);
}

}  // namespace flatdyn
