// SPDX-License-Identifier: GPL-2.0-or-later
// The settings of <compiler> and <option>, which concern the whole model.
#pragma once

#include "robot/input/mjcf/values.hpp"

namespace flatdyn {

enum class InertiaFromGeom { never, always, where_missing };

struct MjcfSettings {
  Units angles{.degrees = true};
  std::string euler_sequence = "xyz";  // small letters: about axes that turn along; capital ones: about the parent's
  bool automatic_limits = true;        // a range says that it limits
  bool aligns_free_bodies = false;     // the frames of free bodies that carry no others are those of their inertia
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::where_missing;
  std::array<double, 2> inertia_groups = {0, 5};  // groups of geoms that count for inertia
  std::optional<Value> least_mass, least_inertia;
  std::optional<Value> total_mass;  // masses and inertias are scaled to it
  bool balances_inertia = false;
  bool has_exact_mesh_inertia = false;  // of older files
  std::string mesh_folder;              // relative to the file's folder
  bool strips_path = false;             // files of meshes are named with folders that do not count
};

// Reads them, and gravity into the robot. Forces of a medium are refused.
MjcfSettings mjcf_settings(const FileNode& root, const MjcfValues& values, Robot& robot);

// Refuses flags that turn off what the robot has, once it is read.
void refuse_mjcf_flags(const FileNode& root, const MjcfValues& values, const Robot& robot);

// The attribute of <compiler> in which two models differ; "" if there is none. Folders may differ.
std::string mjcf_difference(const MjcfSettings& a, const MjcfSettings& b);

}  // namespace flatdyn
