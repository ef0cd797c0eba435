// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "planar_2r" as flat code in C99: planar_2r.h says how it is used.
// Made by flatdyn 0.1.0; to change it, make it again.
//
// Names count from 1 as in the textbook: q_1 is q[0], s_1 its sine, c_1 its cosine, s_2_3 the sine
// of the angle by which parallel joints 2 and 3 together turn. Of link i: omega_i and domega_i are
// its angular velocity and acceleration, ddp_i the acceleration of its frame's origin less gravity,
// f_i and mu_i the force and moment that it gets from the link before, hc_i and hu_i the first
// moment of all that its joint carries (in gravity() times the size of gravity); t1, t2, ... are
// parts of sums. A distance between joints may be the unit of length here, though not of arguments.

#include "planar_2r.h"

#include <math.h>

const char* const planar_2r_joint_names[PLANAR_2R_JOINT_COUNT] = {"theta_1", "theta_2"};

// Of the positions of these joints, both ends included.
static void planar_2r_sines_and_cosines(const double* q, int first, int last,
    double* restrict sine, double* restrict cosine) {
  for (int joint = first; joint <= last; ++joint) {
    sine[joint] = sin(q[joint]);
    cosine[joint] = cos(q[joint]);
  }
}

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
void planar_2r_inverse_dynamics_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, const double* qdd, double* restrict tau) {
  const double qd_1 = qd[0], qd_2 = qd[1];
  const double qdd_1 = qdd[0], qdd_2 = qdd[1];
  const double g = parameters->g, a_1 = parameters->a_1, m_l1 = parameters->m_l1,
      l_1 = parameters->l_1, I_l1 = parameters->I_l1, I_m1 = parameters->I_m1,
      k_r1 = parameters->k_r1, m_l2 = parameters->m_l2, l_2 = parameters->l_2,
      I_l2 = parameters->I_l2, m_m2 = parameters->m_m2, I_m2 = parameters->I_m2,
      k_r2 = parameters->k_r2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double t1 = g * c_1;
  const double ddp_o_2_y = t1 + a_1 * qdd_1;
  const double ddp_2_y = s_2 * (a_1 * qd_1 * qd_1 - g * s_1) + c_2 * ddp_o_2_y;
  const double t2 = m_l2 * l_2;
  const double I_2_zz = I_l2 + l_2 * t2;
  const double domega_2_z = qdd_1 + qdd_2;
  const double N_2_z = ddp_2_y * t2 + domega_2_z * I_2_zz;
  const double t3 = a_1 * (m_l2 + m_m2);
  const double t4 = m_l1 * l_1;
  const double I_1_zz = I_l1 + I_m2 + l_1 * t4 + a_1 * t3;
  const double t5 = qdd_1 * (I_m1 * k_r1 * k_r1 + I_1_zz);
  const double omega_2_z = qd_1 + qd_2;
  const double t6 = a_1 * t2 * (s_2 * omega_2_z * omega_2_z - c_2 * domega_2_z);
  const double mr_1_x = t4 + t3;
  const double t7 = I_m2 * k_r2;
  tau[0] = t1 * mr_1_x + qdd_2 * t7 + N_2_z - t6 + t5;
  tau[1] = t7 * (qdd_1 + k_r2 * qdd_2) + N_2_z;
}

