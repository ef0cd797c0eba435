// SPDX-License-Identifier: GPL-2.0-or-later
// Where the numbers of a robot are written: of what a class of defaults gives, that is the class's line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "robot/model/robot.hpp"

namespace flatdyn {

// The places of masses, and of joints with their friction, springs, armatures, motors and limits, a line for each link
// that has a mass and for each joint that moves; of XML files with the element, and of MJCF with its class of defaults.
// Numbers that are zero because nothing gives them have none.
std::string describe_places(const Robot& robot);

// {"links": [{"name", "places": [...]}], "joints": ...}, each place with the keys "what", "file", "line", and of XML
// files "element" and, where it is a default, "class".
nlohmann::ordered_json places_json(const Robot& robot);

}  // namespace flatdyn
