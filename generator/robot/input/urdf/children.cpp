// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/children.hpp"

#include <algorithm>

#include "base/diagnostics/characters.hpp"
#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/words.hpp"

namespace flatdyn {

void refuse_other_attributes(const FileNode& element, const std::string& what, const std::vector<std::string>& known,
                             const UrdfValues& values) {
  for (const FileAttribute& a : element.attributes) {
    if (std::find(known.begin(), known.end(), a.name) != known.end()) continue;
    const std::string hint = hint_for_unknown(a.name, known, "attributes");
    values.context().diagnostics.error(element.place, what + ": unknown attribute \"" + a.name + "\"",
                                       hint.empty() ? "no attributes are read from here: delete it" : hint);
  }
}

void refuse_children(const FileNode& element, const std::string& what, const std::vector<std::string>& known,
                     const UrdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  for (const FileNode& child : element.children) {
    if (std::find(known.begin(), known.end(), child.name) != known.end()) continue;
    const std::string hint = hint_for_unknown(child.name, known, "elements");
    diagnostics.error(child.place, what + ": unknown element <" + child.name + ">",
                      hint.empty() ? "no elements are read from here: delete it" : hint);
  }
  if (words_of(element.text).empty()) return;
  diagnostics.error(element.place, what + ": the text \"" + trimmed_text_of(element) + "\" is not read",
                    "write values as attributes");
}

void refuse_second(const FileNode& element, const std::string& what, const std::string& tag, const UrdfValues& values) {
  const std::vector<const FileNode*> all = element.elements(tag);
  if (all.size() < 2) return;
  values.context().diagnostics.error(all[1]->place, what + " has two <" + tag + "> elements", "keep one");
}

}  // namespace flatdyn
