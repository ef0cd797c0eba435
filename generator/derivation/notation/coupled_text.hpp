// SPDX-License-Identifier: GPL-2.0-or-later
// The positions of coupled joints as text.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The name of an entry of q.
using CoordinateName = std::function<std::string(int)>;

// A line like "right_finger = q[0] + 0.01" for every joint whose position is not an entry of q, rad or m.
std::vector<std::string> coupled_joint_texts(const Mechanism& mechanism, const CoordinateName& coordinate);

// A line like "split = 0.5 q[0] + 0.5 q[1]" for the length of every tendon, in the mechanism's order.
std::vector<std::string> tendon_texts(const Mechanism& mechanism, const CoordinateName& coordinate);

// The number of joints: "7 joints", "3 joints, 1 of them independent".
std::string joints_text(const Mechanism& mechanism);

// The names of a closed loop's dependent joints.
std::vector<std::string> dependent_joint_names(const Mechanism& mechanism, const LoopClosure& loop);

}  // namespace flatdyn
