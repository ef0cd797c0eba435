// SPDX-License-Identifier: GPL-2.0-or-later
// Tendons whose length is a sum of joint positions, L = Σ c_j q_j: with their spring, friction and armature they act on
// several joints at once, by τ_j = c_j f with f = k (L - L_0) + F_v L̇ + F_s sign(L̇) + a L̈.
//
// A tendon is a joint of the robot, a slide on the base that follows the joints it runs over and moves a link without
// mass. All that holds for coupled joints holds for it; it has no inertial parameters.
#pragma once

#include "robot/model/robot.hpp"

namespace flatdyn {

// Adds the joint that is the tendon's length, with its name, `coupled` and forces, and its link. The tree of the other
// links must have one root.
void add_tendon(Joint tendon, Robot& robot);

// Whether the link is that of a tendon, which is nowhere: it is no part of the robot.
bool is_of_tendon(const Robot& robot, int link);

// Leaves out tendons that stand still, and those without a force.
void leave_out_idle_tendons(Robot& robot);

}  // namespace flatdyn
