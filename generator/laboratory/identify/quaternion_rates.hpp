// SPDX-License-Identifier: GPL-2.0-or-later
// Angular velocities from smoothed quaternions.
#pragma once

#include <Eigen/Geometry>

namespace flatdyn {

// A quaternion that is smoothed entry by entry, so that its length is not quite 1, and its derivatives give a rotation
// R and, in the axes that R turns, the angular velocity ω and its derivative, rad/s, rad/s².
struct QuaternionRates {
  Eigen::Quaterniond turn;  // of unit length
  Eigen::Vector3d velocity, acceleration;
};

// Each argument: w, x, y, z. ω = 2 Im(q̄ q̇) / |q|².
inline QuaternionRates quaternion_rates(const Eigen::Vector4d& q, const Eigen::Vector4d& qd,
                                        const Eigen::Vector4d& qdd) {
  const auto quaternion_of = [](const Eigen::Vector4d& wxyz) {
    return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  };
  const double square = q.squaredNorm();
  const Eigen::Quaterniond back = quaternion_of(q).conjugate();
  const Eigen::Vector3d velocity = 2 / square * (back * quaternion_of(qd)).vec();
  const Eigen::Vector3d acceleration = 2 / square * ((back * quaternion_of(qdd)).vec() - q.dot(qd) * velocity);
  return {quaternion_of(q).normalized(), velocity, acceleration};
}

}  // namespace flatdyn
