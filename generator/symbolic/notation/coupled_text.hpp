// SPDX-License-Identifier: GPL-2.0-or-later
// Where coupled joints are, for people.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/mechanism.hpp"

namespace flatdyn {

// What an entry of q is called.
using CoordinateName = std::function<std::string(int)>;

// "right_finger = q[0] + 0.01" of every joint whose position is no entry of q, rad or m.
std::vector<std::string> coupled_joint_texts(const Mechanism& mechanism, const CoordinateName& coordinate);

// "7 joints", "3 joints, 1 of them independent".
std::string joints_text(const Mechanism& mechanism);

// Of one closed loop.
std::vector<std::string> dependent_joint_names(const Mechanism& mechanism, const LoopClosure& loop);

}  // namespace flatdyn