void planar_2r_inverse_dynamics(const planar_2r_parameters* parameters, const double* q,
    const double* qd, const double* qdd, double* restrict tau) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  planar_2r_inverse_dynamics_given(parameters, sine, cosine, qd, qdd, tau);
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
void planar_2r_inverse_dynamics_tip_force_given(const planar_2r_parameters* parameters,
    const double* sine, const double* cosine, const double* qd, const double* qdd,
    const double* h_e, double* restrict tau) {
  const double qd_1 = qd[0], qd_2 = qd[1];
  const double qdd_1 = qdd[0], qdd_2 = qdd[1];
  const double h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_6 = h_e[5];
  const double g = parameters->g, a_1 = parameters->a_1, m_l1 = parameters->m_l1,
      l_1 = parameters->l_1, I_l1 = parameters->I_l1, I_m1 = parameters->I_m1,
      k_r1 = parameters->k_r1, a_2 = parameters->a_2, m_l2 = parameters->m_l2,
      l_2 = parameters->l_2, I_l2 = parameters->I_l2, m_m2 = parameters->m_m2,
      I_m2 = parameters->I_m2, k_r2 = parameters->k_r2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const double t1 = s_1 * h_e_1 - c_1 * h_e_2;
  const double t2 = s_2 * f_e1_x + c_2 * t1;
  const double t3 = g * c_1;
  const double ddp_o_2_y = t3 + a_1 * qdd_1;
  const double ddp_2_y = s_2 * (a_1 * qd_1 * qd_1 - g * s_1) + c_2 * ddp_o_2_y;
  const double t4 = m_l2 * l_2;
  const double I_2_zz = I_l2 + l_2 * t4;
  const double domega_2_z = qdd_1 + qdd_2;
  const double mu_2_z = h_e_6 - a_2 * t2 + ddp_2_y * t4 + domega_2_z * I_2_zz;
  const double t5 = I_m2 * k_r2;
  tau[1] = t5 * (qdd_1 + k_r2 * qdd_2) + mu_2_z;
  const double omega_2_z = qd_1 + qd_2;
  const double t6 = s_2 * (s_2 * t1 - c_2 * f_e1_x + omega_2_z * omega_2_z * t4);
  const double t7 = a_1 * (t6 + c_2 * (t2 - domega_2_z * t4));
  const double t8 = a_1 * (m_l2 + m_m2);
  const double t9 = m_l1 * l_1;
  const double I_1_zz = I_l1 + I_m2 + l_1 * t9 + a_1 * t8;
  const double t10 = qdd_1 * (I_m1 * k_r1 * k_r1 + I_1_zz);
  const double mr_1_x = t9 + t8;
  tau[0] = t3 * mr_1_x + qdd_2 * t5 + mu_2_z - t7 + t10;
}

void planar_2r_inverse_dynamics_tip_force(const planar_2r_parameters* parameters, const double* q,
    const double* qd, const double* qdd, const double* h_e, double* restrict tau) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  planar_2r_inverse_dynamics_tip_force_given(parameters, sine, cosine, qd, qdd, h_e, tau);
}

const bool planar_2r_inertia_matrix_nonzero[4] = {
    1, 1,
    1, 1};

// Joint-space inertia matrix B(q) (7.32).
void planar_2r_inertia_matrix_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* restrict B) {
  (void)sine;
  const double a_1 = parameters->a_1, m_l1 = parameters->m_l1, l_1 = parameters->l_1,
      I_l1 = parameters->I_l1, I_m1 = parameters->I_m1, k_r1 = parameters->k_r1,
      m_l2 = parameters->m_l2, l_2 = parameters->l_2, I_l2 = parameters->I_l2,
      m_m2 = parameters->m_m2, I_m2 = parameters->I_m2, k_r2 = parameters->k_r2;
  const double c_2 = cosine[1];
  const double t1 = m_l2 * l_2;
  const double Ic_2_zz = I_l2 + l_2 * t1;
  const double t2 = t1 * a_1 * c_2;
  const double t3 = a_1 * a_1 * (m_l2 + m_m2);
  B[0] = I_l1 + I_m2 + Ic_2_zz + I_m1 * k_r1 * k_r1 + 2.0 * t2 + m_l1 * l_1 * l_1 + t3;
  const double t4 = I_m2 * k_r2;
  B[3] = Ic_2_zz + k_r2 * t4;
  B[1] = B[2] = t2 + Ic_2_zz + t4;
}

void planar_2r_inertia_matrix(const planar_2r_parameters* parameters, const double* q,
    double* restrict B) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 1, 1, sine, cosine);
  planar_2r_inertia_matrix_given(parameters, sine, cosine, B);
}

const bool planar_2r_christoffel_nonzero[6] = {
    0, 1, 1,
    1, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
void planar_2r_christoffel_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* restrict c) {
  (void)cosine;
  const double a_1 = parameters->a_1, m_l2 = parameters->m_l2, l_2 = parameters->l_2;
  const double s_2 = sine[1];
  const double c_2_1_1 = a_1 * m_l2 * l_2 * s_2;
  c[3] = c_2_1_1;
  c[1] = c[2] = -c_2_1_1;
  c[0] = c[4] = c[5] = 0.0;
}

