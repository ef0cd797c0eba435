// SPDX-License-Identifier: GPL-2.0-or-later
// The velocities of floating bases and spherical joints, which are not the derivatives of coordinates. Coordinates x
// around the present pose have ν = A(x) ẋ with A = 1 where they are zero, and ẍ = ν̇ - Ȧ ν.
#pragma once

#include <algorithm>
#include <vector>

#include "robot/model/floating_base.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {

// -Ȧ ν by entry of q̇, over any scalar; zeros for joints whose rates are those of their coordinates.
template <class S>
std::vector<S> velocity_drift(const Mechanism& mechanism, const std::vector<S>& rates) {
  std::vector<S> result(rates.size(), S(0));
  if (mechanism.floating_base) {
    const std::vector<S> base = base_drift(rates);
    std::copy(base.begin(), base.end(), result.begin());
  }
  for (const int first : mechanism.spherical) {
    const auto k = static_cast<std::size_t>(first);
    const std::array<S, 3> drift = spherical_drift(rates[k], rates[k + 1], rates[k + 2]);
    std::copy(drift.begin(), drift.end(), result.begin() + first);
  }
  return result;
}

// A square block of Ȧ, from row and column `first` on.
template <class S>
struct RateBlock {
  int first = 0;
  std::vector<std::vector<S>> entries;
};

// The blocks of Ȧ that are not zero: C = C_x - B Ȧ is the matrix in these velocities of which Ḃ - 2 C is
// skew-symmetric, if C_x is that of the Christoffel symbols of x, (7.44).
template <class S>
std::vector<RateBlock<S>> rate_blocks(const Mechanism& mechanism, const std::vector<S>& rates) {
  std::vector<RateBlock<S>> blocks;
  if (mechanism.floating_base) blocks.push_back({0, base_rate_matrix(rates)});
  for (const int first : mechanism.spherical) {
    const auto k = static_cast<std::size_t>(first);
    blocks.push_back({first, {}});
    for (const auto& row : spherical_rate_matrix(rates[k + 1], rates[k + 2])) {
      blocks.back().entries.emplace_back(row.begin(), row.end());
    }
  }
  return blocks;
}

}  // namespace flatdyn
