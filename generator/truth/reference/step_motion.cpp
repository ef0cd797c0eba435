// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/step_motion.hpp"

namespace flatdyn::references {
namespace {

using RobotInDouble = reference::Robot<double>;
using Vector = reference::VectorX<double>;

double sum_of_three(const Vector& x, Eigen::Index first) { return x.segment<3>(first).cwiseAbs().sum(); }

// Turns have entries up to 1, and an error of the size of an angle changes them by so much. `by_change`: those of a
// turn by a change; of joints it is `of_joints`.
Tangents<double> size_of_tangents(const RobotInDouble& robot, const Vector& change, double of_joints,
                                  double by_change) {
  Tangents<double> size = no_turns<double>(change.size(), of_joints);
  for (const Eigen::Index k : turning_entries(robot)) {
    const double turn = 1 + sum_of_three(change, k);
    size.by_position.block<3, 3>(k, k).setConstant(turn);
    size.by_change.block<3, 3>(k, k).setConstant(by_change * turn);
  }
  return size;
}

// The same with the displacement of a floating base.
Tangents<double> with_displacement(const RobotInDouble& robot, const Vector& change, double by_turn,
                                   Tangents<double> size) {
  if (!robot.floating_base) return size;
  const double turn = 1 + sum_of_three(change, 3), displacement = turn * sum_of_three(change, 0);
  size.by_position.topLeftCorner<3, 3>().setConstant(turn);
  size.by_change.topLeftCorner<3, 3>().setConstant(turn);
  size.by_position.block<3, 3>(0, 3).setConstant(displacement);
  size.by_change.block<3, 3>(0, 3).setConstant(by_turn * displacement);
  return size;
}

constexpr double kTurnByParameters = 4;  // T at σ = 0

}  // namespace

Tangents<double> size_of_tangents_in_chart(const RobotInDouble& robot, const Vector& c) {
  return with_displacement(robot, c, 0, size_of_tangents(robot, c, 1, kTurnByParameters));
}

Tangents<double> size_of_tangents_along(const RobotInDouble& robot, const Vector& w) {
  return with_displacement(robot, w, 1, size_of_tangents(robot, w, 1, 1));
}

Tangents<double> size_of_tangents_to_the_middle(const RobotInDouble& robot, const Vector& w) {
  return size_of_tangents(robot, w, 1.0 / 2, 1.0 / 2);
}

RateTangents<double> size_of_tangents_of_rates(const RobotInDouble& robot, const Vector& c, const Vector& v) {
  RateTangents<double> size{reference::MatrixX<double>::Zero(c.size(), c.size()),
                            reference::MatrixX<double>::Identity(c.size(), c.size())};
  for (const Eigen::Index k : turning_entries(robot)) {
    const double turn = 1 + sum_of_three(c, k);
    size.by_change.block<3, 3>(k, k).setConstant(turn * sum_of_three(v, k));
    size.by_velocity.block<3, 3>(k, k).setConstant(turn * turn);
  }
  if (!robot.floating_base) return size;
  const double turn = 1 + sum_of_three(c, 3);
  size.by_change.block<3, 3>(0, 3).setConstant(kTurnByParameters * turn * sum_of_three(v, 0));
  size.by_velocity.topLeftCorner<3, 3>().setConstant(turn);
  return size;
}

std::vector<double> step_magnitude(const ReferencePoint<double>& from, const Vector& change, const Vector& qd) {
  const RobotInDouble& robot = from.robot;
  const auto turn = [&change](Eigen::Index k) { return 1 + sum_of_three(change, k); };
  Vector positions = from.given_q.cwiseAbs();
  if (!reference::has_spherical_joints(robot)) positions += change.tail(positions.size());
  Eigen::Index entry = 0;
  for (const reference::Joint<double>& joint : robot.joints) {
    if (joint.index < 0 || !reference::has_spherical_joints(robot)) continue;
    if (joint.type == reference::JointType::spherical) {
      positions.segment<4>(entry).setConstant(turn(joint.index) * positions.segment<4>(entry).sum());
      entry += 4;
    } else {
      positions[entry++] += change[joint.index];
    }
  }
  std::vector<reference::MatrixX<double>> outputs = {positions, qd};
  if (robot.floating_base) {
    outputs.emplace_back(reference::Vector3<double>::Constant(change.head<3>().sum()));
    outputs.emplace_back(Quaternion<double>::Constant(turn(3)));
  }
  return one_after_the_other<double>(outputs);
}

Vector position_magnitude(const ReferencePoint<double>& from) {
  Vector result = Vector::Zero(from.qd.size());
  result.tail(from.q.size()) = from.q.cwiseAbs();
  for (const Eigen::Index k : turning_entries(from.robot)) result.segment<3>(k).setOnes();
  return result;
}

}  // namespace flatdyn::references
