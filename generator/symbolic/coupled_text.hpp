// SPDX-License-Identifier: GPL-2.0-or-later
// Where coupled joints are, for people.
#pragma once

#include <string>
#include <vector>

#include "model/mechanism.hpp"

namespace flatdyn {

// "right_finger = q[0] + 0.01" of every joint whose position is no entry of q, rad or m.
std::vector<std::string> coupled_joint_texts(const Mechanism& mechanism);

}  // namespace flatdyn
