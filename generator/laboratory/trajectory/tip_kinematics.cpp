// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/tip_kinematics.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "functions/load/loaded_robot.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

constexpr double kReached = 1e-9;  // m, rad

std::string place_text(const Eigen::Vector3d& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", p[0], p[1], p[2]); }

reference::Robot<double> in_numbers(const Robot& robot) {
  require_numbers(robot, "a trajectory");
  return reference_robot<double>(robot, {});
}

// A robot with spherical joints at q, and the positions that the reference takes.
struct Oriented {
  reference::Robot<double> robot;
  Eigen::VectorXd q;

  Oriented(const reference::Robot<double>& at_rest, const Eigen::VectorXd& positions) : robot(at_rest), q(positions) {
    reference::take_orientations(robot, q);
  }
};

// The unit quaternion (w, x, y, z) of R exp(S(turn)), with R that of `quaternion`.
Eigen::Vector4d turned(const Eigen::Vector4d& quaternion, const Eigen::Vector3d& turn) {
  const Eigen::Quaterniond before(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  const Eigen::Quaterniond by(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()));
  const Eigen::Quaterniond after = (before * by).normalized();
  return {after.w(), after.x(), after.y(), after.z()};
}

}  // namespace

TipKinematics::TipKinematics(const Robot& robot)
    : robot_(in_numbers(robot)), with_slopes_(reference::with_tangents(robot_)) {}

reference::Pose<double> TipKinematics::pose(const Eigen::VectorXd& q) const {
  if (!reference::has_spherical_joints(robot_)) return reference::tip_pose(robot_, q);
  const Oriented oriented(robot_, q);
  return reference::tip_pose(oriented.robot, oriented.q);
}

Eigen::MatrixXd TipKinematics::jacobian(const Eigen::VectorXd& q, int rows) const {
  if (!reference::has_spherical_joints(robot_)) return reference::jacobian(robot_, q).topRows(rows);
  const Oriented oriented(robot_, q);
  return reference::jacobian(oriented.robot, oriented.q).topRows(rows);
}

Eigen::VectorXd TipKinematics::moved(const Eigen::VectorXd& q, const Eigen::VectorXd& step) const {
  if (!reference::has_spherical_joints(robot_)) return q + step;
  Eigen::VectorXd result = q;
  Eigen::Index entry = 0;
  for (const reference::Joint<double>& joint : robot_.joints) {
    if (joint.index < 0) continue;
    if (joint.type == reference::JointType::spherical) {
      result.segment<4>(entry) = turned(q.segment<4>(entry), step.segment<3>(joint.index));
      entry += 4;
    } else {
      result[entry++] += step[joint.index];
    }
  }
  return result;
}

Eigen::MatrixXd TipKinematics::jacobian_rate(const Eigen::VectorXd& q, const Eigen::VectorXd& qd, int rows) const {
  using T = reference::Tangent<double>;
  reference::VectorX<T> moving(q.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) moving[i] = T(q[i], qd[i]);
  const reference::MatrixX<T> J = reference::jacobian(with_slopes_, moving);
  return J.topRows(rows).unaryExpr([](const T& entry) { return entry.slope; });
}

Eigen::VectorXd TipKinematics::missing(const TipGoal& goal, const Eigen::VectorXd& q) const {
  const reference::Pose<double> here = pose(q);
  Eigen::VectorXd e(goal.R ? 6 : 3);
  e.head<3>() = goal.p - here.p;
  if (goal.R) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(*goal.R * here.R.transpose()));
    e.tail<3>() = turn.angle() * turn.axis();
  }
  return e;
}

Eigen::VectorXd inverse_kinematics(const TipKinematics& tip, const TipGoal& goal, const Eigen::VectorXd& guess) {
  constexpr int kMostSteps = 500;
  constexpr double kLeastDamping = 1e-14, kMostDamping = 1e8;
  Eigen::VectorXd q = guess, e = tip.missing(goal, q);
  double damping = 1e-3;
  for (int step = 0; step < kMostSteps && damping < kMostDamping && e.norm() > 0; ++step) {
    const Eigen::MatrixXd J = tip.jacobian(q, static_cast<int>(e.size()));
    Eigen::MatrixXd normal = J * J.transpose();
    normal.diagonal().array() += damping;
    const Eigen::VectorXd candidate = tip.moved(q, J.transpose() * normal.ldlt().solve(e));
    const Eigen::VectorXd rest = tip.missing(goal, candidate);
    if (rest.norm() < e.norm()) {
      q = candidate;
      e = rest;
      damping = std::max(damping / 10, kLeastDamping);
    } else if (e.norm() < kReached) {
      break;  // double allows no better
    } else {
      damping *= 4;
    }
  }
  if (e.norm() < kReached) return q;
  throw Unreachable(fmt::format("the tip does not get to {}{}: {:.3g} {} are missing at the nearest found",
                                place_text(goal.p), goal.R ? " with its orientation" : "", e.norm(),
                                goal.R ? "m and rad" : "m"));
}

