// SPDX-License-Identifier: GPL-2.0-or-later
// What a robot's C header and source have of their own, beside what all languages have in common.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "emit/function_text.hpp"

namespace flatdyn {

// Names, the types' own functions of <math.h>, and the literals of rounding_is_as_written().
void write_c_names(kainjow::mustache::data& page, const Dialect& dialect, const std::string& header);

// A declaration with its comment, and the definition, which begins with `linkage`; also of the function that takes
// sines and cosines.
void write_c_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text,
                      const std::string& linkage);

// How a function is called: lines.
std::vector<std::string> c_example(const FunctionText& text, const Dialect& dialect, bool has_parameters);

}  // namespace flatdyn
