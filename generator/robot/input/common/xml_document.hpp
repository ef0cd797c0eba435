// SPDX-License-Identifier: GPL-2.0-or-later
// XML files of robots: parsing, and what is refused of any of them.
#pragma once

#include <tinyxml2.h>

#include <string>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

// The name of a format and its outermost element, for hints.
struct XmlForm {
  std::string extension;  // ".urdf"
  std::string outline;    // "a URDF file is <robot name=\"...\"> ... </robot>"
};

// The outermost element; nullptr and an error if the text is not well-formed, has none, or declares entities. Lines
// keep their numbers, and names have the usual prefixes of their namespaces.
const tinyxml2::XMLElement* parse_xml(const std::string& text, const std::string& file, const XmlForm& form,
                                      Diagnostics& diagnostics, tinyxml2::XMLDocument& document);

// True, and an error, if there is an element or text outside the outermost element: of two robots in one file it is not
// clear which is meant.
bool refuse_content_beside(const tinyxml2::XMLElement& root, const std::string& file, const XmlForm& form,
                           Diagnostics& diagnostics);

// The name of the first element of a text without its prefix, "" if there is none; the text need not be well-formed.
std::string outermost_element(const std::string& text);

}  // namespace flatdyn
