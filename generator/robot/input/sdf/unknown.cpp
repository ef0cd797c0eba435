// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/unknown.hpp"

#include "robot/input/common/spelling.hpp"
#include "robot/input/sdf/schema.hpp"

namespace flatdyn {

namespace {

bool has_read_axes(const FileNode& joint) {
  static const std::set<std::string> kTypes = {"revolute",  "continuous", "prismatic", "screw",
                                               "universal", "revolute2",  "gearbox"};
  return kTypes.contains(joint.value("type"));
}

}  // namespace

SdfUnknown::SdfUnknown(const ReadContext& context)
    : UnknownNames(sdf_schema(), {"SDF", "docs/robot-format/sdf.md"}, context.diagnostics), context_(context) {}

void SdfUnknown::check_model(const FileNode& model, const std::string& what, const std::string& prefix,
                             bool is_static) {
  prefix_ = prefix;
  is_static_ = is_static;
  check(model, what);
}

bool SdfUnknown::goes_into(const FileNode& element, const FileNode& holder) const {
  if (holder.name == "sdf" || element.name == "model" || element.name == "include") return false;
  if (element.name == "joint") return holder.name == "model" && !is_static_;
  const bool is_axis = element.name == "axis" || element.name == "axis2";
  return !is_axis || (has_read_axes(holder) && !is_held(prefix_ + holder.value("name"), context_));
}

std::string SdfUnknown::name_in(const std::string& holder, const FileNode& element) const {
  if (!element.has("name")) return holder + ", " + element.name;
  return element.name + " \"" + prefix_ + element.value("name") + "\"";
}

bool SdfUnknown::refuse_by_format(const FileNode& element, const std::string& what) {
  if (!is_force_or_constraint_name(element.name)) return false;
  diagnostics().unsupported(element.place, what + ": <" + element.name + "> is not supported yet",
                            "delete it, or add its forces to what the generated code returns");
  return true;
}

}  // namespace flatdyn
