// SPDX-License-Identifier: GPL-2.0-or-later
// Texts that have the hash of themselves in them. What stands in its place is hashed.
#pragma once

#include <initializer_list>
#include <string>

namespace flatdyn {

// In its place until it is known: all 40 digits, or the first 8. No text has these characters otherwise.
inline constexpr const char *kHash = "\x01", *kShortHash = "\x02";

// Texts that belong together get the hash of all of them.
void fill_in_hash(std::initializer_list<std::string *> texts);

}  // namespace flatdyn
