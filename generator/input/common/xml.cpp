// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/common/xml.hpp"

#include <string_view>

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

// Processing instructions concern other programs, but the parser takes none within the robot, and no XML
// declaration after a comment. Blanks stand in for them, so that lines keep their numbers.
std::string without_instructions(std::string text) {
  const auto end_of = [&text](std::size_t begin, std::string_view mark) {
    const std::size_t end = text.find(mark, begin);
    return end == std::string::npos ? text.size() : end + mark.size();
  };
  for (std::size_t k = text.find('<'); k < text.size(); k = text.find('<', k + 1)) {
    if (text.compare(k, 4, "<!--") == 0) {
      k = end_of(k, "-->") - 1;
    } else if (text.compare(k, 9, "<![CDATA[") == 0) {
      k = end_of(k, "]]>") - 1;
    } else if (text.compare(k, 2, "<?") == 0) {
      const std::size_t end = end_of(k, "?>");
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

bool parse_xml(const std::string& text, const std::string& file, tinyxml2::XMLDocument& document,
               Diagnostics& diagnostics) {
  const std::string plain = without_instructions(text);
  if (document.Parse(plain.data(), plain.size()) != tinyxml2::XML_SUCCESS) {
    diagnostics.error({file, document.ErrorLineNum()}, "not well-formed XML: " + readable(document.ErrorName()),
                      "check the tags and quotes near this line");
    return false;
  }
  if (const tinyxml2::XMLNode* doctype = doctype_with_declarations(document)) {
    diagnostics.error({file, doctype->GetLineNum()}, "a <!DOCTYPE ...> with declarations of its own is not read",
                      "put in what it declares: xmllint --noent --dropdtd FILE > robot.urdf");
    return false;
  }
  if (document.RootElement() != nullptr) return true;
  diagnostics.error({file, 0}, "there is no element in this file", "a URDF file is <robot name=\"...\"> ... </robot>");
  return false;
}

const tinyxml2::XMLNode* content_beside(const tinyxml2::XMLElement& root) {
  for (const tinyxml2::XMLNode* node = root.GetDocument()->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node != &root && (node->ToElement() != nullptr || node->ToText() != nullptr)) return node;
  }
  return nullptr;
}

}  // namespace flatdyn
