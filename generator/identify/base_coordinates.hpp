// SPDX-License-Identifier: GPL-2.0-or-later
// Six coordinates of a floating base whose motion is planned: where its frame's origin is, x, y and z, m, and its roll,
// pitch and yaw, rad, the turns about x, y and z of R = Rz(yaw) Ry(pitch) Rx(roll); all from where the motion begins,
// in the axes that the base has there.
#pragma once

#include <Eigen/Geometry>

namespace flatdyn {

// The motion of the base, from these coordinates and their derivatives.
struct BaseState {
  using Six = Eigen::Matrix<double, 6, 1>;

  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  // from base axes to those of the beginning
  Six twist = Six::Zero();                                   // v and ω, base axes: m/s, rad/s
  Six twist_rates = Six::Zero();                             // the derivatives of these numbers: m/s², rad/s²

  // f = v̇ + ω × v - g_b, m/s², base axes. gravity: g_0 in the axes of the beginning.
  Eigen::Vector3d specific_force(const Eigen::Vector3d& gravity) const;
};

// Each argument: six numbers.
BaseState base_state(const double* coordinates, const double* rates, const double* accelerations);

}  // namespace flatdyn
