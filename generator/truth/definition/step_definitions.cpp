// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/step_definitions.hpp"

#include <array>

#include "truth/definition/acceleration_derivatives.hpp"
#include "truth/definition/elimination_over_field.hpp"
#include "truth/definition/rules.hpp"
#include "truth/definition/step_point.hpp"

namespace flatdyn::definitions {
namespace {

// A state during a step: how positions have changed, as numbers of step_motion.hpp, and q̇. The derivatives are those of
// step_point.hpp.
template <class F>
struct StateOfStep {
  std::vector<F> change, qd;
  Matrix<F> dchange, dqd;
};

template <class Point, class F = typename Point::F>
StateOfStep<F> before_step(const Point& at) {
  const int n = at.mechanism.size();
  return {std::vector<F>(static_cast<std::size_t>(n), F(0)), at.qd(), Matrix<F>(n, 3 * n),
          derivatives_of_argument<F>(n, StepArgument::rate)};
}

// q̈ at a state, and the rates of its change; their derivatives are empty where nobody needs them.
template <class F>
struct RatesOfState {
  std::vector<F> change, qdd;
  Matrix<F> dchange, dqdd;
};

template <class Point>
struct StageOfStep {
  using F = typename Point::F;

  StageOfStep(const Point& at, const StateOfStep<F>& state)
      : mechanism(at.mechanism),
        arithmetic(at.arithmetic,
                   positions_after(mechanism, positions_before(at), change_in_chart(mechanism, state.change)),
                   state.qd),
        there(mechanism, at.function, arithmetic, none) {}

