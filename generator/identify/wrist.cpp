// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/wrist.hpp"

#include <numeric>

#include "flatdyn/reference/newton_euler.hpp"
#include "reference/reference_model.hpp"

namespace flatdyn {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kWrench = LogLayout::kWrench;
constexpr int kUnknowns = kInertialPerBody + kWrench;

Matrix3d cross_matrix(const Vector3d& a) {
  Matrix3d S;
  S << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return S;
}

// The matrix that gives Î a when multiplied by the six entries of Î in the order of (7.77).
Eigen::Matrix<double, 3, 6> inertia_times(const Vector3d& a) {
  Eigen::Matrix<double, 3, 6> L;
  L << a.x(), a.y(), a.z(), 0, 0, 0, 0, a.x(), 0, a.y(), a.z(), 0, 0, 0, a.x(), 0, a.y(), a.z();
  return L;
}

// The force and moment of a body about the frame's origin as a matrix times its ten parameters, (7.112), (7.113).
Eigen::Matrix<double, kWrench, kInertialPerBody> wrench_regressor(const reference::LinkMotion<double>& motion) {
  Eigen::Matrix<double, kWrench, kInertialPerBody> A = decltype(A)::Zero();
  const Matrix3d omega = cross_matrix(motion.omega);
  A.block<3, 1>(0, 0) = motion.ddp;
  A.block<3, 3>(0, 1) = cross_matrix(motion.domega) + omega * omega;
  A.block<3, 3>(3, 1) = -cross_matrix(motion.ddp);
  A.block<3, 6>(3, 4) = inertia_times(motion.domega) + omega * inertia_times(motion.omega);
  return A;
}

}  // namespace

WristEquations::WristEquations(const Robot& robot)
    : robot_(reference_robot<double>(robot, {})), joints_(static_cast<int>(moving_joints(robot).size())) {
  parameters_ = kUnknowns;
  std::vector<int> inertial(kInertialPerBody);
  std::iota(inertial.begin(), inertial.end(), 0);
  for (int k = 0; k < kWrench; ++k) {
    columns_.push_back(inertial);
    columns_.back().push_back(kInertialPerBody + k);
    has_friction_.push_back(false);
  }
}

void WristEquations::evaluate(const MeasuredMotion& motion, double* entries, double* known) const {
  const auto vector = [this](const double* from) { return VectorXd(Eigen::Map<const VectorXd>(from, joints_)); };
  const auto motions =
      reference::link_motions<double>(robot_, vector(motion.q), vector(motion.qd), vector(motion.qdd), true);
  const auto A = wrench_regressor(motions[static_cast<std::size_t>(robot_.tip)]);
  for (int k = 0; k < kWrench; ++k) {
    for (int column = 0; column < kInertialPerBody; ++column) *entries++ = A(k, column);
    *entries++ = 1;
    known[k] = 0;
  }
}

void WristEquations::require(const LogLayout& layout, const Place& place, Diagnostics& diagnostics) const {
  if (layout.has_tip_force) return;
  diagnostics.error(place, "no columns fx, fy, fz, mx, my, mz (or h_e1, ...) of the sensor at the wrist");
}

PayloadEstimate estimate_payload_at_wrist(const Observations& observations) {
  return payload_of(estimate(observations, VectorXd::Zero(kUnknowns)));
}

}  // namespace flatdyn
