// SPDX-License-Identifier: GPL-2.0-or-later
// The views in which pictures show the robot: parallel projections of the base frame.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace flatdyn {

struct View {
  std::string name;
  bool is_oblique = false;           // shows all three axes
  std::string across, up;            // labels of the picture's axes; empty if they are not axes of the base frame
  Eigen::Matrix<double, 2, 3> onto;  // from p in the base frame, m, to the place in the picture
};

// The view "xy" from above, "xz" or "yz" from the sides, or "space", which shows all three axes.
View view_of(const std::string& name);

// The views of a technical drawing: from the front, from the side, from above, and in space.
std::vector<View> all_views();

}  // namespace flatdyn
