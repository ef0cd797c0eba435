// SPDX-License-Identifier: BSD-3-Clause
// Euler angles of a rotation matrix, (2.19) and (2.22), and the matrix T between their rates and the angular velocity,
// ω = T(φ) φ̇, (3.64). T is computed from the angles; generated code takes their sines and cosines from R.
#pragma once

#include "flatdyn/reference/kinematics.hpp"

namespace flatdyn::reference {

enum class Angles { none, zyz, rpy };  // R_z(φ) R_y(θ) R_z(ψ); R_z(φ) R_y(θ) R_x(ψ)

// (φ, θ, ψ), with 0 < θ < π for ZYZ and -π/2 < θ < π/2 for roll, pitch and yaw.
template <class S>
Vector3<S> euler_angles(const Matrix3<S>& R, Angles angles) {
  using std::atan2;
  using std::sqrt;
  if (angles == Angles::zyz) {
    const S sine = sqrt(S(R(0, 2) * R(0, 2) + R(1, 2) * R(1, 2)));
    return {atan2(R(1, 2), R(0, 2)), atan2(sine, R(2, 2)), atan2(R(2, 1), S(-R(2, 0)))};
  }
  const S cosine = sqrt(S(R(2, 1) * R(2, 1) + R(2, 2) * R(2, 2)));
  return {atan2(R(1, 0), R(0, 0)), atan2(S(-R(2, 0)), cosine), atan2(R(2, 1), R(2, 2))};
}

// T: its columns are the axes about which φ, θ and ψ turn, in base axes.
template <class S>
Matrix3<S> rates_to_velocity(const Vector3<S>& angles, Angles kind) {
  using std::cos;
  using std::sin;
  const S s_phi = sin(angles[0]), c_phi = cos(angles[0]), s_theta = sin(angles[1]), c_theta = cos(angles[1]);
  Matrix3<S> T;
  if (kind == Angles::zyz) {
    T << S(0), -s_phi, c_phi * s_theta, S(0), c_phi, s_phi * s_theta, S(1), S(0), c_theta;
  } else {
    T << S(0), -s_phi, c_phi * c_theta, S(0), c_phi, s_phi * c_theta, S(1), S(0), -s_theta;
  }
  return T;
}

// dT/dt for these rates of the angles.
template <class S>
Matrix3<S> rates_to_velocity_dot(const Vector3<S>& angles, const Vector3<S>& rates, Angles kind) {
  using std::cos;
  using std::sin;
  const S s_phi = sin(angles[0]), c_phi = cos(angles[0]), s_theta = sin(angles[1]), c_theta = cos(angles[1]);
  const S phi = rates[0], theta = rates[1];
  Matrix3<S> T;
  if (kind == Angles::zyz) {
    T << S(0), -c_phi * phi, c_phi * c_theta * theta - s_phi * s_theta * phi,  //
        S(0), -s_phi * phi, s_phi * c_theta * theta + c_phi * s_theta * phi,   //
        S(0), S(0), -s_theta * theta;
  } else {
    T << S(0), -c_phi * phi, -c_phi * s_theta * theta - s_phi * c_theta * phi,  //
        S(0), -s_phi * phi, -s_phi * s_theta * theta + c_phi * c_theta * phi,   //
        S(0), S(0), -c_theta * theta;
  }
  return T;
}

}  // namespace flatdyn::reference
