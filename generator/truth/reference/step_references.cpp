// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/step_references.hpp"

#include <vector>

#include "truth/reference/acceleration_magnitude.hpp"
#include "truth/reference/derivative_references.hpp"

namespace flatdyn::references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

// Positions and rates after a step of length h from q, q̇ with accelerations q̈.
template <class S>
std::vector<S> semi_implicit(const ref::VectorX<S>& q, const ref::VectorX<S>& qd, const ref::VectorX<S>& qdd,
                             const S& h) {
  const ref::VectorX<S> rates = qd + h * qdd;
  const ref::VectorX<S> positions = q + h * rates;
  return one_after_the_other<S>({positions, rates});
}

// A and B from the derivatives of q̈.
template <class S>
std::vector<S> semi_implicit_derivatives(const ref::AccelerationDerivatives<S>& qdd, const S& h) {
  const Eigen::Index n = qdd.dq.rows();
  const ref::MatrixX<S> one = ref::MatrixX<S>::Identity(n, n);
  ref::MatrixX<S> A(2 * n, 2 * n), B(2 * n, n);
  A.bottomRows(n) << h * qdd.dq, one + h * qdd.dqd;
  B.bottomRows(n) = h * qdd.dtau;
  A.topRows(n) = h * A.bottomRows(n);
  A.topLeftCorner(n, n) += one;
  B.topRows(n) = h * B.bottomRows(n);
  return one_after_the_other<S>({A, B});
}

// The states at which the classical Runge-Kutta method of fourth order needs accelerations, and these.
template <class S>
struct Stages {
  std::vector<ReferencePoint<S>> at;
  std::vector<ref::VectorX<S>> qdd;

  explicit Stages(const ReferencePoint<S>& first) : at{first} {
    for (;;) {
      const ReferencePoint<S>& here = at.back();
      qdd.push_back(ref::forward_dynamics(here.robot, here.q, here.qd, here.tau));
      if (at.size() == 4) return;
      const S part = at.size() == 3 ? first.step : first.step / S(2);
      ReferencePoint<S> next = first;
      next.q += part * here.qd;
      next.qd += part * qdd.back();
      at.push_back(next);
    }
  }
};

// h/6, h/3, h/3, h/6.
template <class S>
S weight_of(std::size_t stage, const S& h) {
  return (stage == 0 || stage == 3 ? S(1) : S(2)) * h / S(6);
}

template <class S>
std::vector<S> after_runge_kutta(const ReferencePoint<S>& first) {
  const Stages<S> stages(first);
  ref::VectorX<S> positions = first.q, rates = first.qd;
  for (std::size_t k = 0; k < stages.at.size(); ++k) {
    positions += weight_of(k, first.step) * stages.at[k].qd;
    rates += weight_of(k, first.step) * stages.qdd[k];
  }
  return one_after_the_other<S>({positions, rates});
}

// An error of the size of a stage's terms changes its acceleration as derivatives say.
std::vector<double> runge_kutta_magnitude(const At& first) {
  using Vector = ref::VectorX<double>;
  const Stages<double> stages(first);
  const double h = first.step;
  const Vector q = first.q.cwiseAbs(), qd = first.qd.cwiseAbs();
  Vector at_q = Vector::Zero(q.size()), at_qd = at_q, positions = q, rates = qd;
  for (std::size_t k = 0; k < stages.at.size(); ++k) {
    const At& here = stages.at[k];
    const auto by = ref::forward_dynamics_derivatives(here.robot, here.q, here.qd, here.tau);
    const Vector qdd = acceleration_magnitude(here) + by.dq.cwiseAbs() * at_q + by.dqd.cwiseAbs() * at_qd;
    const Vector rate = k == 0 ? qd : at_qd;
    positions += weight_of(k, h) * rate;
    rates += weight_of(k, h) * qdd;
    const double part = k == 2 ? h : h / 2;
    at_q = q + part * rate;
    at_qd = qd + part * qdd;
  }
  return one_after_the_other<double>({positions, rates});
}

// A and B of the same method by the chain rule. `at_stage`: the derivatives of q̈ at a stage, by number.
template <class S, class AtStage>
std::vector<S> runge_kutta_derivatives(Eigen::Index n, const S& h, const AtStage& at_stage) {
  using Matrix = ref::MatrixX<S>;
  Matrix dq = Matrix::Zero(n, 3 * n), dqd = dq, dtau = dq;
  dq.leftCols(n).setIdentity();
  dqd.middleCols(n, n).setIdentity();
  dtau.rightCols(n).setIdentity();
  Matrix position = dq, rate = dqd, positions = dq, rates = dqd;
  for (std::size_t k = 0; k < 4; ++k) {
    const ref::AccelerationDerivatives<S> by = at_stage(k);
    const Matrix dqdd = by.dq * position + by.dqd * rate + by.dtau * dtau;
    positions += weight_of(k, h) * rate;
    rates += weight_of(k, h) * dqdd;
    const S part = k == 2 ? h : h / S(2);
    position = dq + part * rate;
    rate = dqd + part * dqdd;
  }
  Matrix A(2 * n, 2 * n), B(2 * n, n);
  A << positions.leftCols(2 * n), rates.leftCols(2 * n);
  B << positions.rightCols(n), rates.rightCols(n);
  return one_after_the_other<S>({A, B});
}

template <class S>
std::vector<S> runge_kutta_derivative_entries(const ReferencePoint<S>& first) {
  const Stages<S> stages(first);
  return runge_kutta_derivatives<S>(first.q.size(), first.step, [&stages](std::size_t k) {
    const ReferencePoint<S>& here = stages.at[k];
    return ref::forward_dynamics_derivatives(here.robot, here.q, here.qd, here.tau);
  });
}

std::vector<double> runge_kutta_derivative_magnitude(const At& first) {
  const Stages<double> stages(first);
  return runge_kutta_derivatives<double>(first.q.size(), first.step, [&stages](std::size_t k) {
    return acceleration_derivative_magnitudes(stages.at[k]);
  });
}

}  // namespace

constinit const NumericReference runge_kutta_step_derivatives =
    computed_by([](const auto& at) { return runge_kutta_derivative_entries(at); },
                [](const At& at) { return runge_kutta_derivative_magnitude(at); });

constinit const NumericReference runge_kutta_step = computed_by([](const auto& at) { return after_runge_kutta(at); },
                                                                [](const At& at) { return runge_kutta_magnitude(at); });

constinit const NumericReference semi_implicit_step = computed_by(
    [](const auto& at) {
      return semi_implicit(at.q, at.qd, ref::forward_dynamics(at.robot, at.q, at.qd, at.tau), at.step);
    },
    [](const At& at) {
      return semi_implicit<double>(at.q.cwiseAbs(), at.qd.cwiseAbs(), acceleration_magnitude(at), at.step);
    });

constinit const NumericReference semi_implicit_step_derivatives = computed_by(
    [](const auto& at) {
      return semi_implicit_derivatives(ref::forward_dynamics_derivatives(at.robot, at.q, at.qd, at.tau), at.step);
    },
    [](const At& at) { return semi_implicit_derivatives(acceleration_derivative_magnitudes(at), at.step); });

}  // namespace flatdyn::references
