// SPDX-License-Identifier: GPL-2.0-or-later
// Coordinates of what turns in all directions where a motion is planned: roll, pitch and yaw, rad, the turns about x, y
// and z of R = Rz(yaw) Ry(pitch) Rx(roll), from where the motion begins. A floating base has three more before them:
// where its frame's origin is, x, y and z, m, in the axes that the base has where the motion begins.
#pragma once

#include <Eigen/Geometry>

namespace flatdyn {

// A turn from the moving axes to those of the beginning, and in the moving axes the angular velocity and its
// derivative, rad/s, rad/s².
struct TurnState {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), acceleration = Eigen::Vector3d::Zero();
};

// Roll, pitch and yaw, their rates and accelerations: three numbers each.
TurnState turn_state(const double* angles, const double* rates, const double* accelerations);

// The motion of a floating base.
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
