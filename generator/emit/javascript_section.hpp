// SPDX-License-Identifier: GPL-2.0-or-later
// What a robot's JavaScript has of its own, beside what all languages have in common.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "emit/function_text.hpp"

namespace flatdyn {

// The head of a function, with its comment and the types that editors read from it.
void write_javascript_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text);

// How a function is called: lines. `module`: the file, without what follows the dot.
std::vector<std::string> javascript_example(const FunctionText& text, const std::string& module,
                                            const std::vector<std::string>& parameters);

}  // namespace flatdyn
