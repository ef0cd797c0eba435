// SPDX-License-Identifier: GPL-2.0-or-later
// Texts that contain their own hash. The hash is taken while a placeholder stands in its place.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// Placeholders for all 40 digits and for the first 8. These characters do not occur in texts otherwise.
inline constexpr const char *kHashPlaceholder = "\x01", *kShortHashPlaceholder = "\x02";

// Fills the hash of all these texts, which belong together, into each.
void fill_in_hash(const std::vector<std::string *> &texts);

}  // namespace flatdyn