  const Mechanism& mechanism;
  const std::vector<F> none;
  StageArithmetic<F> arithmetic;
  DefinitionPoint<StageArithmetic<F>> there;
};

template <class Point, class F = typename Point::F>
RatesOfState<F> rates_of(StageOfStep<Point>& stage, const StateOfStep<F>& state) {
  return {rates_in_chart(stage.mechanism, state.change, state.qd),
          solution(stage.there.lagrangian.inertia(), stage.there.net_torques()),
          {},
          {}};
}

template <class Point, class F = typename Point::F>
RatesOfState<F> rates_at(const Point& at, const StateOfStep<F>& state) {
  StageOfStep<Point> stage(at, state);
  return rates_of(stage, state);
}

template <class Point, class F = typename Point::F>
RatesOfState<F> rates_and_derivatives_at(const Point& at, const StateOfStep<F>& state) {
  const Mechanism& mechanism = at.mechanism;
  const int n = mechanism.size();
  StageOfStep<Point> stage(at, state);
  RatesOfState<F> rates = rates_of(stage, state);
  const Matrix<F> dpositions =
      derivatives_after(mechanism, state.change, state.dchange,
                        [](const Mechanism& m, std::vector<Dual<F>> c) { return change_in_chart(m, std::move(c)); });
  const Matrix<F> by_q(n, torque_derivatives_by_position(stage.there, rates.qdd));
  const Matrix<F> by_qd(n, torque_derivatives_by_rate(stage.there));
  const Matrix<F> of_torques = derivatives_of_argument<F>(n, StepArgument::torque);
  rates.dqdd = solution(stage.there.lagrangian.inertia(),
                        moved(moved(of_torques, -F(1), times(by_q, dpositions)), -F(1), times(by_qd, state.dqd)));
  rates.dchange = Matrix<F>(n, 3 * n);
  for (int column = 0; column < 3 * n; ++column) {
    const std::vector<Dual<F>> change =
        rates_in_chart(mechanism, along(state.change, state.dchange, column), along(state.qd, state.dqd, column));
    for (int i = 0; i < n; ++i) rates.dchange(i, column) = change[static_cast<std::size_t>(i)].derivative;
  }
  return rates;
}

template <class F>
StateOfStep<F> moved_by(StateOfStep<F> state, const F& factor, const RatesOfState<F>& rates) {
  state.change = moved(std::move(state.change), factor, rates.change);
  state.qd = moved(std::move(state.qd), factor, rates.qdd);
  if (rates.dqdd.rows() == 0) return state;
  state.dchange = moved(std::move(state.dchange), factor, rates.dchange);
  state.dqd = moved(std::move(state.dqd), factor, rates.dqdd);
  return state;
}

// The state after a step of the classical Runge-Kutta method with these rates of states.
template <class Point, class Rates>
auto after_runge_kutta(const Point& at, const Rates& rates) {
  using F = typename Point::F;
  const F h = step_length(at), half = h / F(2), sixth = h / F(6);
  const StateOfStep<F> first = before_step(at);
  const auto a = rates(at, first), b = rates(at, moved_by(first, half, a)), c = rates(at, moved_by(first, half, b)),
             d = rates(at, moved_by(first, h, c));
  return moved_by(moved_by(moved_by(moved_by(first, sixth, a), sixth + sixth, b), sixth + sixth, c), sixth, d);
}

template <class Point>
auto runge_kutta(const Point& at, const Output& output) {
  const auto state = after_runge_kutta(at, [](const auto& point, const auto& s) { return rates_at(point, s); });
  return after_step(at, output, change_in_chart(at.mechanism, state.change), state.qd);
}

template <class Point>
auto runge_kutta_derivatives(const Point& at, const Output& output) {
  using F = typename Point::F;
  const auto state =
      after_runge_kutta(at, [](const auto& point, const auto& s) { return rates_and_derivatives_at(point, s); });
  const auto change = [](const Mechanism& m, std::vector<Dual<F>> c) { return change_in_chart(m, std::move(c)); };
  return state_derivatives(output, derivatives_after(at.mechanism, state.change, state.dchange, change), state.dqd);
}

template <class F>
std::vector<F> times_scalar(const F& factor, std::vector<F> x) {
  for (F& entry : x) entry = factor * entry;
  return x;
}

template <class Point>
auto semi_implicit(const Point& at, const Output& output) {
  const auto h = step_length(at);
  const auto state = before_step(at);
  const auto qd = moved(state.qd, h, rates_at(at, state).qdd);
  return after_step(at, output, change_along(at.mechanism, times_scalar(h, qd)), qd);
}

template <class Point>
auto semi_implicit_derivatives(const Point& at, const Output& output) {
  using F = typename Point::F;
  const F h = step_length(at);
  const StateOfStep<F> state = before_step(at);
  const RatesOfState<F> rates = rates_and_derivatives_at(at, state);
  const std::vector<F> qd = moved(state.qd, h, rates.qdd);
  const Matrix<F> dqd = moved(state.dqd, h, rates.dqdd), none(dqd.rows(), dqd.cols());
  const auto change = [](const Mechanism& m, std::vector<Dual<F>> w) { return change_along(m, std::move(w)); };
  return state_derivatives(output, derivatives_after(at.mechanism, times_scalar(h, qd), moved(none, h, dqd), change),
                           dqd);
}

// Numerator and denominator of a solution have n factors of B, each at a state of this degree. The entries of E, by
// which quaternions of spherical joints turn, have twice the degree of σ; gravity in axes of a floating base has two
// factors of E, and is in one factor of the solution, as σ̇ has two factors of σ.
double degree_of_stage(const Mechanism& mechanism, double state) {
  const double of_inertia = 4.0 * mechanism.size() * (mechanism.has_spherical_joints() ? 2 : 1),
               of_base = mechanism.has_quasi_velocities() ? 8 : 0;
  return 2 + (of_inertia + of_base) * state;
}

double degree_of_four_stages(const Mechanism& mechanism) {
  double degree = 1;
  for (int stage = 0; stage < 4; ++stage) degree = degree_of_stage(mechanism, degree);
  return degree;
}

}  // namespace

constinit const Definition runge_kutta_step = {
    .expected = rules([](auto& at, const Output& output) { return runge_kutta(at, output); }),
    .found = kOwnValues,
    .degree_factor = [](const Mechanism& mechanism, const Function&) { return degree_of_four_stages(mechanism); },
    .is_apart = true,
};

constinit const Definition runge_kutta_step_derivatives = {
    .expected = rules([](auto& at, const Output& output) { return runge_kutta_derivatives(at, output); }),
    .found = kOwnValues,
    .degree_factor = [](const Mechanism& mechanism, const Function&) { return 5.0 * degree_of_four_stages(mechanism); },
    .is_apart = true,
};

constinit const Definition semi_implicit_step = {
    .expected = rules([](auto& at, const Output& output) { return semi_implicit(at, output); }),
    .found = kOwnValues,
    .degree_factor = [](const Mechanism& mechanism, const Function&) { return degree_of_stage(mechanism, 1); },
    .is_apart = true,
};

constinit const Definition semi_implicit_step_derivatives = {
    .expected = rules([](auto& at, const Output& output) { return semi_implicit_derivatives(at, output); }),
    .found = kOwnValues,
    .degree_factor = [](const Mechanism& mechanism, const Function&) { return 2 * degree_of_stage(mechanism, 1); },
    .is_apart = true,
};

}  // namespace flatdyn::definitions
