// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/unknown.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/common/xml_elements.hpp"
#include "robot/input/urdf/unsupported.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

const SdfNames kOfPose = {{}, {}, {"relative_to", "rotation_format", "degrees", "frame"}};

bool is_listed(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The known name that was meant, as a hint; "" if none is near.
std::string near_name(const char* name, const std::vector<std::string>& known) {
  if (const std::string meant = known_spelling_of(name, known); !meant.empty() && !has_namespace(name)) {
    return "did you mean \"" + meant + "\"?";
  }
  const std::string hint = hint_for_unknown(name, known, "names");
  return hint.starts_with("did you mean") ? hint : "";
}

bool says_nothing(const XMLElement& element) {
  const std::vector<const XMLElement*> children = elements_in(element);
  return is_zero_text(text_in(element)) &&
         std::all_of(children.begin(), children.end(), [](const XMLElement* each) { return says_nothing(*each); });
}

}  // namespace

void SdfUnknown::check_child(const XMLElement& child, const std::string& what, const SdfNames& names,
                             const SdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  const std::string message = what + ": unknown element <" + child.Name() + ">";
  if (const std::string hint = near_name(child.Name(), names.read); !hint.empty()) {
    diagnostics.error(values.place(child), message, hint);
  } else if (is_unsupported_element(child.Name())) {
    diagnostics.unsupported(values.place(child), what + ": <" + child.Name() + "> is not supported yet",
                            "delete it, or add its forces to what the generated code returns");
  } else if (is_dynamics_name(child.Name()) && !says_nothing(child)) {
    diagnostics.unsupported(values.place(child), message + ", which by its name changes how the robot moves",
                            "write it in the words of docs/robot-format/sdf.md, or delete it");
  } else if (noted_.insert(child.Name()).second) {
    diagnostics.note(values.place(child), message + ": not read, here and elsewhere",
                     "delete it if it is meant to change how the robot moves, or write it in SDF's words",
                     "unknown elements not read");
  }
}

void SdfUnknown::check_attributes(const XMLElement& holder, const std::string& what, const SdfNames& names,
                                  const SdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  for (const tinyxml2::XMLAttribute* a = holder.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (is_listed(names.attributes, a->Name()) || has_namespace(a->Name())) continue;
    const std::string message = what + ": unknown attribute \"" + a->Name() + "\"";
    if (const std::string hint = near_name(a->Name(), names.attributes); !hint.empty()) {
      diagnostics.error(values.place(holder), message, hint);
    } else if (noted_.insert(std::string(holder.Name()) + " " + a->Name()).second) {
      diagnostics.note(values.place(holder), message + ": not read, here and in every <" + holder.Name() + ">",
                       "delete it, or write it in SDF's words", "unknown attributes not read");
    }
  }
}

void SdfUnknown::check(const XMLElement& holder, const std::string& what, const SdfNames& names,
                       const SdfValues& values) {
  check_attributes(holder, what, names, values);
  for (const XMLElement* child : elements_in(holder)) {
    if (std::string_view(child->Name()) == "pose") check_attributes(*child, what + ", pose", kOfPose, values);
    if (!is_listed(names.read, child->Name()) && !is_listed(names.irrelevant, child->Name()))
      check_child(*child, what, names, values);
  }
  if (names.read.empty() || words_of(text_in(holder)).empty()) return;
  if (!noted_.insert(std::string("text of ") + holder.Name()).second) return;
  values.context().diagnostics.note(values.place(holder), what + ": the text in it is not read",
                                    "a comment is <!-- ... -->", "unknown elements not read");
}

}  // namespace flatdyn
