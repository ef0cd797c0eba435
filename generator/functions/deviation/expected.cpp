// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/deviation/expected.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "functions/deviation/derivative_reference.hpp"
#include "functions/formulation.hpp"
#include "functions/function_table.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/operational_values.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn {
namespace {

constexpr int kFloatBits = std::numeric_limits<float>::digits;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> absolute(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

}  // namespace

ExpectedValues::ExpectedValues(const Robot& robot, const Mechanism& mechanism, unsigned seed)
    : robot_(robot),
      mechanism_(mechanism),
      symbols_(random_symbol_values(robot, seed)),
      exact_(reference_robot<Real50>(robot, symbols_)),
      rounded_(reference_robot<double>(robot, symbols_)) {}

// The reference with all numbers rounded to 24 bits, made at the first state.
std::function<std::vector<double>(const State&)> ExpectedValues::in_float(const Function& function) const {
  return [this, &function, reference = ReferenceFunction<Real50>()](const State& state) mutable {
    const Real50::Precision of_float(kFloatBits);
    if (!reference) {
      reference = row_of(function).reference.exact({mechanism_, robot_for_function(function, robot_, exact_), symbols_},
                                                   function);
    }
    std::vector<double> values;
    for (const Real50& value : reference(widened<Real50>(state))) values.push_back(value.convert_to<double>());
    return values;
  };
}

// Derivatives in double and in 24 bits are those of the graph as it is derived.
Expected ExpectedValues::of_derivatives(const Function& function) const {
  const auto reference = std::make_shared<DerivativeReference>(robot_, mechanism_, symbols_, function);
  const auto derived = std::make_shared<Function>(derive_function(mechanism_, function.name));
  const auto values = [this, derived, graph = std::make_shared<GraphEvaluator<double>>(*derived)](const State& state) {
    const auto found = (*graph)(with_unit_quaternions(mechanism_, state));
    return found.value_or(std::vector<double>(entry_count(*derived), kNaN));
  };
  const auto values_in_float = [this, derived,
                                graph = std::make_shared<GraphEvaluator<Real50>>(*derived)](const State& state) {
    const Real50::Precision of_float(kFloatBits);
    const auto found = (*graph)(with_unit_quaternions(mechanism_, widened<Real50>(state)));
    std::vector<double> rounded(entry_count(*derived), kNaN);
    for (std::size_t k = 0; found && k < rounded.size(); ++k) rounded[k] = (*found)[k].convert_to<double>();
    return rounded;
  };
  return {[reference](const State& s) { return reference->exact(widened<Real50>(s)); },
          values,
          [reference](const State& s) { return reference->magnitude(s); },
          values_in_float,
          regularity(function),
          mechanism_.quaternions()};
}

// Whether the function has a value at a state.
std::function<bool(const State&)> ExpectedValues::regularity(const Function& function) const {
  const reference::Robot<double> robot = robot_for_function(function, robot_, rounded_);
  const FunctionRow& row = row_of(function);
  const FunctionRow& of = row.differentiated == nullptr ? row : *row.differentiated;
  const bool has_gaps = row.traits.has_gaps;
  ReferenceFunction<double> reference;
  if (has_gaps) reference = of.reference.in_double({mechanism_, robot, symbols_}, function);
  return [this, &function, robot, has_gaps, reference](const State& s) {
    if (!is_clear_of_singular_loops(s)) return false;
    if (has_gaps) return !std::isnan(reference(s).front());
    if (function.task.empty()) return true;
    if (!mechanism_.has_spherical_joints()) return is_regular(robot, vector_of<double>(s.q), function.task);
    reference::Robot<double> turned = robot;
    const State rest = without_quaternions(turned, s);
    return is_regular(turned, vector_of<double>(rest.q), function.task);
  };
}

Expected ExpectedValues::of(const Function& function) const {
  if (row_of(function).differentiated != nullptr) return of_derivatives(function);
  const NumericReference& reference = row_of(function).reference;
  const auto rounded_robot = robot_for_function(function, robot_, rounded_);
  const auto exact = reference.exact({mechanism_, robot_for_function(function, robot_, exact_), symbols_}, function);
  const auto rounded = reference.in_double({mechanism_, rounded_robot, symbols_}, function);
  const auto magnitude = reference.magnitude({mechanism_, rounded_robot, symbols_}, function);
  return {[exact](const State& s) { return exact(widened<Real50>(s)); },
          rounded,
          [magnitude](const State& s) { return absolute(magnitude(s)); },
          in_float(function),
          regularity(function),
          mechanism_.quaternions()};
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
  const FunctionRow& row = row_of(function);
  return row.differentiated != nullptr || row.reference.needs_many_recursions;
}

std::size_t affordable_states(const Function& function, std::size_t joints, std::size_t wanted) {
  const std::size_t n = std::max<std::size_t>(1, joints);
  // A difference has nine values, one difference for each entry of each argument.
  if (row_of(function).differentiated != nullptr) return std::min(wanted, std::max<std::size_t>(2, 200 / (n * n)));
  const bool many = costs_many_recursions(function);
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
