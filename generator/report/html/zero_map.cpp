// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/zero_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/page.hpp"

namespace flatdyn {
namespace {

// The side of a square in pixels: large for small matrices, small for wide ones.
int side_of_square(const Output& output) {
  constexpr int kWidest = 420, kLargest = 22, kSmallest = 3;
  return std::clamp(kWidest / std::max(output.rows, output.cols), kSmallest, kLargest);
}

}  // namespace

int nonzero_entries(const Function& function, const Output& output) {
  return static_cast<int>(std::count_if(output.entries.begin(), output.entries.end(),
                                        [&function](NodeId entry) { return !function.graph.is_zero(entry); }));
}

std::string zero_map(const Function& function, const Output& output, const std::string& label) {
  std::string squares;
  for (std::size_t e = 0; e < output.entries.size(); ++e) {
    if (function.graph.is_zero(output.entries[e])) continue;
    const auto cols = static_cast<std::size_t>(output.cols);
    squares += fmt::format("M{} {}h.9v.9h-.9z", e % cols, e / cols);
  }
  const int side = side_of_square(output);
  return fmt::format(
      "<svg role=\"img\" aria-label=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">"
      "<rect class=\"frame\" width=\"{}\" height=\"{}\"/><path d=\"{}\"/></svg>",
      html_text(label), side * output.cols, side * output.rows, output.cols, output.rows, output.cols, output.rows,
      squares);
}

}  // namespace flatdyn
