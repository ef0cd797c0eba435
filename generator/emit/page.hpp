// SPDX-License-Identifier: GPL-2.0-or-later
// Templates (templates/), filled in.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

namespace flatdyn {

kainjow::mustache::data list_of(const std::vector<std::string>& texts);

// Nothing is escaped. Throws std::logic_error for a template with a mistake.
std::string rendered(const char* text, const kainjow::mustache::data& page);

// A page of HTML: values are escaped, but for those in three braces. Throws std::logic_error as well.
std::string rendered_html(const char* text, const kainjow::mustache::data& page);

// As it may stand in an element of HTML, or in an attribute.
std::string html_text(const std::string& text);

}  // namespace flatdyn
