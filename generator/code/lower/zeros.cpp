// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/zeros.hpp"

#include <utility>

namespace flatdyn {
namespace {

constexpr std::size_t kFewestInARow = 4;  // a register of doubles
constexpr std::size_t kFewestInAll = 16;  // fewer are stored as fast one by one

// The places from number `first` on that are entries of an array, each behind the one before; at least one place.
std::size_t entries_in_a_row(const std::vector<code::Place>& places, std::size_t first) {
  const auto* before = std::get_if<code::Element>(&places[first]);
  std::size_t end = first + 1;
  for (; before != nullptr && end < places.size(); ++end) {
    const auto* next = std::get_if<code::Element>(&places[end]);
    if (next == nullptr || next->array != before->array || next->index != before->index + 1) break;
    before = next;
  }
  return end - first;
}

}  // namespace

code::Statements zeros_together(code::Store store) {
  code::Store others{{}, store.value};
  code::Statements together;
  std::size_t entries = 0;
  for (std::size_t k = 0; k < store.places.size();) {
    const std::size_t count = entries_in_a_row(store.places, k);
    if (count >= kFewestInARow) {
      const auto& [array, index] = std::get<code::Element>(store.places[k]);
      const auto first = static_cast<std::size_t>(index);
      together.emplace_back(code::StoreZeros{array, first, first + count});
      entries += count;
    } else {
      for (std::size_t each = k; each < k + count; ++each) others.places.push_back(store.places[each]);
    }
    k += count;
  }
  if (entries < kFewestInAll) return {std::move(store)};
  if (!others.places.empty()) together.insert(together.begin(), std::move(others));
  return together;
}

}  // namespace flatdyn