void planar_2r_christoffel(const planar_2r_parameters* parameters, const double* q,
    double* restrict c) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 1, 1, sine, cosine);
  planar_2r_christoffel_given(parameters, sine, cosine, c);
}

const bool planar_2r_coriolis_matrix_nonzero[4] = {
    1, 1,
    1, 0};

// C(q, qd) from the Christoffel symbols (7.44).
void planar_2r_coriolis_matrix_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, double* restrict C) {
  (void)cosine;
  const double qd_1 = qd[0], qd_2 = qd[1];
  const double a_1 = parameters->a_1, m_l2 = parameters->m_l2, l_2 = parameters->l_2;
  const double s_2 = sine[1];
  const double t1 = l_2 * s_2 * a_1 * m_l2;
  const double C_21 = qd_1 * t1;
  C[2] = C_21;
  const double t2 = qd_2 * t1;
  C[0] = -t2;
  C[1] = -t2 - C_21;
  C[3] = 0.0;
}

void planar_2r_coriolis_matrix(const planar_2r_parameters* parameters, const double* q,
    const double* qd, double* restrict C) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 1, 1, sine, cosine);
  planar_2r_coriolis_matrix_given(parameters, sine, cosine, qd, C);
}

// Gravity torques g(q) (7.39).
void planar_2r_gravity_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* restrict g) {
  const double g_2 = parameters->g, a_1 = parameters->a_1, m_l1 = parameters->m_l1,
      l_1 = parameters->l_1, m_l2 = parameters->m_l2, l_2 = parameters->l_2,
      m_m2 = parameters->m_m2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double t1 = (s_1 * s_2 - c_1 * c_2) * m_l2 * l_2;
  g[1] = -g_2 * t1;
  g[0] = -g_2 * (t1 - c_1 * (m_l1 * l_1 + a_1 * (m_l2 + m_m2)));
}

void planar_2r_gravity(const planar_2r_parameters* parameters, const double* q,
    double* restrict g) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  planar_2r_gravity_given(parameters, sine, cosine, g);
}

// C(q, qd) qd + g(q) + friction (7.116).
void planar_2r_bias_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, double* restrict n) {
  const double qd_1 = qd[0], qd_2 = qd[1];
  const double g = parameters->g, a_1 = parameters->a_1, m_l1 = parameters->m_l1,
      l_1 = parameters->l_1, m_l2 = parameters->m_l2, l_2 = parameters->l_2,
      m_m2 = parameters->m_m2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double t1 = g * c_1;
  const double ddp_2_y = c_2 * t1 + s_2 * (a_1 * qd_1 * qd_1 - g * s_1);
  const double t2 = m_l2 * l_2;
  const double N_2_z = ddp_2_y * t2;
  n[1] = N_2_z;
  const double mr_1_x = m_l1 * l_1 + a_1 * (m_l2 + m_m2);
  const double omega_2_z = qd_1 + qd_2;
  n[0] = t1 * mr_1_x + N_2_z - a_1 * s_2 * omega_2_z * omega_2_z * t2;
}

void planar_2r_bias(const planar_2r_parameters* parameters, const double* q, const double* qd,
    double* restrict n) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  planar_2r_bias_given(parameters, sine, cosine, qd, n);
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
bool planar_2r_forward_dynamics_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, const double* tau, double* restrict qdd) {
  const double qd_1 = qd[0], qd_2 = qd[1];
  const double tau_1 = tau[0], tau_2 = tau[1];
  const double g = parameters->g, a_1 = parameters->a_1, m_l1 = parameters->m_l1,
      l_1 = parameters->l_1, I_l1 = parameters->I_l1, I_m1 = parameters->I_m1,
      k_r1 = parameters->k_r1, m_l2 = parameters->m_l2, l_2 = parameters->l_2,
      I_l2 = parameters->I_l2, m_m2 = parameters->m_m2, I_m2 = parameters->I_m2,
      k_r2 = parameters->k_r2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double t1 = g * c_1;
  const double ddp_2_y = c_2 * t1 + s_2 * (a_1 * qd_1 * qd_1 - g * s_1);
  const double t2 = m_l2 * l_2;
  const double t3 = t2 * ddp_2_y;
  const double t4 = tau_2 - t3;
  const double Ic_2_zz = I_l2 + l_2 * t2;
  const double t5 = I_m2 * k_r2;
  const double b_2_2 = Ic_2_zz + k_r2 * t5;
  const double d_2 = 1.0 / b_2_2;
  const double t6 = a_1 * t2;
  const double t7 = c_2 * t6;
  const double mu_2_1_z = t7 + Ic_2_zz + t5;
  const double t8 = mu_2_1_z * d_2;
  const double t9 = a_1 * (m_l2 + m_m2);
  const double t10 = m_l1 * l_1;
  const double mr_1_x = t10 + t9;
  const double omega_2_z = qd_1 + qd_2;
  const double t11 = s_2 * t6 * omega_2_z * omega_2_z;
  const double b_2_1_1 = I_l1 + I_m2 + Ic_2_zz + 2.0 * t7 + I_m1 * k_r1 * k_r1 + l_1 * t10 +
      a_1 * t9 - mu_2_1_z * t8;
  const double qdd_1 = (-t1 * mr_1_x - t3 + tau_1 - t8 * t4 + t11) / b_2_1_1;
  qdd[0] = qdd_1;
  qdd[1] = d_2 * (t4 - mu_2_1_z * qdd_1);
  bool positive = b_2_1_1 > 0.0;
  positive &= b_2_2 > 0.0;
  return positive;
}

