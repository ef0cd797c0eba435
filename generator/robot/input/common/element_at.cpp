// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/element_at.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "robot/input/common/context.hpp"
#include "robot/input/common/xml_document.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

bool is_default(const XMLElement& element) { return std::string_view(element.Name()) == "default"; }

// The class whose defaults an element of an MJCF file gives; nullopt of all others.
std::optional<std::string> class_around(const XMLElement& element) {
  const tinyxml2::XMLNode* parent = element.Parent();
  const XMLElement* around = parent == nullptr ? nullptr : parent->ToElement();
  if (around == nullptr || !is_default(*around) || is_default(element)) return std::nullopt;
  const char* name = around->Attribute("class");
  return name == nullptr ? "main" : name;
}

const XMLElement* next_of(const XMLElement& element) {
  if (const XMLElement* child = element.FirstChildElement()) return child;
  const tinyxml2::XMLNode* node = &element;
  while (node != nullptr && node->NextSiblingElement() == nullptr) node = node->Parent();
  return node == nullptr ? nullptr : node->NextSiblingElement();
}

}  // namespace

std::string name_in_messages(const ElementOfFile& element) {
  if (element.class_of_defaults) return "<" + element.name + "> of class \"" + *element.class_of_defaults + "\"";
  return "<" + element.name + (element.own_name.empty() ? "" : " name=\"" + element.own_name + "\"") + ">";
}

std::vector<ElementsOfFiles::Element> ElementsOfFiles::elements_of(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  Diagnostics none;
  tinyxml2::XMLDocument document;
  const std::optional<std::string> text = file_text(file, none);
  std::vector<Element> elements;
  const XMLElement* element = text ? parse_xml(*text, file, {}, none, document) : nullptr;
  for (; element != nullptr; element = next_of(*element)) {
    Element found{{element->Name(), "", class_around(*element)}, element->GetLineNum(), element->GetLineNum(), {}};
    if (const char* name = element->Attribute("name")) found.element.own_name = name;
    for (const tinyxml2::XMLAttribute* a = element->FirstAttribute(); a != nullptr; a = a->Next()) {
      found.attributes.push_back(a->Name());
      found.last_line = std::max(found.last_line, a->GetLineNum());
    }
    elements.push_back(found);
  }
  return elements;
}

std::optional<ElementOfFile> ElementsOfFiles::at(const Place& place, const std::vector<std::string>& attributes,
                                                 const std::string& name) {
  const auto known = files_.find(place.file);
  if (known == files_.end()) files_[place.file] = elements_of(place.file);
  std::optional<ElementOfFile> best;
  std::tuple<bool, bool> rank_of_best;
  for (const Element& each : files_[place.file]) {
    if (place.line < each.first_line || place.line > each.last_line) continue;
    const bool has_attribute = std::find_first_of(each.attributes.begin(), each.attributes.end(), attributes.begin(),
                                                  attributes.end()) != each.attributes.end();
    const std::tuple rank(has_attribute, each.element.own_name == name);
    if (best && rank < rank_of_best) continue;
    best = each.element;
    rank_of_best = rank;
  }
  return best;
}

}  // namespace flatdyn
