// SPDX-License-Identifier: BSD-3-Clause
// The controller of arrays.cpp with Eigen's types.
#include "flatdyn/eigen.hpp"
#include "panda.hpp"

namespace arm = panda::functions;

Eigen::Matrix<double, 7, 1> q, qd, qdd, tau;
Eigen::Matrix<double, 6, 1> h_e;
Eigen::Matrix<double, panda::base_parameter_count, 1> pi_b;
volatile double sink;

void keep(double value) { sink = value; }
template <class Derived>
void keep(const Eigen::MatrixBase<Derived>& result) {
  sink = result.sum();
}
template <class... Result>
void keep(const std::tuple<Result...>& results) {
  std::apply([](const auto&... result) { (keep(result), ...); }, results);
}
template <class Result>
void keep(const std::optional<Result>& result) {
  if (result) keep(*result);
}

int main() {
  keep(flatdyn::eigen<arm::inverse_dynamics>(q, qd, qdd));
  keep(flatdyn::eigen<arm::inverse_dynamics_tip_force>(q, qd, qdd, h_e));
  keep(flatdyn::eigen<arm::inertia_matrix>(q));
  keep(flatdyn::eigen<arm::christoffel>(q));
  keep(flatdyn::eigen<arm::coriolis_matrix>(q, qd));
  keep(flatdyn::eigen<arm::gravity>(q));
  keep(flatdyn::eigen<arm::bias>(q, qd));
  keep(flatdyn::eigen<arm::forward_dynamics>(q, qd, tau));
  keep(flatdyn::eigen<arm::kinetic_energy>(q, qd));
  keep(flatdyn::eigen<arm::potential_energy>(q));
  keep(flatdyn::eigen<arm::forward_kinematics>(q));
  keep(flatdyn::eigen<arm::jacobian>(q));
  keep(flatdyn::eigen<arm::jacobian_dot_qd>(q, qd));
  keep(flatdyn::eigen<arm::inverse_dynamics_derivatives>(q, qd, qdd));
  keep(flatdyn::eigen<arm::forward_dynamics_derivatives>(q, qd, tau));
  keep(flatdyn::eigen<arm::regressor>(q, qd, qdd));
  keep(flatdyn::eigen<arm::base_regressor>(q, qd, qdd));
  panda::base_parameters(pi_b.data());
  keep(flatdyn::eigen<arm::inverse_dynamics_base>(q, qd, qdd, pi_b));
}
