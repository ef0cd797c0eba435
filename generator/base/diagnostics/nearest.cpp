// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace flatdyn {

namespace {

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

// The number of insertions, deletions and replacements of a character, and exchanges of two neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({last[j] + (a[i] == b[j] ? 0 : 1), row[j] + 1, last[j + 1] + 1});
      const bool is_exchanged = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (is_exchanged) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

// Letters of another case alone are no difference.
std::size_t distance_of(std::string_view written, const std::string& name) {
  return in_small_letters(written) == in_small_letters(name) ? 0 : edit_distance(written, name);
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
    const std::size_t distance = distance_of(written, name);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = &name;
  }
  if (best != nullptr) return "did you mean \"" + *best + "\"?";
  if (known.empty()) return "";
  return "known " + std::string(plural) + ": " + joined(known);
}

std::string hint_for_abbreviated(std::string_view written, const std::vector<std::string>& known,
                                 std::string_view plural) {
  constexpr std::size_t kFewestLetters = 3;
  const std::string* shortest = nullptr;
  for (const std::string& name : known) {
    const bool is_begun = written.size() >= kFewestLetters && name.starts_with(written);
    if (is_begun && (shortest == nullptr || name.size() < shortest->size())) shortest = &name;
  }
  if (shortest != nullptr) return "did you mean \"" + *shortest + "\"?";
  return hint_for_unknown(written, known, plural);
}

}  // namespace flatdyn
