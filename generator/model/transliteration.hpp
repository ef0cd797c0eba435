// SPDX-License-Identifier: GPL-2.0-or-later
// Letters of other scripts in the names of a robot file, as identifiers have them.
#pragma once

#include <string>

namespace flatdyn {

// ASCII letters for a character that is none itself: "e" for é, "theta" for θ, "Sh" for Ш. Of scripts that are not
// known here its number, which stands apart: "-u5173-" for 关. A sign is "-", which separates words.
std::string transliterated(char32_t character);

}  // namespace flatdyn
