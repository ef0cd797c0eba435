// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/deviation/derivative_reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "functions/formulation.hpp"
#include "functions/function_table.hpp"
#include "graph/function_name.hpp"
#include "truth/reference/acceleration_magnitude.hpp"
#include "truth/reference/magnitude.hpp"
#include "truth/reference/motion_magnitude.hpp"

namespace flatdyn {
namespace {

constexpr int kNodes = 9;  // of a difference; its error is the step's power of as many
const char* const kStep = "1e-6";
const char* const kShortStep =
    "1e-9";  // of steps in time, which may be as short as a millisecond, and near singular loops
const char* const kShortestStep = "1e-13";  // by its length: at high speed angles change a thousand times as fast
const char* const kRounding = "1e-50";
const char* const kRoundingOfSolutions = "1e-46";  // of equations that steps and closed loops solve
constexpr int kDigits = 60;                        // of a Real50

// The factors of the values at 1, 2, …, kNodes steps whose sum is the derivative at 0, times the step: the derivatives
// at 0 of Lagrange's polynomials.
std::vector<Real50> difference_factors() {
  std::vector<Real50> factors;
  for (int j = 1; j <= kNodes; ++j) {
    Real50 factor(0);
    for (int m = 1; m <= kNodes; ++m) {
      if (m == j) continue;
      Real50 term = Real50(1) / Real50(j - m);
      for (int l = 1; l <= kNodes; ++l) {
        if (l != j && l != m) term *= Real50(-l) / Real50(j - l);
      }
      factor += term;
    }
    factors.push_back(factor);
  }
  return factors;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& each : values) each *= factor;
  return values;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t e = 0; e < a.size(); ++e) a[e] += b[e];
  return a;
}

// By how much magnitudes differ.
std::vector<double> difference(std::vector<double> there, const std::vector<double>& here) {
  for (std::size_t e = 0; e < there.size(); ++e) there[e] = std::abs(std::abs(there[e]) - std::abs(here[e]));
  return there;
}

// The magnitudes of derivatives by the length h of a step: terms have at most this power of h, or of 1/h, and sines of
// angles that are proportional to it, the first entries.
std::vector<double> by_step_length(std::vector<double> magnitudes, std::size_t positions, double h) {
  constexpr double kPower = 8;
  double angle = 0;
  for (std::size_t k = 0; k < positions; ++k) angle = std::max(angle, magnitudes[k]);
  for (double& each : magnitudes) each *= (kPower + angle) / std::abs(h);
  return magnitudes;
}

// The function that is differentiated, as far as it is known without its graph.
Function without_graph(const Function& derivatives) {
  Function function;
  function.name = parts_of_name(derivatives.name).of_whole();
  for (const InputKind kind : derivatives.inputs) {
    if (argument_row(kind).length != ArgumentLength::own) function.inputs.push_back(kind);
  }
  function.base_parameters = derivatives.base_parameters;
  function.task = derivatives.task;
  return function;
}

reference::Robot<double> with_slopes(reference::Robot<double> robot) {
  for (reference::Joint<double>& joint : robot.joints) {
    joint.viscous = std::abs(joint.viscous) + reference::dry_friction_slope_magnitude(joint);
  }
  return robot;
}

double steepness_of(const reference::Robot<double>& robot) {
  double steepness = 1;
  for (const reference::Joint<double>& joint : robot.joints) {
    for (const double speed : {joint.dry.speed, joint.dry.stribeck_speed}) {
      if (speed > 0) steepness = std::max(steepness, 1 / speed);
    }
  }
  return steepness;
}

}  // namespace

