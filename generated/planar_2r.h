// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "planar_2r" as flat code in C99: 2 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Options: --language c
// Input: sha1:17cf213b905ae502b84e32529e8d0b9a088c7411
//
//   index  joint    moves link  type      unit
//   0      theta_1  link1       revolute  rad
//   1      theta_2  link2       revolute  rad
//
// Gravity is (0, -g, 0) m/s^2 in the base frame. The tip belongs to link "link2".
//
// All numbers are of type double. Arguments are plain arrays, of the lengths that comments say:
//
//   planar_2r_parameters parameters = {0};  // then set its members
//   double q[2] = {0}, qd[2] = {0}, qdd[2] = {0}, tau[2];
//   planar_2r_inverse_dynamics(&parameters, q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too.
// Inputs may share memory with each other. An output must overlap no other argument: the
// definitions say "restrict" of outputs. Nothing allocates, traps, or keeps state.
//
// Matrices come row by row: Eigen's types that are filled with them say Eigen::RowMajor.
//
// C++ may include this header, too. Compiled with -ffp-contract=off, results have the same bits as
// those of the C++ form.
//
// Sines and cosines come from <math.h>. Who has them from elsewhere (resolvers, a CORDIC unit, a
// table) calls the functions that end in _given: they take sine and cosine, by index, in place of
// q, and q itself only where the position of a prismatic joint is read.

#ifndef FLATDYN_PLANAR_2R_H_3C295271
#define FLATDYN_PLANAR_2R_H_3C295271

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { PLANAR_2R_JOINT_COUNT = 2 };

// As the robot file names them.
extern const char* const planar_2r_joint_names[PLANAR_2R_JOINT_COUNT];

// What the robot file leaves open: an argument of every function. Units as in the file.
typedef struct {
  double g;  // m/s^2
  double a_1;  // m
  double m_l1;  // kg
  double l_1;  // m
  double I_l1;  // kg m^2
  double m_m1;  // kg
  double I_m1;  // kg m^2
  double k_r1;
  double a_2;  // m
  double m_l2;  // kg
  double l_2;  // m
  double I_l2;  // kg m^2
  double m_m2;  // kg
  double I_m2;  // kg m^2
  double k_r2;
} planar_2r_parameters;

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], qd[0..1], qdd[0..1], parameters->g, parameters->a_1, parameters->m_l1,
// parameters->l_1, parameters->I_l1, parameters->I_m1, parameters->k_r1, parameters->m_l2,
// parameters->l_2, parameters->I_l2, parameters->m_m2, parameters->I_m2, parameters->k_r2.
// Operations: 28 mul, 20 add, 4 sin/cos.
void planar_2r_inverse_dynamics(const planar_2r_parameters* parameters, const double* q,
    const double* qd, const double* qdd, double* tau);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
void planar_2r_inverse_dynamics_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, const double* qdd, double* tau);

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], qd[0..1], qdd[0..1], h_e[0..1], h_e[5], parameters->g, parameters->a_1,
// parameters->m_l1, parameters->l_1, parameters->I_l1, parameters->I_m1, parameters->k_r1,
// parameters->a_2, parameters->m_l2, parameters->l_2, parameters->I_l2, parameters->m_m2,
// parameters->I_m2, parameters->k_r2. Operations: 38 mul, 28 add, 4 sin/cos.
void planar_2r_inverse_dynamics_tip_force(const planar_2r_parameters* parameters, const double* q,
    const double* qd, const double* qdd, const double* h_e, double* tau);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
void planar_2r_inverse_dynamics_tip_force_given(const planar_2r_parameters* parameters,
    const double* sine, const double* cosine, const double* qd, const double* qdd,
    const double* h_e, double* tau);

// The entries of B in planar_2r_inertia_matrix that are not always zero.
extern const bool planar_2r_inertia_matrix_nonzero[4];

// Joint-space inertia matrix B(q) (7.32).
//   q[2]  in   joint positions, rad or m
//   B[4]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              2 x 2, row by row: entry (i, j) is B[2 * i + j]
// Reads q[1], parameters->a_1, parameters->m_l1, parameters->l_1, parameters->I_l1,
// parameters->I_m1, parameters->k_r1, parameters->m_l2, parameters->l_2, parameters->I_l2,
// parameters->m_m2, parameters->I_m2, parameters->k_r2. Operations: 13 mul, 11 add, 1 sin/cos.
void planar_2r_inertia_matrix(const planar_2r_parameters* parameters, const double* q, double* B);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 1.
void planar_2r_inertia_matrix_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* B);

// The entries of c in planar_2r_christoffel that are not always zero.
extern const bool planar_2r_christoffel_nonzero[6];

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[2]  in   joint positions, rad or m
//   c[6]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[3 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1], parameters->a_1, parameters->m_l2, parameters->l_2. Operations: 3 mul, 0 add, 1
// sin/cos. Always zero: 3 of the 6 entries of c.
void planar_2r_christoffel(const planar_2r_parameters* parameters, const double* q, double* c);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 1.
void planar_2r_christoffel_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* c);

// The entries of C in planar_2r_coriolis_matrix that are not always zero.
extern const bool planar_2r_coriolis_matrix_nonzero[4];

