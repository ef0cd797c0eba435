// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "manipulability/ellipsoid.hpp"
#include "report/plot.hpp"

namespace flatdyn {

// An arm at rest at q, with its ellipsoid.
struct ManipulablePose {
  std::vector<double> q;
  Ellipsoid ellipsoid;
  std::vector<Eigen::Vector3d> skeleton;
};

// Two of the base frame's axes: 0 for x, 1 for y, 2 for z.
struct DrawingPlane {
  int across = 0, up = 1;
};

// q1,…,centre_x,…,length_1,…,axis_1_x,…,measure: SI units.
std::string manipulability_csv(const std::vector<int>& task, const std::vector<ManipulablePose>& poses);
// The arm from the side, with the ellipsoids' outlines at its tip, of the accelerations along x, y, z.
std::string manipulability_plot(const std::string& robot, const std::vector<int>& task,
                                const std::vector<ManipulablePose>& poses, const DrawingPlane& plane,
                                PictureFormat format);

std::string describe_manipulability(const std::vector<int>& task, const std::vector<ManipulablePose>& poses);
nlohmann::ordered_json manipulability_json(const std::string& robot, const std::vector<int>& task,
                                           const std::vector<ManipulablePose>& poses);

}  // namespace flatdyn