bool planar_2r_forward_dynamics(const planar_2r_parameters* parameters, const double* q,
    const double* qd, const double* tau, double* restrict qdd) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  return planar_2r_forward_dynamics_given(parameters, sine, cosine, qd, tau, qdd);
}

// Kinetic energy of links and rotors (7.31).
double planar_2r_kinetic_energy_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd) {
  (void)sine;
  const double qd_1 = qd[0], qd_2 = qd[1];
  const double a_1 = parameters->a_1, m_l1 = parameters->m_l1, l_1 = parameters->l_1,
      I_l1 = parameters->I_l1, I_m1 = parameters->I_m1, k_r1 = parameters->k_r1,
      m_l2 = parameters->m_l2, l_2 = parameters->l_2, I_l2 = parameters->I_l2,
      m_m2 = parameters->m_m2, I_m2 = parameters->I_m2, k_r2 = parameters->k_r2;
  const double c_2 = cosine[1];
  const double t1 = m_l2 * l_2;
  const double I_2_zz = I_l2 + l_2 * t1;
  const double omega_2_z = qd_1 + qd_2;
  const double t2 = 2.0 * qd_1;
  const double L_2_z = omega_2_z * I_2_zz + a_1 * c_2 * t1 * t2;
  const double t3 = a_1 * a_1 * (m_l2 + m_m2);
  const double I_1_zz = I_l1 + I_m2 + m_l1 * l_1 * l_1 + t3;
  const double t4 = qd_1 * qd_1 * (I_m1 * k_r1 * k_r1 + I_1_zz);
  const double t5 = k_r2 * qd_2;
  const double T_2 = I_m2 * t5 * (t5 + t2) + omega_2_z * L_2_z + t4;
  return 0.5 * T_2;
}

double planar_2r_kinetic_energy(const planar_2r_parameters* parameters, const double* q,
    const double* qd) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 1, 1, sine, cosine);
  return planar_2r_kinetic_energy_given(parameters, sine, cosine, qd);
}

// Potential energy of links and rotors (7.36).
double planar_2r_potential_energy_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine) {
  const double g = parameters->g, a_1 = parameters->a_1, m_l1 = parameters->m_l1,
      l_1 = parameters->l_1, m_l2 = parameters->m_l2, l_2 = parameters->l_2,
      m_m2 = parameters->m_m2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double t1 = m_l2 * l_2;
  const double hc_1_x = c_2 * t1 + m_l1 * l_1 + a_1 * (m_l2 + m_m2);
  const double hu_1_t_y = c_1 * s_2 * t1 + s_1 * hc_1_x;
  return g * hu_1_t_y;
}

double planar_2r_potential_energy(const planar_2r_parameters* parameters, const double* q) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  return planar_2r_potential_energy_given(parameters, sine, cosine);
}

const bool planar_2r_forward_kinematics_R_nonzero[9] = {
    1, 1, 0,
    1, 1, 0,
    0, 0, 1};

