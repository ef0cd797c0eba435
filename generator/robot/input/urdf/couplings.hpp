// SPDX-License-Identifier: GPL-2.0-or-later
// URDF+ (Chignoli, Slotine, Wensing, Kim, arXiv 2411.19753): gears and belts between joints.
#pragma once

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// The attribute `independent` of joints, Joint::independent.
void read_urdf_marks(const FileNode& root, const UrdfValues& values, Robot& robot);

// <coupling> with <predecessor>, <successor> and <ratio>, 1 if it is left out: of the joints from the nearest common
// ancestor to each of the two links,
//     Σ positions towards the successor = ratio · Σ positions towards the predecessor.
// <joint_constraint> with <parent>, <child>, <gear_ratio> is what it was called before. All of them together are solved
// for as many joints, which become coupled joints: those that are marked as not independent, else the last ones towards
// the successor, which is noted. After read_urdf_marks() and read_urdf_mimics().
void read_urdf_couplings(const FileNode& root, const UrdfValues& values, Robot& robot);

}  // namespace flatdyn
