// SPDX-License-Identifier: GPL-2.0-or-later
// The sections of C code for many states at a time: functions over arrays of states, which call those over lanes.
#pragma once

#include <kainjow/mustache.hpp>

#include "emit/function_text.hpp"

namespace flatdyn {

// Adds names to `page`, which write_c_names() has filled.
void write_batch_names(kainjow::mustache::data& page, const std::vector<Function>& functions, const Dialect& dialect);

// The function takes states as rows and writes results as rows.
void write_batch_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text,
                          const Dialect& dialect);

}  // namespace flatdyn
