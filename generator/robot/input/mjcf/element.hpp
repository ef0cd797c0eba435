// SPDX-License-Identifier: GPL-2.0-or-later
// An MJCF file as a tree of elements, with what <include> brings in at its place.
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <vector>

#include "robot/input/common/context.hpp"
#include "robot/input/common/xml_document.hpp"

namespace flatdyn {

inline const XmlForm kMjcfForm = {".xml", "an MJCF file is one <mujoco> ... </mujoco>"};

struct MjcfAttribute {
  std::string name;
  std::string text;
  Place place;
};

struct MjcfElement {
  std::string name;
  std::vector<MjcfAttribute> attributes;
  std::vector<MjcfElement> children;
  Place place;

  const MjcfAttribute* attribute(std::string_view attribute_name) const;          // nullptr if there is none
  std::string text(std::string_view attribute_name) const;                        // "" if there is none
  std::vector<const MjcfElement*> elements(std::string_view element_name) const;  // children of this name
};

// "joint \"elbow\"", or "joint" where it has no name.
std::string name_in_messages(const MjcfElement& element);

// The tree of a file, without the elements and attributes that --ignore names, which are noted. Included files are
// added to the robot's files.
MjcfElement mjcf_tree(const tinyxml2::XMLElement& root, const std::string& file, ReadContext& context, Robot& robot);

// The tree of another file, whose includes are relative to it; nullopt, and an error, if it is not an MJCF file.
std::optional<MjcfElement> mjcf_tree_of_file(const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn
