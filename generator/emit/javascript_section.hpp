// SPDX-License-Identifier: GPL-2.0-or-later
// The sections that only a robot's JavaScript has.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "emit/function_text.hpp"

namespace flatdyn {

// Fills in the head of a function, with its comment and the types that editors read from it.
void write_javascript_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text);

// Lines of an example of a call. `module`: the file's name without extension.
std::vector<std::string> javascript_example(const FunctionText& text, const std::string& module,
                                            const std::vector<std::string>& parameters);

}  // namespace flatdyn