DerivativeReference::DerivativeReference(const Robot& robot, const Mechanism& mechanism, const SymbolValues& symbols,
                                         const Function& derivatives)
    : robot_(robot),
      mechanism_(mechanism),
      symbols_(symbols),
      function_(without_graph(derivatives)),
      row_(*row_of(derivatives).differentiated),
      derivative_(row_of(derivatives).derivative),
      rounded_(robot_for_function(function_, robot, reference_robot<double>(robot, symbols))),
      steep_(with_slopes(rounded_)),
      steepness_(steepness_of(rounded_)) {
  const Tangents tangents(mechanism, function_.inputs, function_.base_parameters);
  for (const TangentBlock& block : tangents.blocks()) {
    for (int entry = 0; entry < block.length; ++entry) directions_.push_back({block.kind, entry});
  }
  places_ = derivative_places(derivatives, derivative_, tangents).entries;
  if (derivative_ == Derivative::contracted_hessian) {
    gradient_ = derive_function(mechanism, name_of_differentiated(derivatives.name));
    gradient_at_ = std::make_unique<GraphEvaluator<Real50>>(*gradient_);
  }
  exact_robot_ = robot_for_function(function_, robot, reference_robot<Real50>(robot, symbols));
  exact_ = row_.reference.exact({mechanism_, exact_robot_, symbols_}, function_);
  magnitude_ = row_.reference.magnitude({mechanism_, rounded_, symbols_}, function_);
  steep_magnitude_ = row_.reference.magnitude({mechanism_, steep_, symbols_}, function_);
  const bool has_columns = derivative_ == Derivative::jacobian || derivative_ == Derivative::vector_times_jacobian;
  if (!has_columns || row_.state_derivatives == nullptr || mechanism.has_quasi_velocities()) return;
  state_derivatives_ = function_;
  state_derivatives_.name = row_.state_derivatives;
  const NumericReference& state = row_of(state_derivatives_).reference;
  state_exact_ = state.exact({mechanism_, exact_robot_, symbols_}, state_derivatives_);
  state_magnitude_ = state.magnitude({mechanism_, rounded_, symbols_}, state_derivatives_);
}

template <class T>
void DerivativeReference::take_state_derivatives(const std::vector<T>& entries,
                                                 std::vector<std::vector<T>>& columns) const {
  const auto n = static_cast<std::size_t>(mechanism_.size());
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    const auto [kind, number] = directions_[k];
    if (kind != InputKind::q && kind != InputKind::qd && kind != InputKind::tau) continue;
    const bool is_of_B = kind == InputKind::tau;
    const std::size_t first = is_of_B ? 4 * n * n : 0, cols = is_of_B ? n : 2 * n,
                      column = static_cast<std::size_t>(number) + (kind == InputKind::qd ? n : 0);
    for (std::size_t i = 0; i < 2 * n; ++i) columns[k][i] = entries[first + i * cols + column];
  }
}

template <class T>
std::vector<T> DerivativeReference::in_order(const std::vector<std::vector<T>>& columns) const {
  std::vector<T> entries;
  for (const DerivativePlace& place : places_) entries.push_back(columns[place.column][place.row]);
  return entries;
}

std::vector<Real50> DerivativeReference::exact(const StateOf<Real50>& state) const {
  if (derivative_ == Derivative::jacobian_times_vector) return derivatives_along(state, state.direction);
  std::vector<Values> columns;
  for (std::size_t k = 0; k < directions_.size(); ++k) columns.push_back(derivatives_by(state, k));
  if (state_exact_) take_state_derivatives(state_exact_(state), columns);
  if (derivative_ != Derivative::vector_times_jacobian) return in_order(columns);
  Values products;
  for (const Values& column : columns) {
    Real50 product(0);
    const std::size_t entries = std::min(column.size(), state.weights.size());  // kCondition has no weight
    for (std::size_t e = 0; e < entries; ++e) product += state.weights[e] * column[e];
    products.push_back(product);
  }
  return products;
}

DerivativeReference::Values DerivativeReference::derivatives_by(const StateOf<Real50>& state,
                                                                std::size_t direction) const {
  Values weights(directions_.size(), Real50(0));
  weights[direction] = Real50(1);
  return derivatives_along(state, weights);
}

