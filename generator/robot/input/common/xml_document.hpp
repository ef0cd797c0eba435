// SPDX-License-Identifier: GPL-2.0-or-later
// XML files of robots: parsing, and what is refused of any of them.
#pragma once

#include <optional>
#include <string>

#include "robot/input/common/file_node.hpp"

namespace flatdyn {

// The name of a format and its outermost element, for hints.
struct XmlForm {
  std::string extension;  // ".urdf"
  std::string outline;    // "a URDF file is <robot name=\"...\"> ... </robot>"
};

struct XmlDocument {
  FileNode root;                // the outermost element
  std::optional<Place> beside;  // of the first element or text outside of it
};

// nullopt and an error if the text is not well-formed, has no element, or declares entities. Lines keep their numbers,
// and names have the usual prefixes of their namespaces.
std::optional<XmlDocument> parse_xml(const std::string& text, const std::string& file, const XmlForm& form,
                                     Diagnostics& diagnostics);

// True, and an error, if there is something beside the outermost element: of two robots in one file it is not clear
// which is meant.
bool refuse_content_beside(const XmlDocument& document, const XmlForm& form, Diagnostics& diagnostics);

// The name of the first element of a text without its prefix, "" if there is none; the text need not be well-formed.
std::string outermost_element(const std::string& text);

}  // namespace flatdyn