// C(q, qd) from the Christoffel symbols (7.44).
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   C[4]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               2 x 2, row by row: entry (i, j) is C[2 * i + j]
// Reads q[1], qd[0..1], parameters->a_1, parameters->m_l2, parameters->l_2. Operations: 5 mul, 1
// add, 1 sin/cos. Always zero: 1 of the 4 entries of C.
void planar_2r_coriolis_matrix(const planar_2r_parameters* parameters, const double* q,
    const double* qd, double* C);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 1.
void planar_2r_coriolis_matrix_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, double* C);

// Gravity torques g(q) (7.39).
//   q[2]  in   joint positions, rad or m
//   g[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], parameters->g, parameters->a_1, parameters->m_l1, parameters->l_1,
// parameters->m_l2, parameters->l_2, parameters->m_m2. Operations: 9 mul, 4 add, 4 sin/cos.
void planar_2r_gravity(const planar_2r_parameters* parameters, const double* q, double* g);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
void planar_2r_gravity_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* g);

// C(q, qd) qd + g(q) + friction (7.116).
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   n[2]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], qd[0..1], parameters->g, parameters->a_1, parameters->m_l1, parameters->l_1,
// parameters->m_l2, parameters->l_2, parameters->m_m2. Operations: 15 mul, 7 add, 4 sin/cos.
void planar_2r_bias(const planar_2r_parameters* parameters, const double* q, const double* qd,
    double* n);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
void planar_2r_bias_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, double* n);

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   tau[2]  in   joint torques or forces, N m or N
//   qdd[2]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0..1], qd[0..1], tau[0..1], parameters->g, parameters->a_1, parameters->m_l1,
// parameters->l_1, parameters->I_l1, parameters->I_m1, parameters->k_r1, parameters->m_l2,
// parameters->l_2, parameters->I_l2, parameters->m_m2, parameters->I_m2, parameters->k_r2.
// Operations: 29 mul, 22 add, 2 div, 4 sin/cos.
bool planar_2r_forward_dynamics(const planar_2r_parameters* parameters, const double* q,
    const double* qd, const double* tau, double* qdd);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
bool planar_2r_forward_dynamics_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, const double* tau, double* qdd);

// Kinetic energy of links and rotors (7.31).
//   q[2]   in  joint positions, rad or m
//   qd[2]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1], qd[0..1], parameters->a_1, parameters->m_l1, parameters->l_1, parameters->I_l1,
// parameters->I_m1, parameters->k_r1, parameters->m_l2, parameters->l_2, parameters->I_l2,
// parameters->m_m2, parameters->I_m2, parameters->k_r2. Operations: 20 mul, 11 add, 1 sin/cos.
double planar_2r_kinetic_energy(const planar_2r_parameters* parameters, const double* q,
    const double* qd);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 1.
double planar_2r_kinetic_energy_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd);

// Potential energy of links and rotors (7.36).
//   q[2]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[0..1], parameters->g, parameters->a_1, parameters->m_l1, parameters->l_1,
// parameters->m_l2, parameters->l_2, parameters->m_m2. Operations: 8 mul, 4 add, 4 sin/cos.
double planar_2r_potential_energy(const planar_2r_parameters* parameters, const double* q);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
double planar_2r_potential_energy_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine);

// The entries of R in planar_2r_forward_kinematics that are not always zero.
extern const bool planar_2r_forward_kinematics_R_nonzero[9];

// Pose of the tip (2.50).
//   q[2]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..1], parameters->a_1, parameters->a_2. Operations: 9 mul, 5 add, 4 sin/cos. Always
// zero: 4 of the 9 entries of R. Always zero: p[2].
void planar_2r_forward_kinematics(const planar_2r_parameters* parameters, const double* q,
    double* R, double* p);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
void planar_2r_forward_kinematics_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* R, double* p);

// The entries of J in planar_2r_jacobian that are not always zero.
extern const bool planar_2r_jacobian_nonzero[12];

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[2]   in   joint positions, rad or m
//   J[12]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 2, row by row: entry (i, j) is J[2 * i + j]
// Reads q[0..1], parameters->a_1, parameters->a_2. Operations: 8 mul, 5 add, 4 sin/cos. Always
// zero: 6 of the 12 entries of J.
void planar_2r_jacobian(const planar_2r_parameters* parameters, const double* q, double* J);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
void planar_2r_jacobian_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* J);

// (dJ/dt) qd of the tip.
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..1], qd[0..1], parameters->a_1, parameters->a_2. Operations: 13 mul, 5 add, 4 sin/cos.
// Always zero: a[2], a[3], a[4], a[5].
void planar_2r_jacobian_dot_qd(const planar_2r_parameters* parameters, const double* q,
    const double* qd, double* a);
// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, k = 0..1.
void planar_2r_jacobian_dot_qd_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, double* a);

// Whether the source of this header was compiled so that every operation is rounded as it is
// written, to nearest: compilers fuse products into sums unless they are given -ffp-contract=off,
// and -ffast-math or x87 registers change more. What certificates say of rounding errors holds if
// this is true.
bool planar_2r_rounding_is_as_written(void);

#ifdef __cplusplus
}
#endif

#endif  // FLATDYN_PLANAR_2R_H_3C295271
