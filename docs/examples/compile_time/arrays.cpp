// SPDX-License-Identifier: BSD-3-Clause
// A controller that calls 19 functions of a Panda, each once: what compiling it takes, scripts/bench-compile measures.
#include "panda.hpp"

double q[7], qd[7], qdd[7], tau[7], h_e[6], pi_b[panda::base_parameter_count];

struct Results {
  double tau[7], tau_of_tip_force[7], B[49], c[196], C[49], g[7], n[7], qdd[7], T, U, R[9], p[3], J[42], a[6];
  double dtau_dq[49], dtau_dqd[49], dqdd_dq[49], dqdd_dqd[49], dqdd_dtau[49];
  double Y[7 * 91], Y_b[7 * panda::base_parameter_count], pi_b[panda::base_parameter_count], tau_of_base[7];
} all;

int main() {
  panda::inverse_dynamics(q, qd, qdd, all.tau);
  panda::inverse_dynamics_tip_force(q, qd, qdd, h_e, all.tau_of_tip_force);
  panda::inertia_matrix(q, all.B);
  panda::christoffel(q, all.c);
  panda::coriolis_matrix(q, qd, all.C);
  panda::gravity(q, all.g);
  panda::bias(q, qd, all.n);
  const bool has_qdd = panda::forward_dynamics(q, qd, tau, all.qdd);
  all.T = panda::kinetic_energy(q, qd);
  all.U = panda::potential_energy(q);
  panda::forward_kinematics(q, all.R, all.p);
  panda::jacobian(q, all.J);
  panda::jacobian_dot_qd(q, qd, all.a);
  panda::inverse_dynamics_derivatives(q, qd, qdd, all.dtau_dq, all.dtau_dqd);
  const bool has_derivatives =
      panda::forward_dynamics_derivatives(q, qd, tau, all.dqdd_dq, all.dqdd_dqd, all.dqdd_dtau);
  panda::regressor(q, qd, qdd, all.Y);
  panda::base_regressor(q, qd, qdd, all.Y_b);
  panda::base_parameters(all.pi_b);
  panda::inverse_dynamics_base(q, qd, qdd, pi_b, all.tau_of_base);
  return has_qdd && has_derivatives ? 0 : 1;
}
