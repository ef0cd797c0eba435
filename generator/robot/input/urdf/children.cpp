// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/children.hpp"

#include <algorithm>

#include "base/diagnostics/characters.hpp"
#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

template <class Named>
int index_called(const std::vector<Named>& all, const char* kind, const std::string& name, const Place& place,
                 const std::string& what, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return static_cast<int>(i);
    known.push_back(all[i].name);
  }
  diagnostics.error(place, what + ": there is no " + kind + " \"" + name + "\"",
                    hint_for_unknown(name, known, std::string(kind) + "s"));
  return -1;
}

}  // namespace

std::vector<const XMLElement*> elements_in(const XMLElement& parent, const char* name) {
  std::vector<const XMLElement*> elements;
  for (const XMLElement* e = parent.FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name)) {
    elements.push_back(e);
  }
  return elements;
}

std::string trimmed_text_of(const XMLElement& element) { return std::string(trimmed(text_in(element))); }

std::string named(const XMLElement& element) {
  const char* name = element.Attribute("name");
  return element.Name() + (name == nullptr ? std::string() : " \"" + std::string(name) + "\"");
}

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

int link_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                Diagnostics& diagnostics) {
  return index_called(robot.links, "link", name, place, what, diagnostics);
}

int joint_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                 Diagnostics& diagnostics) {
  return index_called(robot.joints, "joint", name, place, what, diagnostics);
}

}  // namespace flatdyn
