// SPDX-License-Identifier: GPL-2.0-or-later
// The classes of defaults: attributes that elements have where they do not give them.
#pragma once

#include <map>

#include "robot/input/mjcf/element.hpp"

namespace flatdyn {

// The class of elements for which nothing else says one.
inline constexpr const char* kMainClass = "main";

class MjcfDefaults {
 public:
  MjcfDefaults(const FileNode& root, Diagnostics& diagnostics);

  bool has_class(const std::string& name) const { return classes_.count(name) > 0; }
  std::vector<std::string> names() const;

  // The attribute that elements of this kind have in this class, or in the nearest one around it; nullptr if none has.
  // All actuators are of the kind "general", all equalities of the kind "equality".
  const FileAttribute* find(const std::string& name, const std::string& kind, const std::string& attribute) const;
  // All of them, the nearest one first.
  std::vector<const FileAttribute*> find_all(const std::string& name, const std::string& kind,
                                             const std::string& attribute) const;

 private:
  struct Class {
    std::string parent;
    std::vector<FileNode> elements;  // in an order in which the last one counts
  };

  // parent: "" of an outermost class.
  void read(const FileNode& element, const std::string& parent, Diagnostics& diagnostics);
  void read_content(const FileNode& element, const std::string& name, Diagnostics& diagnostics);

  std::map<std::string, Class> classes_;
};

// "general" of all actuators, "equality" and "tendon" of those in sections of this name.
std::string default_kind_of(const std::string& element, const std::string& section);

}  // namespace flatdyn
