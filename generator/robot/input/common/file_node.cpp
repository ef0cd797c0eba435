// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/file_node.hpp"

#include <algorithm>

#include "base/diagnostics/characters.hpp"

namespace flatdyn {

const FileAttribute* FileNode::attribute(std::string_view attribute_name) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const FileAttribute& each) { return each.name == attribute_name; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string FileNode::value(std::string_view attribute_name) const {
  const FileAttribute* found = attribute(attribute_name);
  return found == nullptr ? "" : found->text;
}

std::vector<const FileNode*> FileNode::elements(std::string_view element_name) const {
  std::vector<const FileNode*> found;
  for (const FileNode& each : children) {
    if (each.name == element_name) found.push_back(&each);
  }
  return found;
}

const FileNode* FileNode::child(std::string_view element_name) const {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const FileNode& each) { return each.name == element_name; });
  return found == children.end() ? nullptr : &*found;
}

std::string trimmed_text_of(const FileNode& element) { return std::string(trimmed(element.text)); }

std::string value_of(const FileNode& element) {
  return element.has("value") && element.text.empty() ? element.value("value") : element.text;
}

std::string name_in_messages(const FileNode& element) {
  const std::string name = element.value("name");
  return element.name + (name.empty() ? "" : " \"" + name + "\"");
}

}  // namespace flatdyn
