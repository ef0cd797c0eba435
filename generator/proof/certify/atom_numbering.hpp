// SPDX-License-Identifier: GPL-2.0-or-later
// The places of atoms in a vector.
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

namespace flatdyn {

// Numbers atoms in the order in which they appear.
class AtomNumbering {
 public:
  Eigen::Index operator()(int atom) {
    const auto [found, is_new] = place_.emplace(atom, size());
    if (is_new) atoms_.push_back(atom);
    return found->second;
  }
  const std::vector<int>& atoms() const { return atoms_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(atoms_.size()); }

 private:
  std::map<int, Eigen::Index> place_;
  std::vector<int> atoms_;
};

}  // namespace flatdyn
