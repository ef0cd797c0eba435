// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/derivative_references.hpp"

#include "truth/reference/acceleration_magnitude.hpp"
#include "truth/reference/magnitude.hpp"

namespace flatdyn {

reference::AccelerationDerivatives<double> acceleration_derivative_magnitudes(const ReferencePoint<double>& at) {
  using Matrix = reference::MatrixX<double>;
  const Matrix inverse = absolute_inverse(at), inertia = reference::inertia_magnitude(at.robot, at.q);
  const auto d = reference::forward_dynamics_derivatives(at.robot, at.q, at.qd, at.tau);
  const Matrix by_q = reference::position_derivative_magnitude(at.robot, at.q, at.qd, acceleration_magnitude(at));
  const Matrix by_qd = reference::rate_derivative_magnitude(at.robot, at.q, at.qd);
  return {inverse * (by_q + inertia * d.dq.cwiseAbs()), inverse * (by_qd + inertia * d.dqd.cwiseAbs()),
          inverse * inertia * d.dtau.cwiseAbs()};
}

namespace references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

template <class S>
std::vector<S> torque_entries(const ReferencePoint<S>& at) {
  const auto d = ref::inverse_dynamics_derivatives(at.robot, at.q, at.qd, at.qdd);
  return one_after_the_other<S>({d.dq, d.dqd});
}

template <class S>
std::vector<S> acceleration_entries(const ReferencePoint<S>& at) {
  const auto d = ref::forward_dynamics_derivatives(at.robot, at.q, at.qd, at.tau);
  return one_after_the_other<S>({d.dq, d.dqd, d.dtau});
}

std::vector<double> torque_derivative_magnitude(const At& at) {
  return one_after_the_other<double>({ref::position_derivative_magnitude(at.robot, at.q, at.qd, at.qdd),
                                      ref::rate_derivative_magnitude(at.robot, at.q, at.qd)});
}

}  // namespace

constinit const NumericReference inverse_dynamics_derivatives = computed_by(
    [](const auto& at) { return torque_entries(at); }, [](const At& at) { return torque_derivative_magnitude(at); });

constinit const NumericReference forward_dynamics_derivatives =
    computed_by([](const auto& at) { return acceleration_entries(at); },
                [](const At& at) {
                  const auto d = acceleration_derivative_magnitudes(at);
                  return one_after_the_other<double>({d.dq, d.dqd, d.dtau});
                });

}  // namespace references
}  // namespace flatdyn
