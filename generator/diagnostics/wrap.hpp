// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace flatdyn {

// The text with its lines broken at blanks so that none has more than `width` characters, as far as its words allow.
// What is broken off stands under the last column of its line, which two blanks begin, else under the line's beginning.
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace flatdyn
