// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/regressor_map.hpp"

#include <fmt/format.h>

#include "emit/page.hpp"
#include "symbolic/parameters/parameters.hpp"

namespace flatdyn {
namespace {

// Sizes in pixels: an entry's pitch across and down, the gap between joints, and the margins left of and below the map.
constexpr int kSide = 9, kHeight = 12, kGap = 6, kLeft = 22, kBelow = 18;
constexpr int kGroup = kSide * kParametersPerJoint;

int left_of(int joint) { return kLeft + joint * (kGroup + kGap); }

std::string filled_entries(const Function& function, const Output& Y) {
  std::string path;
  for (int row = 0; row < Y.rows; ++row) {
    for (int col = 0; col < Y.cols; ++col) {
      if (function.graph.is_zero(Y.entries[static_cast<std::size_t>(row * Y.cols + col)])) continue;
      const int x = left_of(joint_of(col)) + kSide * (col % kParametersPerJoint);
      path += fmt::format("M{0} {1}h{2}v{3}h-{2}z", x, kHeight * row, kSide - 1, kHeight - 1);
    }
  }
  return path;
}

}  // namespace

std::string regressor_map(const Function& function, const Output& Y, const std::string& label) {
  const int groups = Y.cols / kParametersPerJoint, height = kHeight * Y.rows, width = left_of(groups) - kGap;
  std::string text =
      fmt::format("<svg role=\"img\" aria-label=\"{0}\" width=\"{1}\" height=\"{2}\" viewBox=\"0 0 {1} {2}\">",
                  html_text(label), width, height + kBelow);
  for (int joint = 0; joint < groups; ++joint) {
    text += fmt::format("<rect class=\"frame\" x=\"{}\" width=\"{}\" height=\"{}\"/>", left_of(joint), kGroup - 1,
                        height - 1);
    text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>", left_of(joint) + kGroup / 2,
                        height + kBelow - 5, joint + 1);
  }
  for (int row = 0; row < Y.rows; ++row) {
    text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", kLeft - 5, kHeight * (row + 1) - 3,
                        row + 1);
  }
  return text + fmt::format("<path d=\"{}\"/></svg>", filled_entries(function, Y));
}

}  // namespace flatdyn
