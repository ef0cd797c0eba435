// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/names.hpp"

#include "robot/input/common/unknown_names.hpp"
#include "robot/input/mjcf/schema.hpp"

namespace flatdyn {

namespace {

class MjcfUnknown : public UnknownNames {
 public:
  explicit MjcfUnknown(Diagnostics& diagnostics)
      : UnknownNames(mjcf_schema(), {"MJCF", "docs/robot-format/mjcf.md", true}, diagnostics) {}

 private:
  std::string name_in(const std::string&, const FileNode& element) const override { return name_in_messages(element); }
};

// Attributes of defaults, of the elements that are read with them.
void check_default_names(const FileNode& defaults, MjcfUnknown& unknown) {
  for (const FileNode& child : defaults.children) {
    if (child.name == "default") {
      check_default_names(child, unknown);
    } else if (default_kind_of(child.name, "") == "general") {
      unknown.check(child, name_in_messages(child), "actuator");
    } else if (child.name == "joint" || child.name == "geom") {
      unknown.check(child, name_in_messages(child));
    }
  }
}

}  // namespace

void check_mjcf_names(const FileNode& root, Diagnostics& diagnostics) {
  MjcfUnknown unknown(diagnostics);
  unknown.check(root, name_in_messages(root));
  for (const FileNode* defaults : root.elements("default")) check_default_names(*defaults, unknown);
}

void refuse_mjcf(const Place& place, const std::string& message, const std::string& name, const MjcfValues& values) {
  values.diagnostics().unsupported(place, message, "--ignore " + name + " leaves it out");
}

}  // namespace flatdyn
