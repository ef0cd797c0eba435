// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// "sha1:…" of the texts, one after the other.
std::string content_hash(const std::vector<std::string>& texts);

}  // namespace flatdyn
