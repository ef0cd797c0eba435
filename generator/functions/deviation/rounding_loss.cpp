// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/deviation/rounding_loss.hpp"

#include <algorithm>
#include <utility>

#include "functions/deviation/extreme_states.hpp"
#include "functions/deviation/rounding_error_meter.hpp"
#include "graph/tape.hpp"

namespace flatdyn {
namespace {

constexpr int kRandom = 100, kExtreme = 200;
constexpr std::size_t kStatesIfCostly = 8;  // number of states if one needs many recursions
constexpr unsigned kSeed = 1;

double loss_at(const Function& function, RoundingErrorMeter& meter, const std::vector<State>& states) {
  Tape tape(function);
  std::vector<double> values(tape.results());
  double worst = 0, reference = 1;
  const std::size_t count = costs_many_recursions(function) ? std::min(kStatesIfCostly, states.size()) : states.size();
  for (std::size_t k = 0; k < count; ++k) {
    const State& state = states[k];
    const auto truth = meter.truth(state);
    TapeInputs inputs;
    for (const InputKind kind : kArgumentKinds) inputs[kind] = state.of(kind);
    if (!truth || !tape.run(inputs, values)) continue;
    worst = std::max(worst, meter.error(values, *truth).scaled);
    reference = std::max(reference, meter.error(meter.reference(state), *truth).scaled);
  }
  return worst / reference;
}

}  // namespace

RoundingCheck::RoundingCheck(const Robot& robot, const Mechanism& mechanism)
    : expected_(robot, mechanism, kSeed),
      random_(with_parameters(random_states(mechanism, kRandom, kSeed), expected_.symbols())),
      extreme_(with_parameters(extreme_states(mechanism, kExtreme, kSeed), expected_.symbols())) {}

// The same values, each computed once. The states are those of this object.
Expected RoundingCheck::remembered(Expected expected) {
  const auto once = [this](auto Known::*member, auto compute) {
    return [this, member, compute = std::move(compute)](const State& state) {
      auto& value = known_[&state].*member;
      if (!value) value = compute(state);
      return *value;
    };
  };
  expected.is_regular = once(&Known::is_regular, std::move(expected.is_regular));
  expected.rounded = once(&Known::rounded, std::move(expected.rounded));
  expected.scale = once(&Known::scale, std::move(expected.scale));
  return expected;
}

double RoundingCheck::loss(const Function& function) {
  if (function.name != known_function_) {
    known_.clear();
    draw_own_arguments(random_, {&function, 1}, kSeed);
    draw_own_arguments(extreme_, {&function, 1}, kSeed);
  }
  known_function_ = function.name;
  RoundingErrorMeter meter(function, remembered(expected_.of(function)), "double");
  return std::max(loss_at(function, meter, random_), loss_at(function, meter, extreme_));
}

}  // namespace flatdyn
