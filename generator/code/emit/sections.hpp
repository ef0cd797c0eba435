// SPDX-License-Identifier: GPL-2.0-or-later
// Pieces of text that several sections of a header share.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "code/emit/function_text.hpp"

namespace flatdyn {

// The text without its final newline, for a template that has its own.
std::string without_newline(std::string text);

// The comment of a function: its meaning, arguments, result, the inputs that it reads, its cost, and the entries that
// are always zero.
std::vector<std::string> function_comment(const Function& function, const FunctionText& text);

// The comment with the function's meaning only.
std::vector<std::string> brief_comment(const Function& function);

// Fills in the parts of a long body, which come before the function.
void write_parts(kainjow::mustache::data& item, const FunctionText& text);

// Whether an output is an array of arrays, whose structural zeros are worth a constant.
bool is_array_of_arrays(const Output& output);

// An example of a call in a language with the syntax of C, with the declarations of its arguments.
struct ExampleCall {
  std::string function, result;                 // the exported name, and the type returned
  std::string scalar, zeros;                    // "double", and the initialiser that sets an aggregate to zero: "{0}"
  std::string parameters, parameters_argument;  // the type of the free symbols' values; empty if there are none
};
std::vector<std::string> call_example(const FunctionText& text, const ExampleCall& how);

}  // namespace flatdyn
