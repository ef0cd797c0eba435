// SPDX-License-Identifier: GPL-2.0-or-later
// The implicit midpoint rule: derivation/dynamics/midpoint.hpp has its equations.
#include <Eigen/LU>
#include <limits>
#include <vector>

#include "flatdyn/reference/derivatives.hpp"
#include "truth/reference/magnitude.hpp"
#include "truth/reference/step_motion.hpp"
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
        qdd((at.qd_end - at.qd) / at.step),
        there(at, change_to_the_middle<S>(at.robot, at.step * qd)),
        tangents(tangents_to_the_middle<S>(at.robot, at.step * qd)),
        residual(ref::inverse_dynamics(there.at.robot, there.at.q, qd, qdd) - at.tau),
        by(ref::inverse_dynamics_derivatives(there.at.robot, there.at.q, qd, qdd)),
        inertia(ref::inertia_matrix(there.at.robot, there.at.q)),
        newton(inertia + by_motion(by.dq, by.dqd, tangents)) {}

  // Half of the step's length times the derivatives by a velocity that moves the middle.
  ref::MatrixX<S> by_motion(const ref::MatrixX<S>& dq, const ref::MatrixX<S>& dqd, const Tangents<S>& by_w) const {
    const ref::MatrixX<S> through_positions = S(2) * half * (dq * by_w.by_change);
    return half * (dqd + through_positions);
  }

  S half;
  ref::VectorX<S> qd, qdd;
  PointAfter<S> there;
  Tangents<S> tangents;
  ref::VectorX<S> residual;
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

// The number of entries of a step's outputs, with the residual.
template <class S>
Eigen::Index size_of_step(const ReferencePoint<S>& at) {
  constexpr Eigen::Index kOfBase = 3 + 4;
  return at.given_q.size() + 2 * at.qd.size() + (at.robot.floating_base ? kOfBase : 0);
}

template <class S>
std::vector<S> after_iteration(const ReferencePoint<S>& at) {
  const Middle<S> middle(at);
  if (!has_positive_pivots<S>(middle.newton)) return no_value<S>(size_of_step(at));
  const ref::VectorX<S> rates = at.qd_end - at.step * quotient<S>(middle.newton, middle.residual);
  std::vector<S> entries = after_step<S>(at, change_along<S>(at.robot, middle.half * (at.qd + rates)), rates);
  entries.insert(entries.end(), middle.residual.begin(), middle.residual.end());
  return entries;
}

// A and B from the rows of rates.
template <class S>
std::vector<S> derivative_entries(const ref::MatrixX<S>& rates, const S& half, const Tangents<S>& tangents) {
  const ref::MatrixX<S> change = half * (unit_part<S>(rates.rows(), 1) + rates);
  return state_derivatives<S>(derivatives_after<S>(tangents, change), rates);
}

template <class S>
ref::MatrixX<S> right_side(const ReferencePoint<S>& at, const Middle<S>& middle) {
  const Eigen::Index n = at.qd.size();
  ref::MatrixX<S> right(n, 3 * n);
  right << -at.step * (middle.by.dq * middle.tangents.by_position),
      middle.inertia - middle.by_motion(middle.by.dq, middle.by.dqd, middle.tangents),
      at.step * ref::MatrixX<S>::Identity(n, n);
  return right;
}

template <class S>
std::vector<S> midpoint_derivatives(const ReferencePoint<S>& at) {
  const Middle<S> middle(at);
  if (!has_positive_pivots<S>(middle.newton)) return no_value<S>(6 * at.qd.size() * at.qd.size());
  return derivative_entries<S>(quotient<S>(middle.newton, right_side(at, middle)), middle.half,
                               tangents_along<S>(at.robot, at.step * middle.qd));
}

// The sizes of the terms of the derivatives, and of the matrices made of them.
struct MiddleMagnitude {
  explicit MiddleMagnitude(const At& at)
      : middle(at),
        inverse(middle.newton.inverse().cwiseAbs()),
        tangents(size_of_tangents_to_the_middle(at.robot, at.step / 2 * (at.qd.cwiseAbs() + at.qd_end.cwiseAbs()))),
        by_q(ref::position_derivative_magnitude(middle.there.at.robot, middle.there.at.q, middle.qd, middle.qdd)),
        by_qd(ref::rate_derivative_magnitude(middle.there.at.robot, middle.there.at.q, middle.qd)),
        inertia(ref::inertia_magnitude(middle.there.at.robot, middle.there.at.q)),
        newton(inertia + middle.by_motion(by_q, by_qd, tangents)) {}

  Middle<double> middle;
  ref::MatrixX<double> inverse;
  Tangents<double> tangents;
  ref::MatrixX<double> by_q, by_qd, inertia, newton;
};

// Errors of the motion in the middle change the torques as derivatives say.
std::vector<double> iteration_magnitude(const At& at) {
  using Vector = ref::VectorX<double>;
  const MiddleMagnitude size(at);
  const Middle<double>& middle = size.middle;
  const Vector rate = (at.qd.cwiseAbs() + at.qd_end.cwiseAbs()) / 2, acceleration = 2 / at.step * rate;
  const Vector position = position_magnitude(at) + middle.half * rate;
  const At& there = middle.there.at;
  const Vector residual = ref::torque_magnitude(there.robot, there.q, middle.qd, acceleration) + at.tau.cwiseAbs() +
                          size.by_q * position + size.by_qd * rate;
  const Vector change = quotient<double>(middle.newton, middle.residual).cwiseAbs();
  const Vector rates = at.qd_end.cwiseAbs() + at.step * (size.inverse * (residual + size.newton * change));
  std::vector<double> entries = step_magnitude(at, middle.half * (at.qd.cwiseAbs() + rates), rates);
  entries.insert(entries.end(), residual.begin(), residual.end());
  return entries;
}

std::vector<double> midpoint_derivative_magnitude(const At& at) {
  const MiddleMagnitude size(at);
  const Middle<double>& middle = size.middle;
  const Eigen::Index n = at.qd.size();
  ref::MatrixX<double> right(n, 3 * n);
  right << at.step * (size.by_q * size.tangents.by_position), size.newton,
      at.step * ref::MatrixX<double>::Identity(n, n);
  const ref::MatrixX<double> own = quotient<double>(middle.newton, right_side(at, middle)).cwiseAbs();
  return derivative_entries<double>(
      size.inverse * (right + size.newton * own), middle.half,
      size_of_tangents_along(at.robot, middle.half * (at.qd.cwiseAbs() + at.qd_end.cwiseAbs())));
}

}  // namespace

constinit const NumericReference midpoint_step = computed_by([](const auto& at) { return after_iteration(at); },
                                                             [](const At& at) { return iteration_magnitude(at); });

constinit const NumericReference midpoint_step_derivatives =
    computed_by([](const auto& at) { return midpoint_derivatives(at); },
                [](const At& at) { return midpoint_derivative_magnitude(at); });

}  // namespace flatdyn::references
