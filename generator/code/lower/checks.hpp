// SPDX-License-Identifier: GPL-2.0-or-later
// The statements by which a function says whether its result is valid: every pivot is positive, and every entry that it
// has written is a finite number.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "code/lower/expressions.hpp"
#include "code/statement.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// A value that must be positive, with the scale that it is compared with if rounding may cancel it.
struct CheckedPivot {
  NodeId value = 0;
  std::optional<NodeId> scale;
};

// The conditions of the function that do not hold by themselves.
std::vector<CheckedPivot> pivots_to_check(const Function& function);

// The value that must be positive: D_1, or the excess of b_1_1 + D_1 / 64 over b_1_1, which is 0 if rounding loses D_1
// in that sum.
code::Expression checked(const CheckedPivot& pivot, const NodeExpressions& expressions);

// All checks, and the return of the verdict. `outputs`: the arrays that hold the outputs.
code::Statements checks_of(const Function& function, const std::vector<std::string>& outputs,
                           const NodeExpressions& expressions);

// The same for a function in parts, which have stored what must be positive in an array of this name and length.
code::Statements checks_of_parts(const Function& function, const std::vector<std::string>& outputs,
                                 const std::string& pivots, std::size_t length);

}  // namespace flatdyn
