// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/step_references.hpp"

#include <vector>

#include "truth/reference/acceleration_magnitude.hpp"
#include "truth/reference/derivative_references.hpp"
#include "truth/reference/step_motion.hpp"

namespace flatdyn::references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

template <class S>
ref::VectorX<S> accelerations_at(const ReferencePoint<S>& at) {
  return ref::forward_dynamics(at.robot, at.q, at.qd, at.tau);
}

template <class S>
std::vector<S> after_semi_implicit(const ReferencePoint<S>& at) {
  const ref::VectorX<S> qd = at.qd + at.step * accelerations_at(at);
  return after_step<S>(at, change_along<S>(at.robot, at.step * qd), qd);
}

ref::VectorX<double> size_of_rates_after(const At& at) {
  return at.qd.cwiseAbs() + at.step * acceleration_magnitude(at);
}

std::vector<double> semi_implicit_magnitude(const At& at) {
  const ref::VectorX<double> qd = size_of_rates_after(at);
  return step_magnitude(at, at.step * qd, qd);
}

// A and B from the derivatives of q̈, and from how positions depend on h q̇'.
template <class S>
std::vector<S> semi_implicit_derivatives(const ref::AccelerationDerivatives<S>& qdd, const Tangents<S>& tangents,
                                         const S& h) {
  const Eigen::Index n = qdd.dq.rows();
  ref::MatrixX<S> of_accelerations(n, 3 * n);
  of_accelerations << qdd.dq, qdd.dqd, qdd.dtau;
  const ref::MatrixX<S> rates = unit_part<S>(n, 1) + h * of_accelerations;
  return state_derivatives<S>(derivatives_after<S>(tangents, h * rates), rates);
}

template <class S>
Tangents<S> semi_implicit_tangents(const ReferencePoint<S>& at) {
  return tangents_along<S>(at.robot, at.step * (at.qd + at.step * accelerations_at(at)));
}

// The points at which the classical Runge-Kutta method of fourth order needs accelerations, and these.
template <class S>
struct Stages {
  std::vector<PointAfter<S>> points;
  std::vector<ref::VectorX<S>> changes, rates_of_change, qdd;

  explicit Stages(const ReferencePoint<S>& first) : changes{ref::VectorX<S>::Zero(first.qd.size())} {
    ref::VectorX<S> qd = first.qd;
    for (;;) {
      points.emplace_back(first, change_in_chart<S>(first.robot, changes.back()));
      points.back().at.qd = qd;
      qdd.push_back(accelerations_at(points.back().at));
      rates_of_change.push_back(rates_in_chart<S>(first.robot, changes.back(), qd));
      if (points.size() == kStages) return;
      const S part = part_of(points.size(), first.step);
      changes.push_back(part * rates_of_change.back());
      qd = first.qd + part * qdd.back();
    }
  }

  static constexpr std::size_t kStages = 4;
  // h/2, h/2, h for the stages 1 to 3 after the first, and h/6, h/3, h/3, h/6 for all.
  static S part_of(std::size_t stage, const S& h) { return stage == 3 ? h : h / S(2); }
  static S weight_of(std::size_t stage, const S& h) { return (stage == 0 || stage == 3 ? S(1) : S(2)) * h / S(6); }
  // The weighted sum of something of all stages.
  template <class Values>
  static Values sum(const std::vector<Values>& values, const S& h) {
    Values result = weight_of(0, h) * values[0];
    for (std::size_t k = 1; k < kStages; ++k) result += weight_of(k, h) * values[k];
    return result;
  }
};

template <class S>
std::vector<S> after_runge_kutta(const ReferencePoint<S>& first) {
  const Stages<S> stages(first);
  return after_step<S>(first, change_in_chart<S>(first.robot, Stages<S>::sum(stages.rates_of_change, first.step)),
                       first.qd + Stages<S>::sum(stages.qdd, first.step));
}

// The sizes of the terms of all stages: an error of this size changes a stage's acceleration as derivatives say.
struct StageSizes {
  using Vector = ref::VectorX<double>;
  std::vector<Vector> changes, rates, rates_of_change, accelerations;

  StageSizes(const At& first, const Stages<double>& stages)
      : changes{Vector::Zero(first.qd.size())}, rates{first.qd.cwiseAbs()} {
    const Vector before = position_magnitude(first);
    Vector at_q = Vector::Zero(before.size()), at_qd = at_q;
    for (std::size_t k = 0; k < Stages<double>::kStages; ++k) {
      const At& here = stages.points[k].at;
      const auto by = ref::forward_dynamics_derivatives(here.robot, here.q, here.qd, here.tau);
      accelerations.emplace_back(acceleration_magnitude(here) + by.dq.cwiseAbs() * at_q + by.dqd.cwiseAbs() * at_qd);
      rates_of_change.emplace_back(size_of_tangents_of_rates(here.robot, changes[k], rates[k]).by_velocity * rates[k]);
      const double part = Stages<double>::part_of(k + 1, first.step);
      changes.emplace_back(part * rates_of_change[k]);
      at_qd = first.qd.cwiseAbs() + part * accelerations[k];
      at_q = before + changes.back();
      rates.push_back(at_qd);
    }
  }
};