// Pose of the tip (2.50).
void planar_2r_forward_kinematics_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* restrict R, double* restrict p) {
  const double a_1 = parameters->a_1, a_2 = parameters->a_2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double t1 = c_1 * s_2;
  const double n_1_t_y = s_1 * c_2 + t1;
  R[3] = n_1_t_y;
  const double t2 = s_1 * s_2;
  R[0] = R[4] = c_1 * c_2 - t2;
  R[1] = -n_1_t_y;
  const double p_2_x = a_2 * c_2 + a_1;
  p[1] = a_2 * t1 + s_1 * p_2_x;
  p[0] = c_1 * p_2_x - a_2 * t2;
  R[8] = 1.0;
  R[2] = R[5] = R[6] = R[7] = p[2] = 0.0;
}

void planar_2r_forward_kinematics(const planar_2r_parameters* parameters, const double* q,
    double* restrict R, double* restrict p) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  planar_2r_forward_kinematics_given(parameters, sine, cosine, R, p);
}

const bool planar_2r_jacobian_nonzero[12] = {
    1, 1,
    1, 1,
    0, 0,
    0, 0,
    0, 0,
    1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
void planar_2r_jacobian_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, double* restrict J) {
  const double a_1 = parameters->a_1, a_2 = parameters->a_2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double p_2_x = a_2 * c_2 + a_1;
  const double t1 = a_2 * s_2;
  const double t2 = s_1 * t1 - c_1 * p_2_x;
  J[2] = -t2;
  const double p_1u_t_y = c_1 * t1 + s_1 * p_2_x;
  J[0] = -p_1u_t_y;
  J[3] = -t2 - a_1 * c_1;
  J[1] = a_1 * s_1 - p_1u_t_y;
  J[10] = J[11] = 1.0;
  J[4] = J[5] = J[6] = J[7] = J[8] = J[9] = 0.0;
}

void planar_2r_jacobian(const planar_2r_parameters* parameters, const double* q,
    double* restrict J) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  planar_2r_jacobian_given(parameters, sine, cosine, J);
}

// (dJ/dt) qd of the tip.
void planar_2r_jacobian_dot_qd_given(const planar_2r_parameters* parameters, const double* sine,
    const double* cosine, const double* qd, double* restrict a) {
  const double qd_1 = qd[0], qd_2 = qd[1];
  const double a_1 = parameters->a_1, a_2 = parameters->a_2;
  const double s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const double omega_2_z = qd_1 + qd_2;
  const double t1 = omega_2_z * a_2 * omega_2_z;
  const double t2 = qd_1 * a_1 * qd_1;
  const double t3 = s_2 * s_2 * t2 + c_2 * (c_2 * t2 + t1);
  const double t4 = s_2 * t1;
  a[0] = s_1 * t4 - c_1 * t3;
  a[1] = -s_1 * t3 - c_1 * t4;
  a[2] = a[3] = a[4] = a[5] = 0.0;
}

void planar_2r_jacobian_dot_qd(const planar_2r_parameters* parameters, const double* q,
    const double* qd, double* restrict a) {
  double sine[PLANAR_2R_JOINT_COUNT], cosine[PLANAR_2R_JOINT_COUNT];
  planar_2r_sines_and_cosines(q, 0, 1, sine, cosine);
  planar_2r_jacobian_dot_qd_given(parameters, sine, cosine, qd, a);
}

static bool planar_2r_is_zero(double r) {
  return !(r < 0.0) && !(r > 0.0);
}

bool planar_2r_rounding_is_as_written(void) {
  const volatile double a = 0.1, b = 0.7, one = 1.0, tiny = 1e-17, nine = 9.0,
      seven = 7.0, half = 0.5, smallest = 0x1p-1022;
  // Half a unit in the last place of 1, and a little more.
  const volatile double half_a_place = 0x1.001p-53;
  const volatile double product = a * b, quotient = nine / seven, next = one + half_a_place;
  const double x = one, y = tiny;
  // In this order: no fused multiply-add, no digits too many; none too few, rounded only once; no
  // other order, no rounding upward, or downward; no reciprocal; nothing is flushed to zero.
  return planar_2r_is_zero(a * b - product) &&
         next > one &&
         planar_2r_is_zero((x + y) - x) &&
         planar_2r_is_zero((x - y) - x) &&
         planar_2r_is_zero(nine / 7.0 - quotient) &&
         smallest * half > 0.0;
}