DerivativeReference::Values DerivativeReference::derivatives_along(const StateOf<Real50>& state,
                                                                   const Values& weights) const {
  static const std::vector<Real50> factors = difference_factors();
  const bool is_of_step =
      std::find(function_.inputs.begin(), function_.inputs.end(), InputKind::h) != function_.inputs.end();
  const bool is_by_length = is_of_step && weights[length_direction()] != Real50(0);
  const bool is_sensitive = is_of_step || mechanism_.has_loops();
  const Real50 step(is_by_length ? kShortestStep : is_sensitive ? kShortStep : kStep);
  Values sums, sizes;
  for (int j = 1; j <= kNodes; ++j) {
    const Values values = values_at(state, weights, step * Real50(j));
    sums.resize(values.size(), Real50(0));
    sizes.resize(values.size(), Real50(0));
    for (std::size_t e = 0; e < values.size(); ++e) {
      sums[e] += factors[static_cast<std::size_t>(j - 1)] * values[e];
      sizes[e] += abs(values[e]);
    }
  }
  // A remainder of values that do not change is their rounding.
  const Real50 rounding(is_sensitive ? kRoundingOfSolutions : kRounding);
  for (std::size_t e = 0; e < sums.size(); ++e) {
    sums[e] = abs(sums[e]) > rounding * sizes[e] ? Real50(sums[e] / step) : Real50(0);
  }
  return sums;
}

DerivativeReference::Values DerivativeReference::values_at(const StateOf<Real50>& state, const Values& weights,
                                                           const Real50& step) const {
  StateOf<Real50> moved = state;
  bool moves_symbols = false;
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    if (weights[k] == Real50(0)) continue;
    moves_symbols = moves_symbols || directions_[k].kind == InputKind::parameter;
    move(directions_[k], Real50(step * weights[k]), moved);
  }
  if (gradient_at_) {
    const auto values = (*gradient_at_)(with_unit_quaternions(mechanism_, std::move(moved)));
    return values.value_or(Values(directions_.size(), Real50(std::numeric_limits<double>::quiet_NaN())));
  }
  if (!moves_symbols) return exact_(moved);
  SymbolValues values;
  for (const Real50& value : moved.parameters) values.push_back(exact_decimal(value.str(kDigits)));
  const auto robot = robot_for_function(function_, robot_, reference_robot<Real50>(robot_, values));
  return row_.reference.exact({mechanism_, robot, values}, function_)(moved);
}

std::size_t DerivativeReference::length_direction() const {
  const auto is_length = [](const Direction& direction) { return direction.kind == InputKind::h; };
  return static_cast<std::size_t>(std::find_if(directions_.begin(), directions_.end(), is_length) -
                                  directions_.begin());
}

template <class S>
void DerivativeReference::move(const Direction& direction, const S& distance, StateOf<S>& state) const {
  if (direction.kind == InputKind::q) {
    move_position(direction.entry, distance, state);
  } else {
    state.of(direction.kind)[static_cast<std::size_t>(direction.entry)] += distance;
  }
}

// Entries that turn are moved along the tangent of the turn: ġ_b = g_b × δ, q̇ = ½ q (0, δ).
template <class S>
void DerivativeReference::move_position(int k, const S& distance, StateOf<S>& state) const {
  const auto after = [](std::size_t axis, std::size_t by) { return (axis + by) % 3; };
  if (mechanism_.is_of_base(k)) {
    if (k < kVectorLength || !mechanism_.has_base_gravity()) return;
    const auto axis = static_cast<std::size_t>(k - kVectorLength);
    const std::vector<S> g = state.g_b;
    state.g_b[after(axis, 1)] += g[after(axis, 2)] * distance;
    state.g_b[after(axis, 2)] -= g[after(axis, 1)] * distance;
    return;
  }
  if (mechanism_.has_loops()) {
    move_along_loops(k - mechanism_.base_bodies(), distance, state);
    return;
  }
  if (!mechanism_.is_of_spherical(mechanism_.body_of(k))) {
    state.q[static_cast<std::size_t>(mechanism_.position_of(k))] += distance;
    return;
  }
  const int body = mechanism_.body_of(k);
  const auto axis = static_cast<std::size_t>(mechanism_.body(body).spherical - 1);
  const auto first = state.q.begin() + mechanism_.quaternion_of(body);
  const std::vector<S> r(first + 1, first + 4);
  const S w = *first, half = distance / S(2);
  const auto vector = first + 1;
  *first -= r[axis] * half;
  vector[static_cast<std::ptrdiff_t>(axis)] += w * half;
  vector[static_cast<std::ptrdiff_t>(after(axis, 1))] += r[after(axis, 2)] * half;
  vector[static_cast<std::ptrdiff_t>(after(axis, 2))] -= r[after(axis, 1)] * half;
}

