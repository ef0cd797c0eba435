// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

namespace flatdyn {

// The end of a search: a number of candidates per function, or a time for all functions together, s.
struct SearchLimit {
  std::optional<int> candidates;
  std::optional<double> seconds;
};

inline constexpr const char* kSearchLimitHint =
    "write a number of candidates, such as 200, or a time, such as 30s; at most 1000000, and 86400s";

// Parses "200" or "30s"; nullopt if the text is neither.
std::optional<SearchLimit> search_limit(const std::string& text);

}  // namespace flatdyn
