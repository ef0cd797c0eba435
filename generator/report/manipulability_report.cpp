// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/manipulability_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnostics/table.hpp"
#include "report/plot.hpp"
#include "symbolic/task_rows.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kPosesShown = 20;
constexpr int kOutlinePoints = 120;
constexpr double kDrawnPart = 0.35;  // of the arm's length, for the largest half axis

const char* direction(int row) {
  static constexpr const char* kNames[] = {"x", "y", "z", "rx", "ry", "rz"};
  return kNames[row];
}

// In the plane of the drawing: the centre, and the half axes of the ellipsoid's shadow by column.
struct Shadow {
  Eigen::Vector2d centre;
  Eigen::Matrix2d axes;
};

Shadow shadow(const std::vector<int>& task, const Ellipsoid& ellipsoid, const DrawingPlane& plane) {
  Eigen::MatrixXd onto = Eigen::MatrixXd::Zero(2, ellipsoid.centre.size());
  for (std::size_t i = 0; i < task.size(); ++i) {
    onto(0, static_cast<Eigen::Index>(i)) = task[i] == plane.across;
    onto(1, static_cast<Eigen::Index>(i)) = task[i] == plane.up;
  }
  const Eigen::MatrixXd half = onto * ellipsoid.axes * ellipsoid.lengths.asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(half, Eigen::ComputeThinU);
  Eigen::Matrix2d axes = Eigen::Matrix2d::Zero();
  for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k)
    axes.col(k) = svd.matrixU().col(k) * svd.singularValues()(k);
  return {onto * ellipsoid.centre, axes};
}

double length_of(const std::vector<Eigen::Vector3d>& skeleton) {
  double length = 0;
  for (std::size_t k = 1; k < skeleton.size(); ++k) length += (skeleton[k] - skeleton[k - 1]).norm();
  return length;
}

Series arm_line(const ManipulablePose& pose, const DrawingPlane& plane) {
  Series line{"", {}, {}, true};
  for (const Eigen::Vector3d& point : pose.skeleton) {
    line.x.push_back(point(plane.across));
    line.y.push_back(point(plane.up));
  }
  return line;
}

std::string name_of(const ManipulablePose& pose) {
  std::vector<std::string> numbers;
  for (const double q : pose.q) numbers.push_back(fmt::format("{:.3g}", q));
  return fmt::format("q = {}", fmt::join(numbers, ", "));
}

Series outline(const ManipulablePose& pose, const Shadow& shadow, double scale, const DrawingPlane& plane) {
  Series curve{name_of(pose), {}, {}};
  const Eigen::Vector3d& tip = pose.skeleton.back();
  for (int k = 0; k <= kOutlinePoints; ++k) {
    const double angle = 2 * std::numbers::pi * k / kOutlinePoints;
    const Eigen::Vector2d point =
        scale * (shadow.centre + shadow.axes * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    curve.x.push_back(tip(plane.across) + point(0));
    curve.y.push_back(tip(plane.up) + point(1));
  }
  return curve;
}

}  // namespace

std::string manipulability_csv(const std::vector<int>& task, const std::vector<ManipulablePose>& poses) {
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < poses.front().q.size(); ++i) columns.push_back(fmt::format("q{}", i + 1));
  for (const int row : task) columns.push_back(fmt::format("centre_{}", direction(row)));
  for (std::size_t k = 1; k <= task.size(); ++k) columns.push_back(fmt::format("length_{}", k));
  for (std::size_t k = 1; k <= task.size(); ++k) {
    for (const int row : task) columns.push_back(fmt::format("axis_{}_{}", k, direction(row)));
  }
  std::string text = fmt::format("{},measure\n", fmt::join(columns, ","));
  for (const ManipulablePose& pose : poses) {
    std::vector<double> numbers = pose.q;
    for (const double value : pose.ellipsoid.centre) numbers.push_back(value + 0.0);
    for (const double value : pose.ellipsoid.lengths) numbers.push_back(value);
    for (const double value : pose.ellipsoid.axes.reshaped()) numbers.push_back(value + 0.0);
    text += fmt::format("{},{}\n", fmt::join(numbers, ","), pose.ellipsoid.measure);
  }
  return text;
}

std::string manipulability_plot(const std::string& robot, const std::vector<int>& task,
                                const std::vector<ManipulablePose>& poses, const DrawingPlane& plane,
                                PictureFormat format) {
  std::vector<Shadow> shadows;
  double largest = 0, reach = 0;
  for (const ManipulablePose& pose : poses) {
    shadows.push_back(shadow(task, pose.ellipsoid, plane));
    largest = std::max({largest, shadows.back().axes.colwise().norm().maxCoeff(), shadows.back().centre.norm() / 2});
    reach = std::max(reach, length_of(pose.skeleton));
  }
  const double scale = largest > 0 && reach > 0 ? kDrawnPart * reach / largest : 1;
  Panel panel{fmt::format("accelerations at the tip: 1 m is {:.3g} m/s^2", 1 / scale),
              fmt::format("{} in m", direction(plane.across)),
              fmt::format("{} in m", direction(plane.up)),
              {},
              PanelStyle::plane};
  for (std::size_t k = 0; k < poses.size(); ++k) panel.series.push_back(outline(poses[k], shadows[k], scale, plane));
  for (const ManipulablePose& pose : poses) panel.series.push_back(arm_line(pose, plane));
  return plot(robot + ": dynamic manipulability", {panel}, format);
}

std::string describe_manipulability(const std::vector<int>& task, const std::vector<ManipulablePose>& poses) {
  std::vector<std::vector<std::string>> rows = {{"pose", "measure", "half axes", "centre " + task_text(task)}};
  const auto numbers = [](const Eigen::VectorXd& values) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(fmt::format("{:.4g}", value + 0.0));
    return fmt::format("{}", fmt::join(texts, ", "));
  };
  for (std::size_t k = 0; k < std::min(poses.size(), kPosesShown); ++k) {
    const Ellipsoid& ellipsoid = poses[k].ellipsoid;
    rows.push_back({std::to_string(k + 1), fmt::format("{:.6g}", ellipsoid.measure), numbers(ellipsoid.lengths),
                    numbers(ellipsoid.centre)});
  }
  std::string text = aligned_table(rows);
  if (poses.size() > kPosesShown) text += fmt::format("... and {} more\n", poses.size() - kPosesShown);
  return text;
}

nlohmann::ordered_json manipulability_json(const std::string& robot, const std::vector<int>& task,
                                           const std::vector<ManipulablePose>& poses) {
  nlohmann::ordered_json json = {{"robot", robot}, {"task", nlohmann::ordered_json::array()}};
  for (const int row : task) json["task"].push_back(direction(row));
  const auto list = [](const auto& values) { return std::vector<double>(values.begin(), values.end()); };
  for (const ManipulablePose& pose : poses) {
    nlohmann::ordered_json axes;
    for (const auto& axis : pose.ellipsoid.axes.colwise()) axes.push_back(list(axis));
    json["poses"].push_back({{"q", pose.q},
                             {"centre", list(pose.ellipsoid.centre)},
                             {"lengths", list(pose.ellipsoid.lengths)},
                             {"axes", axes},
                             {"measure", pose.ellipsoid.measure}});
  }
  return json;
}

}  // namespace flatdyn
