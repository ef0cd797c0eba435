// SPDX-License-Identifier: GPL-2.0-or-later
// From where a picture shows the robot: parallel projections of the base frame.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace flatdyn {

struct View {
  std::string name;
  bool is_oblique = false;           // sees all three axes
  std::string across, up;            // labels of the picture's axes; empty where these are none of the base frame's
  Eigen::Matrix<double, 2, 3> onto;  // p in the base frame, m, to the picture's place
};

// "xy" from above, "xz" and "yz" from the sides, and "space", which sees all three axes.
View view_of(const std::string& name);

// Those of a technical drawing: from the front, the side, above, and in space.
std::vector<View> all_views();

}  // namespace flatdyn
