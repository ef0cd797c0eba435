// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that flatdyn knows, one row each.
#pragma once

#include <string>
#include <vector>

#include "functions/function_row.hpp"

namespace flatdyn {

// The table, in the order in which functions are emitted.
const std::vector<FunctionRow>& function_table();

// The row of a function, by its name with or without a link ("jacobian", "jacobian:hand"), also of its derivatives
// ("vjp:jacobian"); null if there is none, as for a fused function.
const FunctionRow* find_row(const std::string& name);

// "forward_kinematics, jacobian and jacobian_dot_qd": the functions that can be those of any link.
std::string functions_of_links();

// The row of a function. Throws Failure(bug) if there is none.
const FunctionRow& row_of(const Function& function);

}  // namespace flatdyn
