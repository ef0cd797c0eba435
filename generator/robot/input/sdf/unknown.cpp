// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/unknown.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/unsupported.hpp"

namespace flatdyn {

namespace {

const SdfNames kOfPose = {{}, {}, {"relative_to", "rotation_format", "degrees", "frame"}};

bool is_listed(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The known name that was meant, as a hint; "" if none is near.
std::string near_name(const std::string& name, const std::vector<std::string>& known) {
  if (const std::string meant = known_spelling_of(name, known); !meant.empty() && !has_namespace(name)) {
    return "did you mean \"" + meant + "\"?";
  }
  const std::string hint = hint_for_unknown(name, known, "names");
  return hint.starts_with("did you mean") ? hint : "";
}

bool says_nothing(const FileNode& element) {
  return is_zero_text(element.text) && std::all_of(element.children.begin(), element.children.end(), says_nothing);
}

}  // namespace

void SdfUnknown::check_child(const FileNode& child, const std::string& what, const SdfNames& names,
                             const SdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  const std::string message = what + ": unknown element <" + child.name + ">";
  if (const std::string hint = near_name(child.name, names.read); !hint.empty()) {
    diagnostics.error(child.place, message, hint);
  } else if (is_unsupported_element(child.name)) {
    diagnostics.unsupported(child.place, what + ": <" + child.name + "> is not supported yet",
                            "delete it, or add its forces to what the generated code returns");
  } else if (is_dynamics_name(child.name) && !says_nothing(child)) {
    diagnostics.unsupported(child.place, message + ", which by its name changes how the robot moves",
                            "write it in the words of docs/robot-format/sdf.md, or delete it");
  } else if (noted_.insert(child.name).second) {
    diagnostics.note(child.place, message + ": not read, here and elsewhere",
                     "delete it if it is meant to change how the robot moves, or write it in SDF's words",
                     "unknown elements not read");
  }
}

void SdfUnknown::check_attributes(const FileNode& holder, const std::string& what, const SdfNames& names,
                                  const SdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  for (const FileAttribute& a : holder.attributes) {
    if (is_listed(names.attributes, a.name) || has_namespace(a.name)) continue;
    const std::string message = what + ": unknown attribute \"" + a.name + "\"";
    if (const std::string hint = near_name(a.name, names.attributes); !hint.empty()) {
      diagnostics.error(holder.place, message, hint);
    } else if (noted_.insert(holder.name + " " + a.name).second) {
      diagnostics.note(holder.place, message + ": not read, here and in every <" + holder.name + ">",
                       "delete it, or write it in SDF's words", "unknown attributes not read");
    }
  }
}

void SdfUnknown::check(const FileNode& holder, const std::string& what, const SdfNames& names,
                       const SdfValues& values) {
  check_attributes(holder, what, names, values);
  for (const FileNode& child : holder.children) {
    if (child.name == "pose") check_attributes(child, what + ", pose", kOfPose, values);
    if (!is_listed(names.read, child.name) && !is_listed(names.irrelevant, child.name))
      check_child(child, what, names, values);
  }
  if (names.read.empty() || words_of(holder.text).empty()) return;
  if (!noted_.insert(std::string("text of ") + holder.name).second) return;
  values.context().diagnostics.note(holder.place, what + ": the text in it is not read", "a comment is <!-- ... -->",
                                    "unknown elements not read");
}

}  // namespace flatdyn
