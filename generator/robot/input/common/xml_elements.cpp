// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/xml_elements.hpp"

#include "base/diagnostics/characters.hpp"

namespace flatdyn {

using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

std::vector<const XMLElement*> elements_in(const XMLElement& parent, const char* name) {
  std::vector<const XMLElement*> elements;
  for (const XMLElement* e = parent.FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name)) {
    elements.push_back(e);
  }
  return elements;
}

std::string text_in(const XMLElement& element) {
  std::string text;
  for (const XMLNode* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) text += std::string(text.empty() ? "" : " ") + node->Value();
  }
  return text;
}

std::string trimmed_text_of(const XMLElement& element) { return std::string(trimmed(text_in(element))); }

std::string value_of(const XMLElement& element) {
  const char* value = element.Attribute("value");
  const std::string text = text_in(element);
  return value != nullptr && text.empty() ? value : text;
}

std::string named(const XMLElement& element) {
  const char* name = element.Attribute("name");
  return element.Name() + (name == nullptr ? std::string() : " \"" + std::string(name) + "\"");
}

}  // namespace flatdyn
