// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/label_layout.hpp"

#include <algorithm>
#include <numeric>

namespace flatdyn {
namespace {

constexpr double kLetter = 6.4, kHeight = 14, kClearance = 9, kGap = 6;

// The flags of one half: rows above all of its points.
class FlagRows {
 public:
  // `edge`: the y above which the first row begins, in pixels.
  explicit FlagRows(double edge) : edge_(edge) {}

  // Places a flag; call it from right to left. A flag that reaches over poles to its right must be in a row above their
  // flags.
  Box place(const LabelledPoint& point) {
    const double right = point.x + label_width(point.text) + kGap;
    std::size_t row = 0;
    for (std::size_t k = 0; k < starts_.size(); ++k) {
      if (starts_[k] < right) row = k + 1;
    }
    if (row == starts_.size()) starts_.push_back(point.x);
    starts_[row] = point.x;
    const double middle = edge_ - (kClearance + (static_cast<double>(row) + 0.5) * kHeight);
    return {point.x, middle - kHeight / 2, point.x + label_width(point.text), middle + kHeight / 2};
  }

 private:
  double edge_;
  std::vector<double> starts_;  // left edge of each row's last flag
};

}  // namespace

double label_width(const std::string& text) { return kLetter * static_cast<double>(text.size()) + 4; }

std::vector<Box> placed_labels(const std::vector<LabelledPoint>& points, const Box& frame) {
  const double half = (frame.top + frame.bottom) / 2;
  const auto is_upper = [half](const LabelledPoint& point) { return point.y < half; };
  double top_of_upper = half, top_of_lower = frame.bottom;
  for (const LabelledPoint& point : points) {
    double& edge = is_upper(point) ? top_of_upper : top_of_lower;
    edge = std::min(edge, point.y);
  }
  FlagRows upper(top_of_upper), lower(top_of_lower);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a].x > points[b].x; });
  std::vector<Box> placed(points.size());
  for (const std::size_t k : order) placed[k] = (is_upper(points[k]) ? upper : lower).place(points[k]);
  return placed;
}

}  // namespace flatdyn
