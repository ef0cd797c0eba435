// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace flatdyn {

// The text with lines broken at blanks so that none has more than `width` characters, if its words allow it. A
// continuation is indented to the last column of its line, where columns are separated by two blanks, or else to the
// line's beginning.
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace flatdyn