// All joints move along the tangent of the motion of an independent one.
template <class S>
void DerivativeReference::move_along_loops(int independent, const S& distance, StateOf<S>& state) const {
  const reference::Robot<S>* robot = nullptr;
  if constexpr (std::is_same_v<S, double>) {
    robot = &rounded_;
  } else {
    robot = &exact_robot_;
  }
  const reference::VectorX<S> q = Eigen::Map<const reference::VectorX<S>>(state.q.data(),
                                                                          static_cast<Eigen::Index>(state.q.size())),
                              moved = q + distance * reference::loop_motion<S>(*robot, q).col(independent);
  state.q.assign(moved.begin(), moved.end());
}

bool DerivativeReference::is_along_loops(const Direction& direction) const {
  return direction.kind == InputKind::q && mechanism_.has_loops() && !mechanism_.is_of_base(direction.entry);
}

bool DerivativeReference::is_angle(const Direction& direction) const {
  if (direction.kind != InputKind::q) return false;
  if (mechanism_.is_of_base(direction.entry)) return direction.entry >= kVectorLength;
  return !mechanism_.joint(direction.entry).prismatic;
}

std::vector<double> DerivativeReference::magnitude_along(const State& state, const std::vector<double>& here,
                                                         const Direction& along) const {
  if (is_along_loops(along)) return magnitude_along_loops(state, along.entry - mechanism_.base_bodies(), magnitude_);
  if (is_angle(along)) return here;
  if (along.kind == InputKind::h) return by_step_length(here, state.q.size(), state.h.front());
  if (along.kind == InputKind::parameter) {
    SymbolValues values = symbols_;
    Number& value = values[static_cast<std::size_t>(along.entry)];
    value += nearest_double(value) < 0 ? -1 : 1;
    const auto robot = robot_for_function(function_, robot_, reference_robot<double>(robot_, values));
    std::vector<double> there = row_.reference.magnitude({mechanism_, robot, values}, function_)(state);
    if (mechanism_.has_loops()) there = sum(std::move(there), scaled(here, growth_by_symbol(state, along.entry)));
    return scaled(std::move(there), steepness_);
  }
  if (along.kind == InputKind::g_b && row_.traits.needs_cones) {  // the direction of g_b turns by δ / |g_b|
    double square = 0;
    for (const double entry : state.g_b) square += entry * entry;
    return scaled(here, 2 / std::sqrt(square));
  }
  if (is_velocity(along.kind) && row_.traits.needs_load_friction) return scaled(here, steepness_);
  const bool is_rate = is_velocity(along.kind);
  std::vector<double> there = (is_rate ? steep_magnitude_ : magnitude_)(unit_away(state, along));
  // The magnitude of a quotient may shrink while an argument grows.
  if (along.kind == InputKind::q || row_.traits.divides_by_pivots || row_.traits.has_gaps) return there;
  return difference(std::move(there), is_rate ? steep_magnitude_(state) : here);
}

// A joint that slides changes a magnitude by the difference that a unit of it makes.
std::vector<double> DerivativeReference::magnitude_along_loops(
    const State& state, int independent, const std::function<std::vector<double>(const State&)>& magnitude) const {
  const reference::VectorX<double> q =
      Eigen::Map<const reference::VectorX<double>>(state.q.data(), static_cast<Eigen::Index>(state.q.size()));
  const std::vector<double> here = magnitude(state);
  std::vector<double> result = scaled(here, reference::loop_motion_growth(rounded_, q)[independent]);
  const reference::VectorX<double> rates = reference::loop_motion_magnitude(rounded_, q).col(independent);
  for (int p = 0; p < mechanism_.position_count(); ++p) {
    if (!mechanism_.body(mechanism_.body_at(p)).prismatic) continue;
    State away = state;
    away.q[static_cast<std::size_t>(p)] += q[p] < 0 ? -1 : 1;
    const std::vector<double> there = difference(magnitude(away), here);
    for (std::size_t e = 0; e < result.size(); ++e) result[e] += rates[p] * there[e];
  }
  return result;
}

