// SPDX-License-Identifier: GPL-2.0-or-later
// A search for the state at which a function's rounding errors are largest, for a self test. It works like `flatdyn
// stress`, but executes the text, with correctly rounded sines, so the result is the same on every machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/readback/straight_line.hpp"
#include "functions/deviation/expected.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// `text`: the function as executed, in "float" or "double". `pool`: states within the limits, in numbers of that
// scalar, with values of free symbols. None if the function has no value at any of them.
std::optional<State> worst_state_found(const Function& function, const StraightLine& text, const Expected& expected,
                                       const std::vector<State>& pool, const std::string& scalar);

}  // namespace flatdyn
