// SPDX-License-Identifier: GPL-2.0-or-later
// Elements of a URDF that are read by their children, and children by their text.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <vector>

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// The children of this name, in the order of the file; nullptr: all elements.
std::vector<const tinyxml2::XMLElement*> elements_in(const tinyxml2::XMLElement& parent, const char* name = nullptr);

// Its text without the blanks around it; "" if there is none.
std::string trimmed_text_of(const tinyxml2::XMLElement& element);

// "plugin \"grip\"", or "plugin" where it has no name.
std::string named(const tinyxml2::XMLElement& element);

// An error for each attribute of the element that is not one of these.
void refuse_other_attributes(const tinyxml2::XMLElement& element, const std::string& what,
                             const std::vector<std::string>& known, const UrdfValues& values);

// An error for each child of the element that is not one of these, and for a text in it.
void refuse_children(const tinyxml2::XMLElement& element, const std::string& what,
                     const std::vector<std::string>& known, const UrdfValues& values);

// Index of the link or joint of this name, -1 and an error if there is none. `what` says who refers to it.
int link_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                Diagnostics& diagnostics);
int joint_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                 Diagnostics& diagnostics);

}  // namespace flatdyn
