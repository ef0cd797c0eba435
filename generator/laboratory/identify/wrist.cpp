// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/wrist.hpp"

#include <numeric>

#include "flatdyn/reference/newton_euler.hpp"
#include "truth/reference/reference_model.hpp"

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

// Gravity is part of the motion of a floating base.
reference::Robot<double> robot_in_numbers(const LoadedRobot& model) {
  require_numbers(model.robot, "measured motion");
  reference::Robot<double> robot = reference_robot<double>(model.robot, {});
  if (robot.floating_base) robot.gravity.setZero();
  return robot;
}

}  // namespace

WristEquations::WristEquations(const LoadedRobot& model)
    : robot_(robot_in_numbers(model)), positions_(model.mechanism.position_count()), rates_(model.mechanism.size()) {
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
  const auto vector = [](const double* from, int size) { return VectorXd(Eigen::Map<const VectorXd>(from, size)); };
  VectorXd positions = vector(motion.q, positions_);
  reference::take_orientations(robot_, positions);
  const auto motions =
      reference::link_motions<double>(robot_, positions, vector(motion.qd, rates_), vector(motion.qdd, rates_), true);
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
