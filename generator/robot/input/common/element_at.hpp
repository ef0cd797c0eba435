// SPDX-License-Identifier: GPL-2.0-or-later
// Places of numbers → the elements of XML files that they are written in.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/input/common/file_node.hpp"

namespace flatdyn {

struct ElementOfFile {
  std::string name;                              // "joint"
  std::string own_name;                          // its attribute `name`; "" if it has none
  std::optional<std::string> class_of_defaults;  // of MJCF: the <default> that holds it; "main" of the outermost one
};

// "<joint name="elbow">", "<joint> of class "leg"".
std::string name_in_messages(const ElementOfFile& element);

// Reads each file once. Files that are no XML, or cannot be read, have no elements.
class ElementsOfFiles {
 public:
  // The element whose tag is in this line. Of several it is the one that has one of the attributes, then the one that
  // is called `name`, then the last one. nullopt if there is none.
  std::optional<ElementOfFile> at(const Place& place, const std::vector<std::string>& attributes,
                                  const std::string& name);

 private:
  struct Element {
    ElementOfFile element;
    int first_line = 0, last_line = 0;  // of its tag
    std::vector<std::string> attributes;
  };
  static std::vector<Element> elements_of(const std::string& file);
  static void add(const FileNode& element, const FileNode* around, std::vector<Element>& elements);

  std::map<std::string, std::vector<Element>> files_;
};

}  // namespace flatdyn
