// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/element_at.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "robot/input/common/context.hpp"
#include "robot/input/common/xml_document.hpp"

namespace flatdyn {

namespace {

// The class whose defaults an element of an MJCF file gives; nullopt of all others. around: nullptr of the root.
std::optional<std::string> class_around(const FileNode& element, const FileNode* around) {
  if (around == nullptr || around->name != "default" || element.name == "default") return std::nullopt;
  return around->has("class") ? around->value("class") : "main";
}

}  // namespace

std::string name_in_messages(const ElementOfFile& element) {
  if (element.class_of_defaults) return "<" + element.name + "> of class \"" + *element.class_of_defaults + "\"";
  return "<" + element.name + (element.own_name.empty() ? "" : " name=\"" + element.own_name + "\"") + ">";
}

void ElementsOfFiles::add(const FileNode& element, const FileNode* around, std::vector<Element>& elements) {
  Element found{
      {element.name, element.value("name"), class_around(element, around)}, element.place.line, element.place.line, {}};
  for (const FileAttribute& attribute : element.attributes) {
    found.attributes.push_back(attribute.name);
    found.last_line = std::max(found.last_line, attribute.place.line);
  }
  elements.push_back(found);
  for (const FileNode& child : element.children) add(child, &element, elements);
}

std::vector<ElementsOfFiles::Element> ElementsOfFiles::elements_of(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  Diagnostics none;
  const std::optional<std::string> text = file_text(file, none);
  const std::optional<XmlDocument> document = text ? parse_xml(*text, file, {}, none) : std::nullopt;
  std::vector<Element> elements;
  if (document) add(document->root, nullptr, elements);
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
