// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/label_layout.hpp"

#include <algorithm>
#include <numeric>

namespace flatdyn {
namespace {

constexpr double kLetter = 6.4, kHeight = 14, kClearance = 9, kGap = 6;

// Flags of one half: rows above (or below) all of its points.
class FlagRows {
 public:
  // `direction`: -1 up, 1 down; `edge`: of the points, where the first row begins.
  FlagRows(double direction, double edge) : direction_(direction), edge_(edge) {}

  // From right to left: a flag goes over the poles to its right, so it has to be in a row behind their flags.
  Box place(const LabelledPoint& point) {
    const double right = point.x + label_width(point.text) + kGap;
    std::size_t row = 0;
    for (std::size_t k = 0; k < starts_.size(); ++k) {
      if (starts_[k] < right) row = k + 1;
    }
    if (row == starts_.size()) starts_.push_back(point.x);
    starts_[row] = point.x;
    const double middle = edge_ + direction_ * (kClearance + (static_cast<double>(row) + 0.5) * kHeight);
    return {point.x, middle - kHeight / 2, point.x + label_width(point.text), middle + kHeight / 2};
  }

 private:
  double direction_, edge_;
  std::vector<double> starts_;  // of each row's last flag
};

}  // namespace

double label_width(const std::string& text) { return kLetter * static_cast<double>(text.size()) + 4; }

std::vector<Box> placed_labels(const std::vector<LabelledPoint>& points, const Box& frame) {
  const double half = (frame.top + frame.bottom) / 2;
  double highest = frame.bottom, lowest = frame.top;
  for (const LabelledPoint& point : points) {
    (point.y < half ? lowest : highest) = point.y < half ? std::max(lowest, point.y) : std::min(highest, point.y);
  }
  FlagRows up(-1, highest), down(1, lowest);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a].x > points[b].x; });
  std::vector<Box> placed(points.size());
  for (const std::size_t k : order) placed[k] = (points[k].y < half ? down : up).place(points[k]);
  return placed;
}

}  // namespace flatdyn
