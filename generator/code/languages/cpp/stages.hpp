// SPDX-License-Identifier: GPL-2.0-or-later
// The section of a header with the stages: two structs, and the functions that make them.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "code/emit/stage_text.hpp"

namespace flatdyn {

// Fills in the template's `staged?` section.
void write_stages(kainjow::mustache::data& header, const std::vector<StageText>& stages, const std::string& name_space);

}  // namespace flatdyn
