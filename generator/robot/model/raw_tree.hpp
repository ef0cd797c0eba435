// SPDX-License-Identifier: GPL-2.0-or-later
// The bodies of a robot with raw frames: z is on each joint's axis, origin and phase are wherever the file put them.
// Links that fixed joints join are one body.
#pragma once

#include <string>
#include <vector>

#include "robot/model/coordinate_limits.hpp"
#include "robot/model/exact_transform.hpp"

namespace flatdyn {

struct RawTree {
  explicit RawTree(const Robot& robot);

  const Robot& robot;                     // must outlive this object
  Number reach;                           // the sum of its numeric lengths, m; rounding residues are far smaller
  std::vector<LinearPosition> positions;  // by written joint
  std::vector<Transform> link_pose;       // by written link: its pose in its body's raw frame
  std::vector<int> body_of;               // by written link: its body; -1: the base
  std::vector<Transform> frames;          // by body: its raw frame in its parent's raw frame
  std::vector<int> joint_of;              // by body: the joint as written that moves it
  std::vector<int> parent;                // by body; -1: the base
  std::vector<std::string> merged;        // names of links that fixed joints have merged into another
};

}  // namespace flatdyn
