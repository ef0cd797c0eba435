// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/regressor_map.hpp"

#include <fmt/format.h>

#include "code/emit/page.hpp"
#include "derivation/parameters/parameters.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// Sizes in pixels: an entry's pitch across and down, the gap between joints, and the margins left of and below the map.
constexpr int kSide = 9, kHeight = 12, kGap = 6, kLeft = 22, kBelow = 18;

// The columns of the map: those of a floating base's link, if there is one, then thirteen per joint.
struct Groups {
  int of_base = 0;  // 10 or 0
  int joints = 0;

  int count() const { return joints + (of_base > 0 ? 1 : 0); }
  int columns(int group) const { return group == 0 && of_base > 0 ? of_base : kParametersPerJoint; }
  int first(int group) const {
    return of_base > 0 && group > 0 ? of_base + joint_columns(group - 1) : joint_columns(group);
  }
  int left(int group) const { return kLeft + kSide * first(group) + kGap * group; }
  int width(int group) const { return kSide * columns(group); }
  int group_of(int column) const {
    if (of_base == 0) return column / kParametersPerJoint;
    return column < of_base ? 0 : 1 + (column - of_base) / kParametersPerJoint;
  }
  int left_of_column(int column) const {
    const int group = group_of(column);
    return left(group) + kSide * (column - first(group));
  }

 private:
  static int joint_columns(int joints) { return kParametersPerJoint * joints; }
};

Groups groups_of(const Output& Y, bool floating) {
  const int of_base = floating ? kInertialPerBody : 0;
  return {of_base, (Y.cols - of_base) / kParametersPerJoint};
}

std::string filled_entries(const Function& function, const Output& Y, const Groups& groups) {
  std::string path;
  for (int row = 0; row < Y.rows; ++row) {
    for (int col = 0; col < Y.cols; ++col) {
      if (function.graph.is_zero(Y.entries[static_cast<std::size_t>(row * Y.cols + col)])) continue;
      path += fmt::format("M{0} {1}h{2}v{3}h-{2}z", groups.left_of_column(col), kHeight * row, kSide - 1, kHeight - 1);
    }
  }
  return path;
}

// The base's forces by their names, joints by their numbers from 1.
std::string row_name(int row, int base_bodies) {
  static const char* const kForces[] = {"fx", "fy", "fz", "nx", "ny", "nz"};
  return row < base_bodies ? kForces[row] : std::to_string(row - base_bodies + 1);
}

// The numbers of the rows of each joint from 1: "3–5" of a spherical one.
std::vector<std::string> joint_names(int joints, const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (int row = 1; static_cast<int>(names.size()) < joints; ++row) {
    const bool turns_freely =
        mechanism.has_spherical_joints() && mechanism.is_of_spherical(mechanism.base_bodies() + row - 1);
    names.push_back(turns_freely ? fmt::format("{}–{}", row, row + kSphericalBodies - 1) : std::to_string(row));
    if (turns_freely) row += kSphericalBodies - 1;
  }
  return names;
}

}  // namespace

std::string regressor_map(const Function& function, const Output& Y, const Mechanism& mechanism,
                          const std::string& label) {
  const int base_bodies = mechanism.base_bodies();
  const Groups groups = groups_of(Y, base_bodies > 0);
  std::vector<std::string> names = joint_names(groups.joints, mechanism);
  if (groups.of_base > 0) names.insert(names.begin(), "0");
  const int height = kHeight * Y.rows, width = groups.left(groups.count()) - kGap;
  std::string text =
      fmt::format("<svg role=\"img\" aria-label=\"{0}\" width=\"{1}\" height=\"{2}\" viewBox=\"0 0 {1} {2}\">",
                  html_text(label), width, height + kBelow);
  for (int group = 0; group < groups.count(); ++group) {
    text += fmt::format("<rect class=\"frame\" x=\"{}\" width=\"{}\" height=\"{}\"/>", groups.left(group),
                        groups.width(group) - 1, height - 1);
    text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                        groups.left(group) + groups.width(group) / 2, height + kBelow - 5,
                        names[static_cast<std::size_t>(group)]);
  }
  for (int row = 0; row < Y.rows; ++row) {
    text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", kLeft - 5, kHeight * (row + 1) - 3,
                        row_name(row, base_bodies));
  }
  return text + fmt::format("<path d=\"{}\"/></svg>", filled_entries(function, Y, groups));
}

}  // namespace flatdyn
