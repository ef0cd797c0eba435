// SPDX-License-Identifier: GPL-2.0-or-later
// The scale for rounding errors. A relative error is meaningless where a torque passes through zero; the size of the
// terms that are added up is what counts. The magnitude of a torque is the value of the Newton–Euler recursion with
// every vector replaced by its length and every sign by plus: the sum of the absolute values of the torque's own terms.
// Code that loses bits by more additions and subtractions than the physics needs shows large errors on this scale;
// cancellation that is inherent in the robot does not.
#pragma once

#include "truth/reference/motion_magnitude.hpp"

namespace flatdyn::reference {

struct MagnitudeOptions {
  bool gravity = true;
  bool friction = true;
  bool springs = true;
  double f_e = 0, mu_e = 0;  // lengths of the tip's force, N, and moment, N m
};

// The magnitude of each entry of inverse_dynamics, N m or N.
VectorX<double> torque_magnitude(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd,
                                 const VectorX<double>& qdd, const MagnitudeOptions& options = {});

// The magnitude of B: that of the torques for unit accelerations.
MatrixX<double> inertia_magnitude(const Robot<double>& robot, const VectorX<double>& q);

// The magnitudes of c_ijk, j <= k, laid out as in christoffel(): those of the velocity torque for two unit rates.
MatrixX<double> christoffel_magnitude(const Robot<double>& robot, const VectorX<double>& q);

// The magnitude of C: Σ_k mag(c_ijk) |q̇_k|.
MatrixX<double> coriolis_magnitude(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd);

// The magnitude of the derivatives of inverse_dynamics by q. A rotation by a small angle changes a term by at most its
// size times the angle; for a prismatic joint a displacement by a unit is used.
MatrixX<double> position_derivative_magnitude(const Robot<double>& robot, const VectorX<double>& q,
                                              const VectorX<double>& qd, const VectorX<double>& qdd);

// The magnitude of the derivative of a joint's dry friction by its rate.
double dry_friction_slope_magnitude(const Joint<double>& joint);

// The magnitude of the derivatives by q̇: 2 C and friction.
MatrixX<double> rate_derivative_magnitude(const Robot<double>& robot, const VectorX<double>& q,
                                          const VectorX<double>& qd);

// The length of the path from the base to the tip's origin along the links, m.
double reach(const Robot<double>& robot, const VectorX<double>& coordinates);

// The magnitude of J. The column of a revolute joint is an axis crossed with the difference of two positions, and that
// axis; that of a prismatic joint is an axis; joints that do not move the tip have zeros.
MatrixX<double> jacobian_magnitude(const Robot<double>& robot, const VectorX<double>& q);

// The magnitudes of J̇ q̇: the tip's acceleration, linear and angular, by the recursion over lengths.
Eigen::Vector2d tip_acceleration_magnitude(const Robot<double>& robot, const VectorX<double>& coordinates,
                                           const VectorX<double>& coordinate_rates);

// The magnitude of the potential energy: Σ |m| ‖g_0‖ · (length of the path to the centre of mass).
double potential_magnitude(const Robot<double>& robot, const VectorX<double>& coordinates);

}  // namespace flatdyn::reference
