// SPDX-License-Identifier: GPL-2.0-or-later
// Transliteration of other scripts in names of a robot file to the letters of identifiers.
#pragma once

#include <string>

namespace flatdyn {

// ASCII letters for a character outside ASCII: "e" for é, "theta" for θ, "Sh" for Ш. A character of an unknown script
// becomes its number, set apart: "-u5173-" for 关. A sign becomes "-", which separates words.
std::string transliterated(char32_t character);

}  // namespace flatdyn
