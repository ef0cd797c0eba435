// SPDX-License-Identifier: GPL-2.0-or-later
// The sections that only a robot's C header and source have.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "emit/function_text.hpp"

namespace flatdyn {

// Fills in names, the scalar's functions of <math.h>, and the literals of rounding_is_as_written().
void write_c_names(kainjow::mustache::data& page, const Dialect& dialect, const std::string& header);

// A declaration with its comment, and the definition, which begins with `linkage`; the same for the variant that takes
// sines and cosines.
void write_c_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text,
                      const std::string& linkage);

// Lines of an example of a call.
std::vector<std::string> c_example(const FunctionText& text, const Dialect& dialect, bool has_parameters);

}  // namespace flatdyn
