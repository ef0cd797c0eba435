/* SPDX-License-Identifier: BSD-3-Clause */
/* The dynamics of the Panda as acados asks for them, by generated functions: the state is x = (q, qd), the control
 * u = tau, and the parameter p = h is the length of a step, which discrete dynamics need. acados' own generator writes
 * functions of these names from CasADi's expressions; these have the same arguments and results, column by column, and
 * all of their entries are stored. Each returns 0, or 1 where forward dynamics have no value or p is not given.
 *
 * Explicit dynamics are xdot = (qd, qdd(q, qd, tau)). Implicit dynamics are 0 = (xdot_q - qd, tau(q, qd, xdot_qd) - u):
 * no matrix is inverted. Discrete dynamics are a step of the classical Runge-Kutta method. */
#include <stddef.h>
#include <string.h>

#include "panda.h"

#ifndef casadi_int
#define casadi_int int
#endif

enum { N = PANDA_JOINT_COUNT, NX = 2 * N, NU = N, NP = 1 };

/* What CasADi's interface says beside a function: the number, shapes and sparsity of its arguments and results. */
typedef const casadi_int Shape[3]; /* rows, columns, and 1: all entries are stored */
static Shape of_x = {NX, 1, 1}, of_u = {NU, 1, 1}, of_p = {NP, 1, 1}, of_z = {0, 0, 1}, of_t = {0, 0, 1},
             of_Sx = {NX, NX, 1}, of_Su = {NX, NU, 1}, of_adj = {NX + NU, 1, 1}, of_jac_z = {NX, 0, 1},
             of_jac_ux = {NU + NX, NX, 1};

#define INTERFACE(NAME)                                                                                         \
  casadi_int panda_##NAME##_n_in(void) { return sizeof NAME##_in / sizeof *NAME##_in; }                         \
  casadi_int panda_##NAME##_n_out(void) { return sizeof NAME##_out / sizeof *NAME##_out; }                      \
  const casadi_int* panda_##NAME##_sparsity_in(casadi_int i) { return NAME##_in[i]; }                           \
  const casadi_int* panda_##NAME##_sparsity_out(casadi_int i) { return NAME##_out[i]; }                         \
  int panda_##NAME##_work(casadi_int* arg, casadi_int* res, casadi_int* iw, casadi_int* w) {                    \
    if (arg) *arg = panda_##NAME##_n_in();                                                                      \
    if (res) *res = panda_##NAME##_n_out();                                                                     \
    if (iw) *iw = 0;                                                                                            \
    if (w) *w = 0;                                                                                              \
    return 0;                                                                                                   \
  }                                                                                                             \
  int panda_##NAME(const double** arg, double** res, casadi_int* iw, double* w, void* mem)

/* An argument that is not given is zero. */
static const double* given(const double* argument) {
  static const double zeros[NX * NX];
  return argument ? argument : zeros;
}

static void ignore(const void* iw, const void* w, const void* mem) { (void)iw, (void)w, (void)mem; }

/* Rows of a matrix that is stored row by row become rows, from `first` on, of one with `rows` rows stored by columns. */
static void put_rows(const double* matrix, int columns, int rows, int first, double* to) {
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < columns; ++k) to[k * rows + first + i] = matrix[i * columns + k];
  }
}

static void put_diagonal(double value, int rows, int row, int column, double* to) {
  for (int i = 0; i < N; ++i) to[(column + i) * rows + row + i] = value;
}

static int explicit_dynamics(const double* x, const double* u, double* xdot) {
  double qdd[N];
  const int failed = !panda_forward_dynamics(x, x + N, u, qdd);
  memcpy(xdot, x + N, sizeof qdd);
  memcpy(xdot + N, qdd, sizeof qdd);
  return failed;
}

static const casadi_int* const expl_ode_fun_in[] = {of_x, of_u, of_p};
static const casadi_int* const expl_ode_fun_out[] = {of_x};
INTERFACE(expl_ode_fun) {
  ignore(iw, w, mem);
  return res[0] ? explicit_dynamics(given(arg[0]), given(arg[1]), res[0]) : 0;
}

/* The derivatives of xdot by the initial state and by a constant control, from those of x: S' = F S + (0, df/du). */
static const casadi_int* const expl_vde_forw_in[] = {of_x, of_Sx, of_Su, of_u, of_p};
static const casadi_int* const expl_vde_forw_out[] = {of_x, of_Sx, of_Su};
INTERFACE(expl_vde_forw) {
  ignore(iw, w, mem);
  const double *x = given(arg[0]), *u = given(arg[3]);
  double by_q[N * N], by_qd[N * N], by_tau[N * N];
  int failed = !panda_forward_dynamics_derivatives(x, x + N, u, by_q, by_qd, by_tau);
  for (int which = 0; which < 2; ++which) {
    const double* S = given(arg[1 + which]);
    double* to = res[1 + which];
    const int columns = which == 0 ? NX : NU;
    for (int k = 0; k < columns && to; ++k) {
      for (int i = 0; i < N; ++i) {
        double rate = which == 0 ? 0 : by_tau[i * N + k];
        for (int j = 0; j < N; ++j) rate += by_q[i * N + j] * S[k * NX + j] + by_qd[i * N + j] * S[k * NX + N + j];
        to[k * NX + i] = S[k * NX + N + i];
        to[k * NX + N + i] = rate;
      }
    }
  }
  if (res[0]) failed |= explicit_dynamics(x, u, res[0]);
  return failed;
}

