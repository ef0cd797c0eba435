// SPDX-License-Identifier: GPL-2.0-or-later
// The values of an element of a URDF, wherever in the element they stand: <axis xyz="0 1 0"/>, and as other programs
// and people write it, <axis><xyz>0 1 0</xyz></axis> and <axis>0 1 0</axis>.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/input/common/file_node.hpp"

namespace flatdyn {

// A value of an element, under the name that it has there.
struct UrdfEntry {
  enum class Form { attribute, child, text };

  std::string name;  // "" of the element's text
  std::string text;
  Place place = {};
  Form form = Form::attribute;
};

// A value that is read: by its name in URDF, or by another one that people give it.
struct UrdfKey {
  std::string name;
  std::string other_name;  // "" if there is none
};

// The known keys of an element of which values are read.
struct UrdfElement {
  std::vector<UrdfKey> keys;
  std::vector<std::string> decisive;   // keys that any unknown name may be meant for, where one of them is missing
  std::string key_of_text;             // what a text in the element is; "" if that is not clear
  bool text_is_usual = false;          // URDF itself writes a text there
  std::vector<std::string> of_others;  // names that other programs read, and real files have: left out
};

// nullptr if no values are read of elements with this name.
const UrdfElement* known_urdf_element(std::string_view tag);

// The element that a value of this name is read from, where there is only one for it: "dynamics" of "damping"; "" if
// there is none.
std::string element_of_value(std::string_view name);

// The names of the keys, for messages.
std::vector<std::string> key_names_of(const UrdfElement& element);

bool has_key(const UrdfElement& element, std::string_view name);

// The name in URDF of the key that an entry gives; "" if it gives none.
std::string key_of(const UrdfElement& element, const UrdfEntry& entry);

// Attributes, children and text of the element, in this order; of elements that are not known, attributes only.
std::vector<UrdfEntry> entries_of(const FileNode& element);

}  // namespace flatdyn
