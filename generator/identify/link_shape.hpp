// SPDX-License-Identifier: GPL-2.0-or-later
// A link that a body can have, and its joint, as a change of the robot file's: what the search for physical parameters
// moves.
#pragma once

#include <Eigen/Core>

#include "symbolic/parameters/parameters.hpp"

namespace flatdyn {

// Symmetric matrices as ten coordinates, of the same length.
Eigen::Matrix4d symmetric_matrix(const double* ten);
void coordinates_of(const Eigen::Matrix4d& symmetric, double* ten);

// Pseudo-inertia L S Sᵀ Lᵀ, with L Lᵀ that of the file, and I_m, F_v, F_s as multiples of the file's. The search starts
// at S = E and multiples of 1, and keeps S triangular with a positive diagonal.
struct LinkShape {
  static constexpr int kOthers = kParametersPerJoint - kInertialPerBody;
  using Vector = Eigen::Matrix<double, kParametersPerJoint, 1>;
  using Matrix = Eigen::Matrix<double, kParametersPerJoint, kParametersPerJoint>;

  Eigen::Matrix4d L, S = Eigen::Matrix4d::Identity();
  double others[kOthers] = {}, multiples[kOthers] = {1, 1, 1};

  // 13, in the order of (7.77).
  void parameters(double* pi) const;
  // Columns: what each of thirteen coordinates y adds to the parameters; P changes by L S X Sᵀ Lᵀ with X = sym(y), the
  // others by parts of themselves.
  Matrix changes() const;
  // The log-determinant divergence from the file: convex, 0 at the file, infinite where P is no body's.
  double divergence() const;
  // Its gradient in y; its second derivative is the unit matrix.
  Vector gradient() const;
  // By y with E + sym(y) positive definite and all other entries above -1.
  void move(const double* y);
};

}  // namespace flatdyn
