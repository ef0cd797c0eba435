// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/xml_document.hpp"

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

}  // namespace

const tinyxml2::XMLElement* parse_xml(const std::string& text, const std::string& file, const XmlForm& form,
                                      Diagnostics& diagnostics, tinyxml2::XMLDocument& document) {
  // The parser resolves no entities of its own but the five of XML; nesting is bounded (100).
  const std::string plain = without_instructions(text);
  if (document.Parse(plain.data(), plain.size()) != tinyxml2::XML_SUCCESS) {
    diagnostics.error({file, document.ErrorLineNum()}, "not well-formed XML: " + readable(document.ErrorName()),
                      "check the tags and quotes near this line");
    return nullptr;
  }
  if (const tinyxml2::XMLNode* doctype = doctype_with_declarations(document)) {
    diagnostics.error({file, doctype->GetLineNum()}, "a <!DOCTYPE ...> with declarations of its own is not read",
                      "put in what it declares: xmllint --noent --dropdtd FILE > robot" + form.extension);
    return nullptr;
  }
  tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) {
    diagnostics.error({file, 0}, "there is no element in this file", form.outline);
    return nullptr;
  }
  give_usual_prefixes(*root);
  return root;
}

bool refuse_content_beside(const tinyxml2::XMLElement& root, const std::string& file, const XmlForm& form,
                           Diagnostics& diagnostics) {
  for (const tinyxml2::XMLNode* node = root.GetDocument()->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node == &root || (node->ToElement() == nullptr && node->ToText() == nullptr)) continue;
    diagnostics.error({file, node->GetLineNum()},
                      "there is something else beside <" + std::string(root.Name()) + ">, the outermost element",
                      form.outline);
    return true;
  }
  return false;
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
