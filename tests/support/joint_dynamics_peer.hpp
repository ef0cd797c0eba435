// SPDX-License-Identifier: GPL-2.0-or-later
// Another library's dynamics of a robot's joints, without rotors and friction; positions, rates and torques are indexed
// by joint.
#pragma once

#include "flatdyn/reference/robot.hpp"

namespace flatdyn::testing {

class JointDynamicsPeer {
 public:
  using Vector = reference::VectorX<double>;
  using Matrix = reference::MatrixX<double>;

  JointDynamicsPeer() = default;
  JointDynamicsPeer(const JointDynamicsPeer&) = delete;
  JointDynamicsPeer& operator=(const JointDynamicsPeer&) = delete;
  virtual ~JointDynamicsPeer() = default;

  virtual Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) = 0;
  virtual Matrix inertia_matrix(const Vector& q) = 0;
  virtual Vector gravity(const Vector& q) = 0;
  virtual Vector forward_dynamics(const Vector& q, const Vector& qd, const Vector& tau) = 0;
};

}  // namespace flatdyn::testing
