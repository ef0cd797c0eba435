// SPDX-License-Identifier: GPL-2.0-or-later
// Rendering of templates (templates/).
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

namespace flatdyn {

kainjow::mustache::data list_of(const std::vector<std::string>& texts);

// The template filled in, without escaping. Throws std::logic_error for a template with an error.
std::string rendered(const char* text, const kainjow::mustache::data& page);

// A page of HTML: values are escaped, except those in triple braces. Throws std::logic_error likewise.
std::string rendered_html(const char* text, const kainjow::mustache::data& page);

// The text escaped for an element or an attribute of HTML.
std::string html_text(const std::string& text);

}  // namespace flatdyn
