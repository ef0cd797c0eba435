// SPDX-License-Identifier: GPL-2.0-or-later
// Elements of an XML document, whatever its format.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <vector>

namespace flatdyn {

// The children of this name, in the order of the file; nullptr: all elements.
std::vector<const tinyxml2::XMLElement*> elements_in(const tinyxml2::XMLElement& parent, const char* name = nullptr);

// The texts directly in the element, before and behind its children.
std::string text_in(const tinyxml2::XMLElement& element);
// The same without the blanks around it; "" if there is no text.
std::string trimmed_text_of(const tinyxml2::XMLElement& element);

// The value of an element that is one value itself: <damping>10</damping> or <damping value="10"/>.
std::string value_of(const tinyxml2::XMLElement& element);

// "plugin \"grip\"", or "plugin" where it has no name.
std::string named(const tinyxml2::XMLElement& element);

}  // namespace flatdyn
