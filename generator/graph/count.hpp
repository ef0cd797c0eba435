// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "graph/function.hpp"

namespace flatdyn {

// The operations of one evaluation, each node counted once. Sign changes are free; a coefficient other than 1 and -1 is
// a multiplication; a power x^k is k - 1 multiplications.
struct OperationCount {
  int additions = 0;  // additions and subtractions
  int multiplications = 0;
  int divisions = 0;      // divisions and square roots, which take a processor as long
  int trigonometric = 0;  // sines and cosines, counted one by one
  int fused = 0;          // fused multiply-adds, which are counted neither as additions nor as multiplications

  int arithmetic() const { return additions + multiplications + fused; }
  bool operator==(const OperationCount&) const = default;
};

OperationCount count_operations(const Function& function);

// The number of entries of the outputs that the function writes: all but those that are left out.
int count_written_entries(const Function& function);
// Those of them that are zero at every state.
int count_written_zeros(const Function& function);

std::string to_string(const OperationCount& count);  // "314 mul, 309 add, 14 sin/cos"

}  // namespace flatdyn