std::optional<TwoLinkArm> TwoLinkArm::of(const TipKinematics& tip) {
  if (tip.joints() != 2) return std::nullopt;
  const auto& joints = tip.robot().joints;
  std::vector<reference::Joint<double>> moving;
  for (const auto& joint : joints) {
    if (joint.index >= 0) moving.push_back(joint);
  }
  const bool turn = moving[0].type == reference::JointType::revolute && moving[1].type == moving[0].type;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2);
  const Eigen::MatrixXd J = tip.jacobian(zero, 6);
  const Eigen::Vector3d z_1 = J.col(0).tail<3>(), z_2 = J.col(1).tail<3>();
  constexpr double kParallel = 1e-12;
  if (!turn || z_1.norm() == 0 || z_2.norm() == 0 || z_1.cross(z_2).norm() > kParallel) return std::nullopt;
  const std::vector<reference::Pose<double>> poses = reference::link_poses(tip.robot(), zero);
  const auto origin_of = [&](const reference::Joint<double>& joint) -> Eigen::Vector3d {
    const auto& parent = poses[static_cast<std::size_t>(joint.parent)];
    return parent.p + parent.R * joint.p_0;
  };
  const bool first_is_0 = moving[0].index == 0;
  TwoLinkArm arm;
  arm.origin_ = origin_of(moving[first_is_0 ? 0 : 1]);
  arm.z_ = z_1;
  arm.x_ = z_1.unitOrthogonal();
  arm.y_ = z_1.cross(arm.x_);
  arm.sense_ = z_1.dot(z_2) > 0 ? 1 : -1;
  const Eigen::Vector3d p_e = tip.pose(zero).p, elbow = origin_of(moving[first_is_0 ? 1 : 0]);
  arm.height_ = arm.z_.dot(p_e - arm.origin_);
  const Eigen::Vector2d first = arm.in_plane(elbow), second = arm.in_plane(p_e) - first;
  arm.a_1_ = first.norm();
  arm.a_2_ = second.norm();
  arm.phi_1_ = std::atan2(first[1], first[0]);
  arm.phi_2_ = std::atan2(second[1], second[0]);
  if (arm.a_1_ == 0 || arm.a_2_ == 0) return std::nullopt;
  return arm;
}

Eigen::Vector2d TwoLinkArm::in_plane(const Eigen::Vector3d& p) const {
  return {x_.dot(p - origin_), y_.dot(p - origin_)};
}

Elbow TwoLinkArm::elbow_of(const Eigen::VectorXd& q) const {
  return std::sin(phi_2_ - phi_1_ + sense_ * q[1]) >= 0 ? Elbow::down : Elbow::up;
}

Eigen::VectorXd TwoLinkArm::positions(const Eigen::Vector3d& p, Elbow elbow) const {
  if (std::abs(z_.dot(p - origin_) - height_) > kReached) {
    throw Unreachable(fmt::format("{} is not in the plane that the tip moves in", place_text(p)));
  }
  const Eigen::Vector2d d = in_plane(p);
  const double r = d.norm();
  double cosine = (r * r - a_1_ * a_1_ - a_2_ * a_2_) / (2 * a_1_ * a_2_);
  if (std::abs(cosine) > 1 + kReached) {
    throw Unreachable(fmt::format("{} is {:.6g} m from the first axis; the tip's distance is from {:.6g} to {:.6g} m",
                                  place_text(p), r, std::abs(a_1_ - a_2_), a_1_ + a_2_));
  }
  cosine = std::clamp(cosine, -1.0, 1.0);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine)) * (elbow == Elbow::down ? 1 : -1);
  const double bend = std::atan2(sine, cosine);
  const double first = std::atan2(d[1], d[0]) - std::atan2(a_2_ * sine, a_1_ + a_2_ * cosine);
  const auto within_a_turn = [](double angle) { return std::remainder(angle, 2 * std::numbers::pi); };
  Eigen::VectorXd q(2);
  q << within_a_turn(first - phi_1_), within_a_turn(sense_ * (bend - phi_2_ + phi_1_));
  return q;
}

}  // namespace flatdyn
