// SPDX-License-Identifier: GPL-2.0-or-later
#include "reference/expected.hpp"

#include <algorithm>
#include <limits>

#include "definition/regressor_outputs.hpp"
#include "reference/operational_values.hpp"
#include "reference/regressor_reference.hpp"
#include "reference/values.hpp"

namespace flatdyn {
namespace {

std::vector<double> doubles(const std::vector<float>& values) { return {values.begin(), values.end()}; }

}  // namespace

ExpectedValues::ExpectedValues(const Robot& robot, const Mechanism& mechanism, unsigned seed)
    : robot_(robot),
      mechanism_(mechanism),
      symbols_(random_symbol_values(robot, seed)),
      exact_(reference_robot<Real50>(robot, symbols_)),
      rounded_(reference_robot<double>(robot, symbols_)),
      in_float_(reference_robot<float>(robot, symbols_)) {}

Expected ExpectedValues::of(const Function& function) const {
  return is_regressor(function.name) ? regressor_of(function) : torques_and_poses(function);
}

Expected ExpectedValues::torques_and_poses(const Function& function) const {
  const auto exact = seen_by(function, robot_, exact_);
  const auto rounded = seen_by(function, robot_, rounded_);
  const auto in_float = seen_by(function, robot_, in_float_);
  return {[&function, exact](const State& s) { return reference_values<Real50>(function, exact, widened<Real50>(s)); },
          [&function, rounded](const State& s) { return reference_values<double>(function, rounded, s); },
          [&function, rounded](const State& s) { return magnitudes(function, rounded, s); },
          [&function, in_float](const State& s) {
            return doubles(reference_values<float>(function, in_float, widened<float>(s)));
          },
          [this, &function, rounded](const State& s) {
            if (!is_clear_of_singular_loops(s)) return false;
            return function.task.empty() || is_regular(rounded, vector_of<double>(s.q), function.task);
          }};
}

Expected ExpectedValues::regressor_of(const Function& function) const {
  const RegressorReference<Real50> exact(mechanism_, exact_, symbols_, function.name);
  const RegressorReference<double> rounded(mechanism_, rounded_, symbols_, function.name);
  const RegressorReference<float> in_float(mechanism_, in_float_, symbols_, function.name);
  return {[exact](const State& s) { return exact.values(widened<Real50>(s)); },
          [rounded](const State& s) { return rounded.values(s); },
          [rounded](const State& s) { return magnitudes(rounded, s); },
          [in_float](const State& s) { return doubles(in_float.values(widened<float>(s))); },
          [this](const State& s) { return is_clear_of_singular_loops(s); }};
}

bool ExpectedValues::is_clear_of_singular_loops(const State& state) const {
  constexpr double kLeast = 1e-3;
  return rounded_.loops.empty() || reference::loop_regularity(rounded_, vector_of<double>(state.q)) > kLeast;
}

std::vector<State> ExpectedValues::with_closed_loops(std::vector<State> states) const {
  constexpr double kTolerance = 1e-12;  // m
  if (rounded_.loops.empty()) return states;
  for (State& state : states) {
    reference::VectorX<double> q = vector_of<double>(state.q);
    if (reference::close_loops(rounded_, q, kTolerance)) state.q.assign(q.begin(), q.end());
  }
  std::erase_if(states, [this](const State& state) { return !is_clear_of_singular_loops(state); });
  return states;
}

bool costs_many_recursions(const Function& function) {
  return function.name == "christoffel" || function.name == "coriolis_matrix" || is_regressor(function.name);
}

std::size_t affordable_states(const Function& function, std::size_t joints, std::size_t wanted) {
  const bool many = costs_many_recursions(function);
  const std::size_t n = std::max<std::size_t>(1, joints);
  const std::size_t affordable = many ? std::max<std::size_t>(2, 1500 / (n * n)) : std::max<std::size_t>(10, 2000 / n);
  return std::min(wanted, affordable);
}

double absolute_error(double x, const Real50& truth) {
  const double difference = Real50(abs(Real50(x) - truth)).convert_to<double>();
  return difference >= 0 ? difference : std::numeric_limits<double>::infinity();
}

double scaled_error(const std::vector<double>& x, const std::vector<Real50>& truth, const std::vector<double>& scale) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  double largest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double difference = absolute_error(x[k], truth[k]);
    if (difference > 0) {
      const bool has_scale = scale[k] > 0;
      largest =
          std::max(largest, has_scale ? difference / (kEpsilon * scale[k]) : std::numeric_limits<double>::infinity());
    }
  }
  return largest;
}

ErrorSummary summary(std::vector<double> errors) {
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  const std::size_t k = errors.size() * 99 / 100;
  return {errors.back(), errors[std::min(k, errors.size() - 1)]};
}

}  // namespace flatdyn
