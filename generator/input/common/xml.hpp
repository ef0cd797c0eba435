// SPDX-License-Identifier: GPL-2.0-or-later
// XML texts of robot files.
#pragma once

#include <tinyxml2.h>

#include <string>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {

// False, and a diagnostic, if the text is not well-formed, has no element, or declares names that the parser does not
// put in. Processing instructions are left out.
bool parse_xml(const std::string& text, const std::string& file, tinyxml2::XMLDocument& document,
               Diagnostics& diagnostics);

// A second outermost element, or text beside the first one; nullptr if there is none.
const tinyxml2::XMLNode* content_beside(const tinyxml2::XMLElement& root);

}  // namespace flatdyn
