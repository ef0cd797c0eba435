// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/manipulability_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/diagnostics/table.hpp"
#include "derivation/dynamics/task_rows.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kPosesShown = 20;

const char* direction(int row) {
  static constexpr const char* kNames[] = {"x", "y", "z", "rx", "ry", "rz"};
  return kNames[row];
}

// The places of the smallest and the largest measure.
std::string measure_range(const std::vector<ManipulablePose>& poses) {
  const auto [least, most] = std::minmax_element(poses.begin(), poses.end(), [](const auto& a, const auto& b) {
    return a.ellipsoid.measure < b.ellipsoid.measure;
  });
  const auto place = [&](const auto& pose) {
    const Eigen::Vector3d& p = pose->skeleton.back();
    return fmt::format("{:.6g} at pose {}, the tip at ({:.4g}, {:.4g}, {:.4g}) m", pose->ellipsoid.measure,
                       pose - poses.begin() + 1, p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
  };
  return fmt::format("the measure is from {}\n                to {}\n", place(least), place(most));
}

}  // namespace

std::string manipulability_csv(const std::vector<int>& task, const std::vector<ManipulablePose>& poses) {
  std::vector<std::string> columns;
  if (poses.front().t) columns.emplace_back("t");
  for (std::size_t i = 0; i < poses.front().q.size(); ++i) columns.push_back(fmt::format("q{}", i + 1));
  for (const char* axis : {"x", "y", "z"}) {
    if (poses.front().g_b) columns.push_back(fmt::format("base_g{}", axis));
  }
  for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("p_{}", axis));
  for (const int row : task) columns.push_back(fmt::format("centre_{}", direction(row)));
  const auto axes = poses.front().ellipsoid.lengths.size();
  for (Eigen::Index k = 1; k <= axes; ++k) columns.push_back(fmt::format("length_{}", k));
  for (Eigen::Index k = 1; k <= axes; ++k) {
    for (const int row : task) columns.push_back(fmt::format("axis_{}_{}", k, direction(row)));
  }
  std::string text = fmt::format("{},measure\n", fmt::join(columns, ","));
  for (const ManipulablePose& pose : poses) {
    std::vector<double> numbers;
    if (pose.t) numbers.push_back(*pose.t);
    numbers.insert(numbers.end(), pose.q.begin(), pose.q.end());
    if (pose.g_b) numbers.insert(numbers.end(), pose.g_b->begin(), pose.g_b->end());
    for (const double value : pose.skeleton.back()) numbers.push_back(value + 0.0);
    for (const double value : pose.ellipsoid.centre) numbers.push_back(value + 0.0);
    for (const double value : pose.ellipsoid.lengths) numbers.push_back(value);
    for (const double value : pose.ellipsoid.axes.reshaped()) numbers.push_back(value + 0.0);
    text += fmt::format("{},{}\n", fmt::join(numbers, ","), pose.ellipsoid.measure);
  }
  return text;
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
  if (poses.size() > kPosesShown)
    text += fmt::format("... and {} more\n", poses.size() - kPosesShown) + measure_range(poses);
  return text;
}

nlohmann::ordered_json manipulability_json(const std::string& robot, const std::string& norm,
                                           const std::vector<int>& task, const std::vector<ManipulablePose>& poses) {
  nlohmann::ordered_json json = {{"robot", robot}, {"norm", norm}, {"task", nlohmann::ordered_json::array()}};
  for (const int row : task) json["task"].push_back(direction(row));
  const auto list = [](const auto& values) { return std::vector<double>(values.begin(), values.end()); };
  for (const ManipulablePose& pose : poses) {
    nlohmann::ordered_json axes;
    for (const auto& axis : pose.ellipsoid.axes.colwise()) axes.push_back(list(axis));
    json["poses"].push_back({{"q", pose.q},
                             {"p", list(pose.skeleton.back())},
                             {"centre", list(pose.ellipsoid.centre)},
                             {"lengths", list(pose.ellipsoid.lengths)},
                             {"axes", axes},
                             {"measure", pose.ellipsoid.measure}});
    if (pose.g_b) json["poses"].back()["g_b"] = list(*pose.g_b);
  }
  return json;
}

}  // namespace flatdyn
