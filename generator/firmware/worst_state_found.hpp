// SPDX-License-Identifier: GPL-2.0-or-later
// The state at which a function's rounding errors are largest, of those that a search finds: what a self test has to
// try. Searched as `flatdyn stress` does, but in the text, and with sines that are rounded correctly: found is the same
// on every machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "readback/straight_line.hpp"
#include "reference/expected.hpp"

namespace flatdyn {

// `text`: the function as it is executed, in "float" or "double". `pool`: states within the limits, in numbers of that
// scalar, with values for free symbols. Nothing where the function has no value at any of them.
std::optional<State> worst_state_found(const Function& function, const StraightLine& text, const Expected& expected,
                                       const std::vector<State>& pool, const std::string& scalar);

}  // namespace flatdyn
