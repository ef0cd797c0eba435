// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/defaults.hpp"

#include <set>

#include "robot/input/mjcf/attachment.hpp"

namespace flatdyn {

namespace {

bool is_actuator(const std::string& element) {
  static const std::set<std::string> kActuators = {"general",     "motor",   "position", "velocity", "intvelocity",
                                                   "orientation", "pid",     "damper",   "muscle",   "cylinder",
                                                   "adhesion",    "dcmotor", "plugin"};
  return kActuators.count(element) > 0;
}

}  // namespace

std::string default_kind_of(const std::string& element, const std::string& section) {
  if (section == "equality" || section == "tendon") return section;
  return is_actuator(element) ? "general" : element;
}

MjcfDefaults::MjcfDefaults(const FileNode& root, Diagnostics& diagnostics) {
  classes_[kMainClass];
  for (const FileNode* defaults : root.elements("default")) {
    const std::string name = defaults->value("class");
    if (!name.empty() && name != kMainClass) {
      diagnostics.error(defaults->place, "default: the outermost class is called \"main\", not \"" + name + "\"",
                        "leave its name out, or put the class into another <default>");
    }
    read_content(*defaults, kMainClass, diagnostics);
  }
  for (const FileNode* attached : root.elements(kMjcfAttachedDefaults)) {
    for (const FileNode& defaults : attached->children) read(defaults, "", diagnostics);
  }
}

void MjcfDefaults::read(const FileNode& element, const std::string& parent, Diagnostics& diagnostics) {
  const std::string name = element.value("class");
  if (name.empty()) {
    diagnostics.error(element.place, "default: a class inside another one has no name",
                      "write <default class=\"...\">");
    return;
  }
  const bool is_new = classes_.emplace(name, Class{parent, {}}).second;
  if (!is_new) {
    diagnostics.error(element.place, "default: there are two classes \"" + name + "\"", "rename one of them");
    return;
  }
  read_content(element, name, diagnostics);
}

void MjcfDefaults::read_content(const FileNode& element, const std::string& name, Diagnostics& diagnostics) {
  for (const FileNode& child : element.children) {
    if (child.name != "default") classes_[name].elements.push_back(child);
  }
  for (const FileNode* child : element.elements("default")) read(*child, name, diagnostics);
}

std::vector<std::string> MjcfDefaults::names() const {
  std::vector<std::string> all;
  for (const auto& [name, defaults] : classes_) all.push_back(name);
  return all;
}

std::vector<const FileAttribute*> MjcfDefaults::find_all(const std::string& name, const std::string& kind,
                                                         const std::string& attribute) const {
  std::vector<const FileAttribute*> all;
  for (auto found = classes_.find(name); found != classes_.end(); found = classes_.find(found->second.parent)) {
    const std::vector<FileNode>& elements = found->second.elements;
    for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
      const FileAttribute* known = element->attribute(attribute);
      if (known != nullptr && default_kind_of(element->name, "") == kind) all.push_back(known);
    }
  }
  return all;
}

const FileAttribute* MjcfDefaults::find(const std::string& name, const std::string& kind,
                                        const std::string& attribute) const {
  const std::vector<const FileAttribute*> all = find_all(name, kind, attribute);
  return all.empty() ? nullptr : all.front();
}

}  // namespace flatdyn
