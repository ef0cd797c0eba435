// SPDX-License-Identifier: GPL-2.0-or-later
#include "diagnostics/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace flatdyn {

namespace {

// The Levenshtein distance: insertions, deletions and replacements of a character.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

std::string joined(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 24;  // a longer list helps nobody
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > kMost ? text + ", ..." : text;
}

}  // namespace

std::string hint_for_unknown(std::string_view written, const std::vector<std::string>& known, std::string_view plural) {
  constexpr std::size_t kLongestName = 200;
  // A third of the letters may be wrong, at least one, but never all of them.
  const std::size_t most_wrong = written.size() <= 1 ? 0 : std::max<std::size_t>(1, written.size() / 3);
  std::size_t best_distance = most_wrong + 1;
  const std::string* best = nullptr;
  for (const std::string& name : known) {
    if (name.size() > kLongestName || written.size() > kLongestName) continue;
    const std::size_t distance = edit_distance(written, name);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = &name;
  }
  if (best != nullptr) return "did you mean \"" + *best + "\"?";
  if (known.empty()) return "";
  return "known " + std::string(plural) + ": " + joined(known);
}

}  // namespace flatdyn