std::vector<double> runge_kutta_magnitude(const At& first) {
  const StageSizes sizes(first, Stages<double>(first));
  return step_magnitude(first, Stages<double>::sum(sizes.rates_of_change, first.step),
                        first.qd.cwiseAbs() + Stages<double>::sum(sizes.accelerations, first.step));
}

// A and B of the same method by the chain rule. `at_stage`, `of_positions` and `of_rates`: the derivatives of q̈ and of
// the chart at a stage, by number; number kStages is the end.
template <class S, class AtStage, class OfPositions, class OfRates>
std::vector<S> runge_kutta_derivatives(Eigen::Index n, const S& h, const AtStage& at_stage,
                                       const OfPositions& of_positions, const OfRates& of_rates) {
  using Matrix = ref::MatrixX<S>;
  Matrix change = Matrix::Zero(n, 3 * n), rate = unit_part<S>(n, 1);
  std::vector<Matrix> changes, accelerations;
  for (std::size_t k = 0; k < Stages<S>::kStages; ++k) {
    const ref::AccelerationDerivatives<S> by = at_stage(k);
    const RateTangents<S> by_rates = of_rates(k);
    accelerations.push_back(by.dq * derivatives_after<S>(of_positions(k), change) + by.dqd * rate +
                            by.dtau * unit_part<S>(n, 2));
    changes.push_back(by_rates.by_change * change + by_rates.by_velocity * rate);
    const S part = Stages<S>::part_of(k + 1, h);
    change = part * changes.back();
    rate = unit_part<S>(n, 1) + part * accelerations.back();
  }
  const Matrix positions = derivatives_after<S>(of_positions(Stages<S>::kStages), Stages<S>::sum(changes, h));
  return state_derivatives<S>(positions, unit_part<S>(n, 1) + Stages<S>::sum(accelerations, h));
}

template <class S>
std::vector<S> runge_kutta_derivative_entries(const ReferencePoint<S>& first) {
  const Stages<S> stages(first);
  std::vector<ref::VectorX<S>> changes = stages.changes;
  changes.push_back(Stages<S>::sum(stages.rates_of_change, first.step));
  return runge_kutta_derivatives<S>(
      first.qd.size(), first.step,
      [&stages](std::size_t k) {
        const ReferencePoint<S>& here = stages.points[k].at;
        return ref::forward_dynamics_derivatives(here.robot, here.q, here.qd, here.tau);
      },
      [&](std::size_t k) { return tangents_in_chart<S>(first.robot, changes[k]); },
      [&](std::size_t k) { return tangents_of_rates<S>(first.robot, changes[k], stages.points[k].at.qd); });
}

std::vector<double> runge_kutta_derivative_magnitude(const At& first) {
  const Stages<double> stages(first);
  const StageSizes sizes(first, stages);
  std::vector<ref::VectorX<double>> changes(sizes.changes.begin(), sizes.changes.begin() + Stages<double>::kStages);
  changes.push_back(Stages<double>::sum(sizes.rates_of_change, first.step));
  return runge_kutta_derivatives<double>(
      first.qd.size(), first.step,
      [&stages](std::size_t k) { return acceleration_derivative_magnitudes(stages.points[k].at); },
      [&](std::size_t k) { return size_of_tangents_in_chart(first.robot, changes[k]); },
      [&](std::size_t k) { return size_of_tangents_of_rates(first.robot, changes[k], sizes.rates[k]); });
}

}  // namespace

constinit const NumericReference runge_kutta_step_derivatives =
    computed_by([](const auto& at) { return runge_kutta_derivative_entries(at); },
                [](const At& at) { return runge_kutta_derivative_magnitude(at); });

constinit const NumericReference runge_kutta_step = computed_by([](const auto& at) { return after_runge_kutta(at); },
                                                                [](const At& at) { return runge_kutta_magnitude(at); });

constinit const NumericReference semi_implicit_step = computed_by(
    [](const auto& at) { return after_semi_implicit(at); }, [](const At& at) { return semi_implicit_magnitude(at); });

constinit const NumericReference semi_implicit_step_derivatives = computed_by(
    [](const auto& at) {
      return semi_implicit_derivatives(ref::forward_dynamics_derivatives(at.robot, at.q, at.qd, at.tau),
                                       semi_implicit_tangents(at), at.step);
    },
    [](const At& at) {
      return semi_implicit_derivatives(acceleration_derivative_magnitudes(at),
                                       size_of_tangents_along(at.robot, at.step * size_of_rates_after(at)), at.step);
    });

}  // namespace flatdyn::references
