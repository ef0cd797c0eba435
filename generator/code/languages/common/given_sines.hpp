// SPDX-License-Identifier: GPL-2.0-or-later
// Functions that need sines and cosines, in languages where such a function is two: one takes them as arguments, and
// the other one computes them and calls it.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "code/emit/function_text.hpp"

namespace flatdyn {

// The declarations of arguments, of a definition or of a declaration apart from it.
using DeclareArguments = std::function<std::vector<std::string>(const std::vector<Argument>&, bool is_definition)>;

// Completes the text of a function, and makes its variant if it needs sines and cosines. `fewest`: whether their arrays
// end with the last one that is read.
void declare_with_given_sines(FunctionText& text, const UndeclaredFunction& function, bool fewest,
                              const DeclareArguments& declared);

// The sentence about the variant: "The same from sine[k] = sin(q[k]) …".
std::string given_sines_comment(const SinCosVariant& given);

// The angles that are needed, as first and last index of each run of consecutive ones.
std::vector<std::pair<int, int>> runs_of(const std::set<int>& angles);

}  // namespace flatdyn
