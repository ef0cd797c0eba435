// SPDX-License-Identifier: GPL-2.0-or-later
// An element of a robot file, whatever its format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

struct FileAttribute {
  std::string name;
  std::string text;
  Place place;
};

struct FileNode {
  std::string name;
  std::vector<FileAttribute> attributes;
  std::vector<FileNode> children;
  Place place;
  std::string text = {};  // directly in it, before and behind its children

  const FileAttribute* attribute(std::string_view attribute_name) const;  // nullptr if there is none
  std::string value(std::string_view attribute_name) const;               // the attribute's text, "" if there is none
  bool has(std::string_view attribute_name) const { return attribute(attribute_name) != nullptr; }

  // Children of this name, in the order of the file; the first of them, or nullptr.
  std::vector<const FileNode*> elements(std::string_view element_name) const;
  const FileNode* child(std::string_view element_name) const;
};

// The text without the blanks around it.
std::string trimmed_text_of(const FileNode& element);

// The value of an element that is one value itself: <damping>10</damping> or <damping value="10"/>.
std::string value_of(const FileNode& element);

// "joint \"elbow\"", or "joint" where it has no name.
std::string name_in_messages(const FileNode& element);

}  // namespace flatdyn
