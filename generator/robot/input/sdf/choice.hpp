// SPDX-License-Identifier: GPL-2.0-or-later
// The model of an SDF file that the robot is made of.
#pragma once

#include "robot/input/sdf/declare.hpp"

namespace flatdyn {

struct SdfChoice {
  SdfModel model;
  const FileNode* world = nullptr;  // nullptr: the model stands directly in <sdf>
};

// The one that --model names, else the only one that is not static; nullopt and an error if that is not clear.
std::optional<SdfChoice> choose_sdf_model(const SdfFile& file, SdfTree& tree, Robot& robot);

}  // namespace flatdyn
