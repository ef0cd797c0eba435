// SPDX-License-Identifier: GPL-2.0-or-later
// The implicit midpoint rule: derivation/dynamics/midpoint.hpp has its equations.
#include <Eigen/LU>
#include <limits>
#include <vector>

#include "flatdyn/reference/derivatives.hpp"
#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_point.hpp"
#include "truth/reference/step_references.hpp"

namespace flatdyn::references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

// The motion in the middle of a step, the residual of its torques, and how they change.
template <class S>
struct Middle {
  explicit Middle(const ReferencePoint<S>& at)
      : half(at.step / S(2)),
        qd((at.qd + at.qd_end) / S(2)),
        q(at.q + half * qd),
        qdd((at.qd_end - at.qd) / at.step),
        residual(ref::inverse_dynamics(at.robot, q, qd, qdd) - at.tau),
        by(ref::inverse_dynamics_derivatives(at.robot, q, qd, qdd)),
        inertia(ref::inertia_matrix(at.robot, q)),
        newton(inertia + half * (by.dqd + half * by.dq)) {}

  S half;
  ref::VectorX<S> qd, q, qdd, residual;
  ref::Derivatives<S> by;
  ref::MatrixX<S> inertia, newton;
};

template <class S>
ref::MatrixX<S> quotient(const ref::MatrixX<S>& A, const ref::MatrixX<S>& B) {
  return A.partialPivLu().solve(B);
}

// Whether all pivots are positive in an elimination without exchanges of rows.
template <class S>
bool has_positive_pivots(ref::MatrixX<S> A) {
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    if (!(A(k, k) > S(0))) return false;
    const Eigen::Index rest = A.rows() - k - 1;
    const ref::MatrixX<S> change = A.col(k).tail(rest) * A.row(k).tail(rest) / A(k, k);
    A.bottomRightCorner(rest, rest) -= change;
  }
  return true;
}

template <class S>
std::vector<S> no_value(Eigen::Index entries) {
  return std::vector<S>(static_cast<std::size_t>(entries), std::numeric_limits<S>::quiet_NaN());
}

template <class S>
std::vector<S> after_iteration(const ReferencePoint<S>& at) {
  const Middle<S> middle(at);
  if (!has_positive_pivots<S>(middle.newton)) return no_value<S>(3 * at.q.size());
  const ref::VectorX<S> rates = at.qd_end - at.step * quotient<S>(middle.newton, middle.residual);
  const ref::VectorX<S> positions = at.q + middle.half * (at.qd + rates);
  return one_after_the_other<S>({positions, rates, middle.residual});
}

// A and B from the rows of rates, with 1 and h/2 that are added to rows of positions.
template <class S>
std::vector<S> derivative_entries(const ref::MatrixX<S>& rates, const S& half) {
  const Eigen::Index n = rates.rows();
  ref::MatrixX<S> positions = half * rates, A(2 * n, 2 * n), B(2 * n, n);
  positions.leftCols(n) += ref::MatrixX<S>::Identity(n, n);
  positions.middleCols(n, n) += half * ref::MatrixX<S>::Identity(n, n);
  A << positions.leftCols(2 * n), rates.leftCols(2 * n);
  B << positions.rightCols(n), rates.rightCols(n);
  return one_after_the_other<S>({A, B});
}

template <class S>
ref::MatrixX<S> right_side(const ReferencePoint<S>& at, const Middle<S>& middle) {
  const Eigen::Index n = at.q.size();
  ref::MatrixX<S> right(n, 3 * n);
  right << -at.step * middle.by.dq, middle.inertia - middle.half * (middle.by.dqd + middle.half * middle.by.dq),
      at.step * ref::MatrixX<S>::Identity(n, n);
  return right;
}

template <class S>
std::vector<S> midpoint_derivatives(const ReferencePoint<S>& at) {
  const Middle<S> middle(at);
  if (!has_positive_pivots<S>(middle.newton)) return no_value<S>(6 * at.q.size() * at.q.size());
  return derivative_entries<S>(quotient<S>(middle.newton, right_side(at, middle)), middle.half);
}

// The sizes of the terms of the derivatives, and of the matrices made of them.
struct MiddleMagnitude {
  explicit MiddleMagnitude(const At& at)
      : middle(at),
        inverse(middle.newton.inverse().cwiseAbs()),
        by_q(ref::position_derivative_magnitude(at.robot, middle.q, middle.qd, middle.qdd)),
        by_qd(ref::rate_derivative_magnitude(at.robot, middle.q, middle.qd)),
        inertia(ref::inertia_magnitude(at.robot, middle.q)),
        newton(inertia + middle.half * (by_qd + middle.half * by_q)) {}

  Middle<double> middle;
  ref::MatrixX<double> inverse, by_q, by_qd, inertia, newton;
};

// Errors of the motion in the middle change the torques as derivatives say.
std::vector<double> iteration_magnitude(const At& at) {
  using Vector = ref::VectorX<double>;
  const MiddleMagnitude size(at);
  const Middle<double>& middle = size.middle;
  const Vector rate = (at.qd.cwiseAbs() + at.qd_end.cwiseAbs()) / 2, acceleration = 2 / at.step * rate;
  const Vector position = at.q.cwiseAbs() + middle.half * rate;
  const Vector residual = ref::torque_magnitude(at.robot, middle.q, middle.qd, acceleration) + at.tau.cwiseAbs() +
                          size.by_q * position + size.by_qd * rate;
  const Vector change = quotient<double>(middle.newton, middle.residual).cwiseAbs();
  const Vector rates = at.qd_end.cwiseAbs() + at.step * (size.inverse * (residual + size.newton * change));
  const Vector positions = at.q.cwiseAbs() + middle.half * (at.qd.cwiseAbs() + rates);
  return one_after_the_other<double>({positions, rates, residual});
}

std::vector<double> midpoint_derivative_magnitude(const At& at) {
  const MiddleMagnitude size(at);
  const Middle<double>& middle = size.middle;
  const Eigen::Index n = at.q.size();
  ref::MatrixX<double> right(n, 3 * n);
  right << at.step * size.by_q, size.newton, at.step * ref::MatrixX<double>::Identity(n, n);
  const ref::MatrixX<double> own = quotient<double>(middle.newton, right_side(at, middle)).cwiseAbs();
  return derivative_entries<double>(size.inverse * (right + size.newton * own), middle.half);
}

}  // namespace

constinit const NumericReference midpoint_step = computed_by([](const auto& at) { return after_iteration(at); },
                                                             [](const At& at) { return iteration_magnitude(at); });

constinit const NumericReference midpoint_step_derivatives =
    computed_by([](const auto& at) { return midpoint_derivatives(at); },
                [](const At& at) { return midpoint_derivative_magnitude(at); });

}  // namespace flatdyn::references
