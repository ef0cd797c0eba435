// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/closed_positions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "flatdyn/reference/closed_loops.hpp"
#include "robot/model/assembly.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

// The largest step of an independent joint, rad or m, with which Newton's method stays with the assembly.
constexpr double kFarthestStep = 0.05;
constexpr int kMostHalvings = 10;
// The tolerance of the loops' closure, some roundings: as a share of the links' summed lengths, and of axes that meet.
constexpr double kClosed = 1e-14;

constexpr const char* kAway = "let the motion stay away from there, or choose other dependent joints";

double reach(const reference::Robot<double>& robot) {
  double length = 0;
  for (const auto& joint : robot.joints) length += joint.p_0.norm();
  for (const auto& loop : robot.loops) {
    length += loop.points[0].norm() + loop.points[1].norm() + (reference::detail::aligns_axes(loop) ? 1 : 0);
  }
  return length;
}

}  // namespace

ClosedPositions::ClosedPositions(const LoadedRobot& model) : independent_(model.mechanism.independent) {
  if (!model.mechanism.has_loops()) return;
  joints_ = model.mechanism.joint_names();
  require_numbers(model.robot, "closing loops");
  robot_.emplace(reference_robot<double>(model.robot, {}));
  tolerance_ = kClosed * reach(*robot_);
  const std::vector<double> start = assembled_positions(model.robot, model.mechanism);
  q_ = Eigen::Map<const Eigen::VectorXd>(start.data(), static_cast<Eigen::Index>(start.size()));
  if (reference::close_loops(*robot_, q_, tolerance_) &&
      reference::loop_regularity(*robot_, q_) > reference::kSingularLoop) {
    return;
  }
  throw Failure(FailureKind::input,
                fmt::format("{}: the loops cannot be closed near q = {}, or are singular there", model.robot.file,
                            fmt::join(start, ", ")),
                "say in the robot file near which positions they are closed: [assembly], JOINT = position");
}

bool ClosedPositions::close(const Eigen::VectorXd& q_a) {
  Eigen::VectorXd next = q_;
  next(independent_) = q_a;
  if (!reference::close_loops(*robot_, next, tolerance_)) return false;
  q_ = next;
  return true;
}

std::span<const double> ClosedPositions::of(std::span<const double> q_a) {
  if (!robot_) return q_a;
  const Eigen::VectorXd goal = Eigen::Map<const Eigen::VectorXd>(q_a.data(), static_cast<Eigen::Index>(q_a.size()));
  Eigen::VectorXd here = q_(independent_);
  double largest = kFarthestStep;
  for (int halvings = 0; here != goal;) {
    const double distance = (goal - here).cwiseAbs().maxCoeff();
    const Eigen::VectorXd next =
        distance <= largest ? goal : Eigen::VectorXd(here + largest / distance * (goal - here));
    if (close(next)) {
      here = next;
    } else if (++halvings <= kMostHalvings && std::isfinite(distance)) {
      largest = std::min(largest, distance) / 2;
    } else {
      throw Failure(FailureKind::input, "the loops cannot be closed beyond " + place_text(here), kAway);
    }
  }
  return {q_.data(), static_cast<std::size_t>(q_.size())};
}

std::span<const double> ClosedPositions::at(const TrajectoryPoint& point) {
  time_ = point.time;
  return of(point.q);
}

void ClosedPositions::refuse_singular() const {
  throw Failure(FailureKind::input, "the loops are singular at " + place_text(q_(independent_)), kAway);
}

std::string ClosedPositions::place_text(const Eigen::VectorXd& q_a) const {
  std::vector<std::string> places;
  if (time_) places.push_back(fmt::format("t = {:.6g} s", *time_));
  for (std::size_t i = 0; i < joints_.size(); ++i)
    places.push_back(fmt::format("{} = {:.6g}", joints_[i], q_a[static_cast<Eigen::Index>(i)]));
  return fmt::format("{}", fmt::join(places, ", "));
}

std::vector<std::vector<double>> positions_along(const LoadedRobot& model, const Trajectory& trajectory) {
  ClosedPositions positions(model);
  std::vector<std::vector<double>> all;
  for (const TrajectoryPoint& point : trajectory.points) {
    const std::span<const double> q = positions.at(point);
    all.emplace_back(q.begin(), q.end());
  }
  return all;
}

}  // namespace flatdyn
