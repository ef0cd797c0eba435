// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/children.hpp"

#include <algorithm>

#include "base/diagnostics/characters.hpp"
#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/common/xml_elements.hpp"

namespace flatdyn {

using tinyxml2::XMLElement;

void refuse_other_attributes(const XMLElement& element, const std::string& what, const std::vector<std::string>& known,
                             const UrdfValues& values) {
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (std::find(known.begin(), known.end(), a->Name()) != known.end()) continue;
    const std::string hint = hint_for_unknown(a->Name(), known, "attributes");
    values.context().diagnostics.error(values.place(element), what + ": unknown attribute \"" + a->Name() + "\"",
                                       hint.empty() ? "no attributes are read from here: delete it" : hint);
  }
}

void refuse_children(const XMLElement& element, const std::string& what, const std::vector<std::string>& known,
                     const UrdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  for (const XMLElement* child : elements_in(element)) {
    if (std::find(known.begin(), known.end(), child->Name()) != known.end()) continue;
    const std::string hint = hint_for_unknown(child->Name(), known, "elements");
    diagnostics.error(values.place(*child), what + ": unknown element <" + child->Name() + ">",
                      hint.empty() ? "no elements are read from here: delete it" : hint);
  }
  if (words_of(text_in(element)).empty()) return;
  diagnostics.error(values.place(element), what + ": the text \"" + trimmed_text_of(element) + "\" is not read",
                    "write values as attributes");
}

}  // namespace flatdyn