/* The derivatives of lambda^T xdot by x and u. */
static const casadi_int* const expl_vde_adj_in[] = {of_x, of_x, of_u, of_p};
static const casadi_int* const expl_vde_adj_out[] = {of_adj};
INTERFACE(expl_vde_adj) {
  ignore(iw, w, mem);
  if (!res[0]) return 0;
  const double *x = given(arg[0]), *lambda = given(arg[1]), *u = given(arg[2]);
  const int failed = !panda_vjp_forward_dynamics(x, x + N, u, lambda + N, res[0], res[0] + N, res[0] + NX);
  for (int i = 0; i < N; ++i) res[0][N + i] += lambda[i];
  return failed;
}

/* Results of implicit dynamics that are not asked for are null. */
static void implicit_dynamics(const double** arg, double* value, double* by_x, double* by_xdot, double* by_u) {
  const double *x = given(arg[0]), *xdot = given(arg[1]), *u = given(arg[2]);
  double tau[N], by_q[N * N], by_qd[N * N], B[N * N];
  if (value) {
    panda_inverse_dynamics(x, x + N, xdot + N, tau);
    for (int i = 0; i < N; ++i) {
      value[i] = xdot[i] - x[N + i];
      value[N + i] = tau[i] - u[i];
    }
  }
  if (by_x) {
    memset(by_x, 0, NX * NX * sizeof *by_x);
    panda_inverse_dynamics_derivatives(x, x + N, xdot + N, by_q, by_qd);
    put_diagonal(-1, NX, 0, N, by_x);
    put_rows(by_q, N, NX, N, by_x);
    put_rows(by_qd, N, NX, N, by_x + N * NX);
  }
  if (by_xdot) {
    memset(by_xdot, 0, NX * NX * sizeof *by_xdot);
    panda_inertia_matrix(x, B);
    put_diagonal(1, NX, 0, 0, by_xdot);
    put_rows(B, N, NX, N, by_xdot + N * NX);
  }
  if (by_u) {
    memset(by_u, 0, NX * NU * sizeof *by_u);
    put_diagonal(-1, NX, N, 0, by_u);
  }
}

static const casadi_int* const impl_dae_fun_in[] = {of_x, of_x, of_u, of_z, of_t, of_p};
static const casadi_int* const impl_dae_fun_out[] = {of_x};
INTERFACE(impl_dae_fun) {
  ignore(iw, w, mem);
  implicit_dynamics(arg, res[0], NULL, NULL, NULL);
  return 0;
}

#define impl_dae_fun_jac_x_xdot_z_in impl_dae_fun_in
static const casadi_int* const impl_dae_fun_jac_x_xdot_z_out[] = {of_x, of_Sx, of_Sx, of_jac_z};
INTERFACE(impl_dae_fun_jac_x_xdot_z) {
  ignore(iw, w, mem);
  implicit_dynamics(arg, res[0], res[1], res[2], NULL);
  return 0;
}

#define impl_dae_fun_jac_x_xdot_u_in impl_dae_fun_in
static const casadi_int* const impl_dae_fun_jac_x_xdot_u_out[] = {of_x, of_Sx, of_Sx, of_Su};
INTERFACE(impl_dae_fun_jac_x_xdot_u) {
  ignore(iw, w, mem);
  implicit_dynamics(arg, res[0], res[1], res[2], res[3]);
  return 0;
}

#define impl_dae_fun_jac_x_xdot_u_z_in impl_dae_fun_in
static const casadi_int* const impl_dae_fun_jac_x_xdot_u_z_out[] = {of_x, of_Sx, of_Sx, of_Su, of_jac_z};
INTERFACE(impl_dae_fun_jac_x_xdot_u_z) {
  ignore(iw, w, mem);
  implicit_dynamics(arg, res[0], res[1], res[2], res[3]);
  return 0;
}

#define impl_dae_jac_x_xdot_u_z_in impl_dae_fun_in
static const casadi_int* const impl_dae_jac_x_xdot_u_z_out[] = {of_Sx, of_Sx, of_Su, of_jac_z};
INTERFACE(impl_dae_jac_x_xdot_u_z) {
  ignore(iw, w, mem);
  implicit_dynamics(arg, NULL, res[0], res[1], res[2]);
  return 0;
}

static int discrete_dynamics(const double** arg, double* phi) {
  const double* x = given(arg[0]);
  return !arg[2] || !panda_step_rk4(x, x + N, given(arg[1]), given(arg[2]), phi, phi + N);
}

static const casadi_int* const dyn_disc_phi_fun_in[] = {of_x, of_u, of_p};
static const casadi_int* const dyn_disc_phi_fun_out[] = {of_x};
INTERFACE(dyn_disc_phi_fun) {
  ignore(iw, w, mem);
  return res[0] ? discrete_dynamics(arg, res[0]) : 0;
}

/* The second result is the transposed derivative by (u, x). */
#define dyn_disc_phi_fun_jac_in dyn_disc_phi_fun_in
static const casadi_int* const dyn_disc_phi_fun_jac_out[] = {of_x, of_jac_ux};
INTERFACE(dyn_disc_phi_fun_jac) {
  ignore(iw, w, mem);
  const double* x = given(arg[0]);
  int failed = !arg[2] || (res[0] && discrete_dynamics(arg, res[0]));
  if (!res[1]) return failed;
  double A[NX * NX], B[NX * NU];
  failed |= !panda_step_derivatives_rk4(x, x + N, given(arg[1]), given(arg[2]), A, B);
  for (int i = 0; i < NX; ++i) {
    memcpy(res[1] + i * (NU + NX), B + i * NU, NU * sizeof *B);
    memcpy(res[1] + i * (NU + NX) + NU, A + i * NX, NX * sizeof *A);
  }
  return failed;
}
