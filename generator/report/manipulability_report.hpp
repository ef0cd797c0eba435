// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "laboratory/manipulability/ellipsoid.hpp"

namespace flatdyn {

// An arm at rest at q, with its ellipsoid.
struct ManipulablePose {
  std::vector<double> q;
  Ellipsoid ellipsoid;
  std::vector<Eigen::Vector3d> skeleton;  // m, the tip last
  std::optional<double> t = {};           // s, on a path; all poses have it, or none
  std::optional<Eigen::Vector3d> g_b{};   // gravity in the axes of a floating base, m/s²; else none
};

// CSV with columns t,q1,…,p_x,p_y,p_z,centre_x,…,length_1,…,axis_1_x,…,measure, in SI units. With a floating base
// base_gx,base_gy,base_gz follow q.
std::string manipulability_csv(const std::vector<int>& task, const std::vector<ManipulablePose>& poses);

std::string describe_manipulability(const std::vector<int>& task, const std::vector<ManipulablePose>& poses);
// norm: as --norm names it.
nlohmann::ordered_json manipulability_json(const std::string& robot, const std::string& norm,
                                           const std::vector<int>& task, const std::vector<ManipulablePose>& poses);

}  // namespace flatdyn
