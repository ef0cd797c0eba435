// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/worst_state.hpp"

#include <algorithm>
#include <random>

namespace flatdyn {
namespace {

constexpr std::size_t kParents = 8;

bool is_worse(const SearchedState& a, const SearchedState& b) { return a.error > b.error; }

}  // namespace

SearchedState worst_state(const std::function<double(const State&)>& error, const std::vector<State>& pool,
                          int evaluations, unsigned seed) {
  std::vector<SearchedState> parents;
  const std::size_t drawn = std::min<std::size_t>(pool.size(), static_cast<std::size_t>(evaluations) / 4 + 1);
  for (std::size_t k = 0; k < drawn; ++k) parents.push_back({pool[k], error(pool[k])});
  std::stable_sort(parents.begin(), parents.end(), is_worse);
  if (parents.size() > kParents) parents.resize(kParents);
  std::mt19937_64 random(seed);
  const auto below = [&random](std::size_t n) { return random() % n; };
  for (int k = static_cast<int>(drawn); k < evaluations; ++k) {
    SearchedState& parent = parents[below(parents.size())];
    State next = child(parent.state, pool[below(pool.size())], random);
    const double found = error(next);
    if (found >= parent.error) parent = {std::move(next), found};
  }
  return *std::min_element(parents.begin(), parents.end(), is_worse);
}

}  // namespace flatdyn
