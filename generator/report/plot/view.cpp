// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/view.hpp"

#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

// A view from in front of the robot, from its right, and from above.
constexpr double kAzimuth = -50 * std::numbers::pi / 180, kElevation = 25 * std::numbers::pi / 180;

View of_axes(const std::string& name) {
  View view{name, false, name.substr(0, 1), name.substr(1), Eigen::Matrix<double, 2, 3>::Zero()};
  view.onto(0, name[0] - 'x') = 1;
  view.onto(1, name[1] - 'x') = 1;
  return view;
}

View in_space() {
  View view{"space", true, "", "", {}};
  view.onto << -std::sin(kAzimuth), std::cos(kAzimuth), 0,  //
      -std::cos(kAzimuth) * std::sin(kElevation), -std::sin(kAzimuth) * std::sin(kElevation), std::cos(kElevation);
  return view;
}

}  // namespace

View view_of(const std::string& name) { return name == "space" ? in_space() : of_axes(name); }

std::vector<View> all_views() { return {of_axes("xz"), of_axes("yz"), of_axes("xy"), in_space()}; }

}  // namespace flatdyn
