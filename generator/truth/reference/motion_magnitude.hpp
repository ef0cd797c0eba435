// SPDX-License-Identifier: GPL-2.0-or-later
// Magnitudes of the joints' motion: the size of the terms that positions, rates and accelerations are sums of and, if
// loops are closed, of the terms from which the dependent joints are found. Errors of that size in the equations of a
// loop are multiplied by |Φ_d⁻¹| in their solution.
#pragma once

#include "flatdyn/reference/kinematics.hpp"

namespace flatdyn::reference {

// The magnitude of G.
MatrixX<double> loop_motion_magnitude(const Robot<double>& robot, const VectorX<double>& q);

// By independent joint, how fast terms may change that have G as a factor, relative to their magnitude: all joints move
// along, and so does G, whose equations may be ill-conditioned.
Eigen::RowVectorXd loop_motion_growth(const Robot<double>& robot, const VectorX<double>& q);

// The magnitude of γ.
VectorX<double> loop_drift_magnitude(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd);

// The magnitude of Φ: the lengths of the paths to both ends, and of their axes.
VectorX<double> loop_closure_magnitude(const Robot<double>& robot, const VectorX<double>& q);

// The magnitude of Φ_q.
MatrixX<double> loop_jacobian_magnitude(const Robot<double>& robot, const VectorX<double>& q);

// The magnitude of the Newton step.
VectorX<double> loop_step_magnitude(const Robot<double>& robot, const VectorX<double>& q);

namespace detail {

struct MotionMagnitude {
  double omega = 0, domega = 0, ddp = 0;

  double swing(double r) const { return (domega + omega * omega) * r; }
};

// The motion of a joint's child.
MotionMagnitude moved(const MotionMagnitude& parent, const Joint<double>& joint, double q, double qd, double qdd);

// The absolute value of a joint's entry, or of its three; 0 for a fixed joint.
double entry_of(const Joint<double>& joint, const VectorX<double>& values);

// The motion of the root link, for magnitudes of all rates and accelerations.
MotionMagnitude magnitude_of_root(const Robot<double>& robot, const VectorX<double>& qd, const VectorX<double>& qdd,
                                  bool gravity);

// The magnitude of A, or of A G.
MatrixX<double> motion_magnitude(const Robot<double>& robot, const VectorX<double>& q);

// The summed magnitudes of the terms of the joints' positions, rates and accelerations.
VectorX<double> of_joints(const Robot<double>& robot, const VectorX<double>& q);
VectorX<double> rates_of_joints(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd);
VectorX<double> accelerations_of_joints(const Robot<double>& robot, const VectorX<double>& q, const VectorX<double>& qd,
                                        const VectorX<double>& qdd);

}  // namespace detail

}  // namespace flatdyn::reference
