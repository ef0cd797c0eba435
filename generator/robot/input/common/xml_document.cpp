// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/xml_document.hpp"

#include <tinyxml2.h>

#include <string_view>

#include "robot/input/common/namespaces.hpp"

namespace flatdyn {

namespace {

// "XML_ERROR_MISMATCHED_ELEMENT" → "mismatched element"
std::string readable(std::string name) {
  for (const std::string prefix : {"XML_ERROR_", "XML_"}) {
    if (name.starts_with(prefix)) name.erase(0, prefix.size());
  }
  for (char& c : name) c = c == '_' ? ' ' : static_cast<char>(c | 0x20);
  return name;
}

// The place behind the next `mark`, or the end.
std::size_t behind(const std::string& text, std::size_t begin, std::string_view mark) {
  const std::size_t end = text.find(mark, begin);
  return end == std::string::npos ? text.size() : end + mark.size();
}

// Processing instructions concern other programs, but the parser takes none within the robot, and no XML
// declaration after a comment. Blanks stand in for them, so that lines keep their numbers.
std::string without_instructions(std::string text) {
  for (std::size_t k = text.find('<'); k < text.size(); k = text.find('<', k + 1)) {
    if (text.compare(k, 4, "<!--") == 0) {
      k = behind(text, k, "-->") - 1;
    } else if (text.compare(k, 9, "<![CDATA[") == 0) {
      k = behind(text, k, "]]>") - 1;
    } else if (text.compare(k, 2, "<?") == 0) {
      const std::size_t end = behind(text, k, "?>");
      for (; k < end; ++k) text[k] = text[k] == '\n' ? '\n' : ' ';
      --k;
    }
  }
  return text;
}

// Declarations in a DOCTYPE define names for texts, which the parser does not put in.
const tinyxml2::XMLNode* doctype_with_declarations(const tinyxml2::XMLDocument& document) {
  for (const tinyxml2::XMLNode* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    const std::string_view text = node->ToUnknown() == nullptr ? "" : node->Value();
    if (text.starts_with("DOCTYPE") && text.find('[') != std::string_view::npos) return node;
  }
  return nullptr;
}

// The texts directly in the element, one behind the other.
std::string text_in(const tinyxml2::XMLElement& element) {
  std::string text;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) text += std::string(text.empty() ? "" : " ") + node->Value();
  }
  return text;
}

FileNode node_of(const tinyxml2::XMLElement& element, const std::string& file) {
  FileNode node{element.Name(), {}, {}, {file, element.GetLineNum()}, text_in(element)};
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    node.attributes.push_back({a->Name(), a->Value(), {file, a->GetLineNum()}});
  }
  for (const tinyxml2::XMLElement* e = element.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    node.children.push_back(node_of(*e, file));
  }
  return node;
}

std::optional<Place> place_beside(const tinyxml2::XMLElement& root, const std::string& file) {
  for (const tinyxml2::XMLNode* node = root.GetDocument()->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node != &root && (node->ToElement() != nullptr || node->ToText() != nullptr))
      return Place{file, node->GetLineNum()};
  }
  return std::nullopt;
}

}  // namespace

std::optional<XmlDocument> parse_xml(const std::string& text, const std::string& file, const XmlForm& form,
                                     Diagnostics& diagnostics) {
  // The parser resolves no entities of its own but the five of XML; nesting is bounded (100).
  tinyxml2::XMLDocument document;
  const std::string plain = without_instructions(text);
  if (document.Parse(plain.data(), plain.size()) != tinyxml2::XML_SUCCESS) {
    diagnostics.error({file, document.ErrorLineNum()}, "not well-formed XML: " + readable(document.ErrorName()),
                      "check the tags and quotes near this line");
    return std::nullopt;
  }
  if (const tinyxml2::XMLNode* doctype = doctype_with_declarations(document)) {
    diagnostics.error({file, doctype->GetLineNum()}, "a <!DOCTYPE ...> with declarations of its own is not read",
                      "put in what it declares: xmllint --noent --dropdtd FILE > robot" + form.extension);
    return std::nullopt;
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) {
    diagnostics.error({file, 0}, "there is no element in this file", form.outline);
    return std::nullopt;
  }
  XmlDocument read{node_of(*root, file), place_beside(*root, file)};
  give_usual_prefixes(read.root);
  return read;
}

bool refuse_content_beside(const XmlDocument& document, const XmlForm& form, Diagnostics& diagnostics) {
  if (!document.beside) return false;
  diagnostics.error(*document.beside,
                    "there is something else beside <" + document.root.name + ">, the outermost element", form.outline);
  return true;
}

std::string outermost_element(const std::string& text) {
  std::size_t k = text.find('<');
  while (k < text.size() && (text.compare(k, 2, "<?") == 0 || text.compare(k, 2, "<!") == 0)) {
    const char* end = text.compare(k, 4, "<!--") == 0 ? "-->" : ">";
    k = text.find('<', behind(text, k, end));
  }
  if (k >= text.size()) return "";
  const std::size_t end = text.find_first_of(" \t\r\n/>", k);
  const std::string name = text.substr(k + 1, end == std::string::npos ? end : end - k - 1);
  return name.substr(name.find(':') + 1);
}

}  // namespace flatdyn
