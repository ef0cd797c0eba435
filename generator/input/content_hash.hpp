// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// "sha1:…" of the texts, one after the other.
std::string content_hash(const std::vector<std::string>& texts);
// The same of the bytes of the files.
std::string file_hash(const std::vector<std::string>& paths);

}  // namespace flatdyn
