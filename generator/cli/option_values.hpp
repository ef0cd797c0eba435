// SPDX-License-Identifier: GPL-2.0-or-later
// Values of options that are written in the words of robots, from their text. Those that return a value throw
// Failure(usage) for other text, with the option's name.
#pragma once

#include <string>
#include <vector>

#include "functions/planning/limit.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// --snap: rad, at most a quarter of the distance between the multiples of pi/12 to which angles are snapped.
Number snap_option(const std::string& text);
// --gravity: "X,Y,Z", m/s^2, or "off".
Vec3 gravity_option(const std::string& text);
// --frame: "NAME=LINK,X,Y,Z" or "NAME=LINK,X,Y,Z,ROLL,PITCH,YAW", m and rad.
SceneFrame frame_option(const std::string& text);
// --fix: "JOINT", "JOINT=POSITION" or "JOINT=ANGLEdeg" each, every joint at one position.
std::vector<JointPosition> fixed_options(const std::vector<std::string>& texts);
// --error-budget and --search.
ErrorBudget error_budget_option(const std::string& text);
SearchLimit search_option(const std::string& text);

// --name: what is wrong with it as the name of files that compilers and shells are given; empty: nothing.
std::string file_name_fault(const std::string& text);

}  // namespace flatdyn
