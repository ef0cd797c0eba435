// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/firmware/test_vectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/emitted_text.hpp"
#include "delivery/firmware/proven_bounds.hpp"
#include "delivery/firmware/worst_state_found.hpp"
#include "functions/deviation/expected.hpp"
#include "robot/model/angles.hpp"
#include "robot/model/rounded_up.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

constexpr int kRandomStates = 8, kEdgeStates = 4, kSearchedStates = 100;
constexpr unsigned kSeed = 1;

std::vector<State> in_scalar(std::vector<State> states, const SymbolValues& symbols, const std::string& scalar) {
  states = with_parameters(std::move(states), symbols);
  if (scalar == "float") {
    for (State& state : states) state = in_float(state);
  }
  return states;
}

std::vector<State> random_and_extreme(const Mechanism& mechanism) {
  std::vector<State> states = random_states(mechanism, kRandomStates, kSeed);
  const std::vector<State> edges = edge_states(mechanism);
  for (std::size_t k = 0; k < kEdgeStates && !edges.empty(); ++k) {
    states.push_back(edges[k * (edges.size() - 1) / (kEdgeStates - 1)]);
  }
  return states;
}

// The factor by which angles of many turns round worse. Sums of parallel joints' angles are rounded, too: beyond a
// turn, the last place of a sum is this many times that of an angle below 1.
double angle_rounding(const State& state) {
  double sum = 1;
  for (const double q : state.q) sum += std::abs(q) > 2 * std::numbers::pi ? std::abs(q) : 0;
  return sum;
}

// The digits of allowed errors: the last ones come from sines of <cmath>, which differ between machines.
constexpr int kAllowedDigits = 4;

// Sets values below the reference's own rounding to 0: entries that are computed without an error are proven to be
// equal.
double without_noise(const Real50& x, double scale) {
  constexpr double kNoise = 1e-45;
  return abs(x) <= kNoise * scale ? 0 : x.convert_to<double>();
}

ExpectedEntry entry_of(const Real50& value, double scale, double allowed, double proven) {
  const double exact = without_noise(value, scale);
  return {exact, without_noise(value - exact, scale), allowed, proven};
}

// The functions' text as the target executes it: all forms of the text compute the same bits.
EmittedText text_of(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& form) {
  EmitOptions options;
  options.scalar = form.scalar;
  options.fuses = form.fuses;
  return EmittedText(emit_header(mechanism, functions, options), header_reader());
}

class VectorMaker {
 public:
  VectorMaker(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
              const EmitOptions& form)
      : mechanism_(mechanism),
        functions_(functions),
        scalar_(form.scalar),
        values_(robot, mechanism, kSeed),
        text_(text_of(mechanism, functions, form)) {
    for (const Function& function : functions) expected_.push_back(values_.of(function));
  }

  TestVectors run(Progress& progress) {
    take_states(random_and_extreme(mechanism_));
    const std::vector<State> pool =
        in_scalar(random_states(mechanism_, kSearchedStates, kSeed), values_.symbols(), scalar_);
    for (std::size_t f = 0; f < functions_.size(); ++f) {
      progress.step("looking for the worst state of " + functions_[f].name);
      const auto worst =
          worst_state_found(functions_[f], text_.operations(f, functions_[f]), expected_[f], pool, scalar_);
      if (worst && is_regular(*worst)) result_.states.push_back(*worst);
    }
    for (std::size_t f = 0; f < functions_.size(); ++f) expect(f, progress);
    return std::move(result_);
  }

 private:
  // Whether all functions have values at the state; otherwise there is nothing to test.
  bool is_regular(const State& state) const {
    return std::all_of(expected_.begin(), expected_.end(), [&state](const Expected& e) { return e.is_regular(state); });
  }

  void take_states(std::vector<State> states) {
    for (State& state : in_scalar(std::move(states), values_.symbols(), scalar_)) {
      if (is_regular(state)) result_.states.push_back(std::move(state));
    }
  }

  void expect(std::size_t f, Progress& progress) {
    const Function& function = functions_[f];
    const ProvenBounds bounds(mechanism_, functions_, text_, f, scalar_, progress);
    result_.expected.emplace_back();
    for (const State& given : result_.states) {
      const State state = state_for(function, given);
      const std::vector<Real50> exact = expected_[f].exact(state);
      const std::vector<double> scale = expected_[f].scale(state), proven = bounds.at(state);
      const double unit = kAllowedUnits * largest_angle_factor(mechanism_) * angle_rounding(state) * epsilon();
      std::size_t k = 0;
      for (const Output& output : function.outputs) {
        for (std::size_t e = 0; e < output.entries.size(); ++e, ++k) {
          const double allowed = output.leaves_out(e) ? -1 : rounded_up(unit * scale[k], kAllowedDigits);
          result_.expected.back().push_back(entry_of(exact[k], scale[k], allowed, proven[k]));
        }
      }
    }
  }

  double epsilon() const {
    return scalar_ == "float" ? double(std::numeric_limits<float>::epsilon()) : std::numeric_limits<double>::epsilon();
  }

  const Mechanism& mechanism_;
  const std::vector<Function>& functions_;
  std::string scalar_;
  ExpectedValues values_;
  EmittedText text_;
  std::vector<Expected> expected_;
  TestVectors result_;
};

}  // namespace

TestVectors test_vectors(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                         const EmitOptions& form, Progress& progress) {
  return VectorMaker(robot, mechanism, functions, form).run(progress);
}

}  // namespace flatdyn
