// SPDX-License-Identifier: GPL-2.0-or-later
// Variants that compute the same bits.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// Results of a variant: its name, the entries, and whether the function has returned true.
struct VariantResult {
  std::string variant;
  std::vector<double> values;
  bool holds = true;
};

// Throws Failure(bug) if the results differ in a bit. Entries that are no numbers count as equal; where the function
// returns false, entries mean nothing.
void check_same_bits(const std::string& function, const VariantResult& a, const VariantResult& b);

}  // namespace flatdyn
