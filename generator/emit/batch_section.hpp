// SPDX-License-Identifier: GPL-2.0-or-later
// What C code for many states at a time has of its own: functions over arrays of states, around those of lanes.
#pragma once

#include <kainjow/mustache.hpp>

#include "emit/function_text.hpp"

namespace flatdyn {

// `page`: with what write_c_names() has put into it.
void write_batch_names(kainjow::mustache::data& page, const std::vector<Function>& functions, const Dialect& dialect);

// Its states come as rows; results are written as rows.
void write_batch_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text,
                          const Dialect& dialect);

}  // namespace flatdyn