// A change of a length by a share of it changes the equations of loops by as much, whose solution may be sensitive.
double DerivativeReference::growth_by_symbol(const State& state, int symbol) const {
  const double value = std::abs(nearest_double(symbols_[static_cast<std::size_t>(symbol)]));
  const reference::VectorX<double> q =
      Eigen::Map<const reference::VectorX<double>>(state.q.data(), static_cast<Eigen::Index>(state.q.size()));
  return value > 0 ? reference::loop_motion_growth(rounded_, q).maxCoeff() / value : 0;
}

// The state that is a unit farther from zero.
State DerivativeReference::unit_away(const State& state, const Direction& direction) const {
  double value = 0;
  if (direction.kind != InputKind::q) {
    value = state.of(direction.kind)[static_cast<std::size_t>(direction.entry)];
  } else if (!mechanism_.is_of_base(direction.entry)) {
    value = state.q[static_cast<std::size_t>(mechanism_.position_of(direction.entry))];
  }
  State away = state;
  move(direction, value < 0 ? -1.0 : 1.0, away);
  return away;
}

double DerivativeReference::amplification_at(const State& state) const {
  if (!row_.traits.divides_by_pivots) return 1;
  reference::Robot<double> robot = has_base_gravity(rounded_) ? with_base_gravity(rounded_, state) : rounded_;
  const State rest = without_quaternions(robot, state);
  const ReferencePoint<double> at(robot, function_, rest);
  return (absolute_inverse(at) * reference::inertia_magnitude(robot, at.q)).rowwise().sum().maxCoeff();
}

std::vector<std::vector<double>> DerivativeReference::magnitudes(const State& state) const {
  const double amplification = amplification_at(state);
  const std::vector<double> here = magnitude_(state);
  std::vector<std::vector<double>> columns;
  for (const Direction& direction : directions_) {
    columns.push_back(magnitude_along(state, here, direction));
    for (double& entry : columns.back()) entry = std::abs(amplification * entry);
  }
  if (state_magnitude_) take_state_derivatives(state_magnitude_(state), columns);
  return columns;
}

// The magnitude of wᵀ J.
std::vector<double> DerivativeReference::weighted_magnitude(const State& state) const {
  std::vector<double> result;
  for (const std::vector<double>& column : magnitudes(state)) {
    double sum = 0;
    const std::size_t entries = std::min(column.size(), state.weights.size());
    for (std::size_t e = 0; e < entries; ++e) sum += std::abs(state.weights[e]) * column[e];
    result.push_back(sum);
  }
  return result;
}

std::vector<double> DerivativeReference::magnitude(const State& state) const {
  if (derivative_ == Derivative::vector_times_jacobian) return weighted_magnitude(state);
  if (derivative_ == Derivative::contracted_hessian) {
    std::vector<std::vector<double>> columns;
    const auto weighted = [this](const State& at) { return weighted_magnitude(at); };
    for (const Direction& direction : directions_) {
      if (is_along_loops(direction)) {
        columns.push_back(magnitude_along_loops(state, direction.entry - mechanism_.base_bodies(), weighted));
        continue;
      }
      const bool is_here = is_angle(direction) || direction.kind == InputKind::parameter;
      const bool is_steep = is_velocity(direction.kind) || direction.kind == InputKind::parameter;
      columns.push_back(
          scaled(weighted_magnitude(is_here ? state : unit_away(state, direction)), is_steep ? steepness_ : 1));
    }
    return in_order(columns);
  }
  const std::vector<std::vector<double>> columns = magnitudes(state);
  if (derivative_ == Derivative::jacobian) return in_order(columns);
  std::vector<double> result(columns[0].size(), 0);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (std::size_t e = 0; e < result.size(); ++e) result[e] += std::abs(state.direction[k]) * columns[k][e];
  }
  return result;
}

}  // namespace flatdyn
