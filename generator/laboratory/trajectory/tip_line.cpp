// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/tip_line.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

constexpr std::size_t kSteps = 200;

// Singular values of J below this share of the largest count as zero: a planar arm's tip does not leave its plane.
constexpr double kRank = 1e-9;
// The part of the unit vector that rates may fail to reach.
constexpr double kAlongTheLine = 1e-7;

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& J) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(kRank);
  decomposition.compute(J);
  return decomposition.pseudoInverse();
}

// The angles plus the whole turns that bring them nearest to those before.
Eigen::VectorXd unwrapped(Eigen::VectorXd q, const Eigen::VectorXd& before) {
  for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = before[i] + std::remainder(q[i] - before[i], 2 * std::numbers::pi);
  return q;
}

}  // namespace

TipLine::TipLine(const TipKinematics& tip, const Eigen::VectorXd& q, const Eigen::Vector3d& by, bool hold_orientation)
    : tip_(tip), u_(by.normalized()), length_(by.norm()), nodes_{q} {
  const reference::Pose<double> here = tip.pose(q);
  start_.p = here.p;
  if (hold_orientation) start_.R = here.R;
  if (!hold_orientation) arm_ = TwoLinkArm::of(tip);
  for (std::size_t k = 0; k < kSteps; ++k) {
    try {
      nodes_.push_back(stepped(nodes_.back(), node(k), node(k + 1)));
    } catch (const Unreachable& failure) {
      throw Unreachable(fmt::format("{:.4g} m along a line of {:.4g} m: {}", node(k), length_, failure.what()));
    }
  }
}

double TipLine::node(std::size_t k) const { return length_ * static_cast<double>(k) / kSteps; }

Eigen::VectorXd TipLine::slope(const Eigen::VectorXd& q) const {
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(rows());
  wanted.head<3>() = u_;
  const Eigen::MatrixXd J = tip_.jacobian(q, rows());
  Eigen::VectorXd result = pseudo_inverse(J) * wanted;
  if ((J * result - wanted).norm() <= kAlongTheLine) return result;
  throw Unreachable(fmt::format(
      "no joint rates move the tip along the line{}: the arm is in a singular posture, or has too few joints",
      start_.R ? " with its orientation held" : ""));
}

// A fourth-order Runge–Kutta step, followed by a projection onto the line.
Eigen::VectorXd TipLine::stepped(const Eigen::VectorXd& q, double from, double to) const {
  if (arm_) return unwrapped(arm_->positions(goal(to).p, arm_->elbow_of(q)), q);
  const double h = to - from;
  if (h == 0) return q;
  const Eigen::VectorXd k_1 = slope(q), k_2 = slope(q + h / 2 * k_1), k_3 = slope(q + h / 2 * k_2),
                        k_4 = slope(q + h * k_3);
  return inverse_kinematics(tip_, goal(to), q + h / 6 * (k_1 + 2 * k_2 + 2 * k_3 + k_4));
}

LinePoint TipLine::at(double way) const {
  const auto before = std::min(static_cast<std::size_t>(way / length_ * kSteps), kSteps);
  const Eigen::VectorXd q = stepped(nodes_[before], node(before), way);
  const Eigen::VectorXd rate = slope(q);
  const Eigen::MatrixXd J = tip_.jacobian(q, rows()), pinv = pseudo_inverse(J);
  const Eigen::MatrixXd change = tip_.jacobian_rate(q, rate, rows());
  const Eigen::VectorXd free = change.transpose() * (pinv.transpose() * rate);
  return {q, rate, free - pinv * (J * free + change * rate)};
}

}  // namespace flatdyn
