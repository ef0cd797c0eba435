// SPDX-License-Identifier: GPL-2.0-or-later
#include "stress/worst_state.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace flatdyn {
namespace {

constexpr std::size_t kParents = 8;
constexpr std::size_t kLeastExponent = 45;  // of the part 2^-k of the way to another state

class Mutation {
 public:
  Mutation(const std::vector<State>& pool, unsigned seed) : pool_(pool), engine_(seed) {}

  State child(const State& parent) {
    const State& other = pool_[below(pool_.size())];
    // Few coordinates, or many.
    const std::size_t one_in = std::size_t(1) << below(6);
    const double part = std::ldexp(1.0, -static_cast<int>(below(kLeastExponent)));
    State child = parent;
    for (const InputKind kind : kMotionKinds) {
      std::vector<double>& x = child.of(kind);
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (below(one_in) == 0) x[i] += part * (other.of(kind)[i] - x[i]);
      }
    }
    return child;
  }

  std::size_t below(std::size_t n) { return engine_() % n; }

 private:
  const std::vector<State>& pool_;
  std::mt19937_64 engine_;
};

bool is_worse(const SearchedState& a, const SearchedState& b) { return a.error > b.error; }

}  // namespace

SearchedState worst_state(const std::function<double(const State&)>& error, const std::vector<State>& pool,
                          int evaluations, unsigned seed) {
  std::vector<SearchedState> parents;
  const std::size_t drawn = std::min<std::size_t>(pool.size(), static_cast<std::size_t>(evaluations) / 4 + 1);
  for (std::size_t k = 0; k < drawn; ++k) parents.push_back({pool[k], error(pool[k])});
  std::stable_sort(parents.begin(), parents.end(), is_worse);
  if (parents.size() > kParents) parents.resize(kParents);
  Mutation mutation(pool, seed);
  for (int k = static_cast<int>(drawn); k < evaluations; ++k) {
    SearchedState& parent = parents[mutation.below(parents.size())];
    State child = mutation.child(parent.state);
    const double found = error(child);
    if (found >= parent.error) parent = {std::move(child), found};
  }
  return *std::min_element(parents.begin(), parents.end(), is_worse);
}

}  // namespace flatdyn
