// SPDX-License-Identifier: BSD-3-Clause
// One step of the classical Runge–Kutta method of order 4 for a robot, suitable for firmware: constant steps, no heap,
// no exceptions, only arithmetic. `flatdyn simulate --method rk4` steps the same way.
//
//   const auto arm = [&](const float* q, const float* qd, float* qdd) {
//     return panda::forward_dynamics(q, qd, tau, qdd);
//   };
//   flatdyn::rk4_step<7>(q, qd, 0.001f, arm);
#pragma once

namespace flatdyn {

// Advances q, qd (n numbers each: rad, rad/s; m, m/s) by dt (s). accelerations(q, qd, qdd) writes n numbers, or returns
// false if it cannot; then the step returns false and leaves q and qd unchanged. The error of a step is proportional to
// dt^5 if the accelerations are smooth, which Coulomb friction is not.
template <int n, class Scalar, class Accelerations>
bool rk4_step(Scalar* q, Scalar* qd, Scalar dt, const Accelerations& accelerations) {
  constexpr int kStages = 4;
  // The time from the start to each stage.
  const Scalar ahead[kStages] = {Scalar(0.0), dt / Scalar(2.0), dt / Scalar(2.0), dt};
  // The weight of each stage in the sum.
  const Scalar part[kStages] = {Scalar(1.0), Scalar(2.0), Scalar(2.0), Scalar(1.0)};
  Scalar slope_q[n] = {}, slope_qd[n] = {}, sum_q[n] = {}, sum_qd[n] = {};
  for (int stage = 0; stage < kStages; ++stage) {
    Scalar stage_q[n], stage_qd[n];
    for (int i = 0; i < n; ++i) {
      stage_q[i] = q[i] + ahead[stage] * slope_q[i];
      stage_qd[i] = qd[i] + ahead[stage] * slope_qd[i];
    }
    if (!accelerations(stage_q, stage_qd, slope_qd)) return false;
    for (int i = 0; i < n; ++i) {
      slope_q[i] = stage_qd[i];
      sum_q[i] += part[stage] * slope_q[i];
      sum_qd[i] += part[stage] * slope_qd[i];
    }
  }
  for (int i = 0; i < n; ++i) {
    q[i] += dt / Scalar(6.0) * sum_q[i];
    qd[i] += dt / Scalar(6.0) * sum_qd[i];
  }
  return true;
}

}  // namespace flatdyn
