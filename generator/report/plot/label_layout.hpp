// SPDX-License-Identifier: GPL-2.0-or-later
// Layout of the names of points, so that none covers another: like flags on poles, to the right of their poles.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// A rectangle in pixels, y downwards.
struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;

  bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

struct LabelledPoint {
  double x = 0, y = 0;
  std::string text;
};

// The approximate width of a text in pixels, at the pictures' font size.
double label_width(const std::string& text);

// The flag of each point; its pole goes up from the point to the flag's left edge. Flags of points in the lower half of
// `frame` stand above all points of that half, the others above all points. A flag may extend beyond the frame to the
// right and upwards.
std::vector<Box> placed_labels(const std::vector<LabelledPoint>& points, const Box& frame);

}  // namespace flatdyn
