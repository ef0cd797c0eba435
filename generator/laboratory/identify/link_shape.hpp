// SPDX-License-Identifier: GPL-2.0-or-later
// A physically consistent link and its joint, as a change of those in the robot file. The search for physical
// parameters moves these.
#pragma once

#include <Eigen/Core>

#include "derivation/parameters/parameters.hpp"

namespace flatdyn {

// The symmetric matrix of ten coordinates; its Frobenius norm is their length.
Eigen::Matrix4d symmetric_matrix(const double* ten);
// The ten coordinates of a symmetric matrix, the inverse of symmetric_matrix().
void coordinates_of(const Eigen::Matrix4d& symmetric, double* ten);

// A link with pseudo-inertia L S Sᵀ Lᵀ, where L Lᵀ is that of the file, and with I_m, F_v, F_s as multiples of the
// file's, or of values to start from that the file does not have. The search starts at S = E and multiples of 1, and
// keeps S triangular with a positive diagonal.
struct LinkShape {
  static constexpr int kOthers = kParametersPerJoint - kInertialPerBody;
  using Vector = Eigen::Matrix<double, kParametersPerJoint, 1>;
  using Matrix = Eigen::Matrix<double, kParametersPerJoint, kParametersPerJoint>;

  Eigen::Matrix4d L, S = Eigen::Matrix4d::Identity();
  double others[kOthers] = {}, multiples[kOthers] = {1, 1, 1};
  bool in_file[kOthers] = {true, true, true};

  // 13 parameters, in the order of (7.77).
  void parameters(double* pi) const;
  // Column k is the change of the parameters by coordinate y_k of 13: P changes by L S X Sᵀ Lᵀ with X = sym(y), the
  // others by shares of themselves.
  Matrix changes() const;
  // The log-determinant divergence from the start: convex, 0 at the start, infinite where P is not positive definite.
  double divergence() const;
  // The same without those of I_m, F_v, F_s that the file does not have.
  double divergence_from_file() const;
  // The gradient in y; the second derivative is the unit matrix.
  Vector gradient() const;
  // Moves the link by y. E + sym(y) must be positive definite and all other entries above -1.
  void move(const double* y);
};

}  // namespace flatdyn
