// SPDX-License-Identifier: GPL-2.0-or-later
// The values of an element of a URDF, wherever in the element they stand: <axis xyz="0 1 0"/>, and as other programs
// and people write it, <axis><xyz>0 1 0</xyz></axis> and <axis>0 1 0</axis>.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <string_view>
#include <vector>

namespace flatdyn {

// A value of an element, under the name that it has there.
struct UrdfEntry {
  enum class Form { attribute, child, text };

  std::string name;  // "" of the element's text
  std::string text;
  int line = 0;
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

// The texts directly in the element, before and behind its children.
std::string text_in(const tinyxml2::XMLElement& element);

// The value of an element that is one value itself: <damping>10</damping> or <damping value="10"/>.
std::string value_of(const tinyxml2::XMLElement& element);

// Attributes, children and text of the element, in this order; of elements that are not known, attributes only.
std::vector<UrdfEntry> entries_of(const tinyxml2::XMLElement& element);

// Whether two texts are the same words, or words for the same numbers: "0 0 1" and "0 0 1.0".
bool are_equivalent_texts(const std::string& a, const std::string& b);

// Whether the text is zeros only: "0 0.0 0".
bool is_zero_text(const std::string& text);

std::vector<std::string> words_of(const std::string& text);

// The word without the blanks around it if the text is a single one, else the text as it is.
std::string single_word(const std::string& text);

// Whether the name is one of another program's: "drake:gear_ratio".
inline bool has_namespace(std::string_view name) { return name.find(':') != std::string_view::npos; }

}  // namespace flatdyn
