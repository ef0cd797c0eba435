// SPDX-License-Identifier: GPL-2.0-or-later
// Templates of C++ text (templates/), filled in.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

namespace flatdyn {

kainjow::mustache::data list_of(const std::vector<std::string>& texts);

// Nothing is escaped. Throws std::logic_error for a template with a mistake.
std::string rendered(const char* text, const kainjow::mustache::data& page);

}  // namespace flatdyn
