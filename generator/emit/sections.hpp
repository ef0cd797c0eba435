// SPDX-License-Identifier: GPL-2.0-or-later
// Pieces of text that the sections of a header have in common.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "emit/function_text.hpp"

namespace flatdyn {

// Text that ends in a newline, for a template that has its own.
std::string without_newline(std::string text);

// What a function is, its arguments, its result, what it reads and costs, and which entries are always zero.
std::vector<std::string> function_comment(const Function& function, const FunctionText& text);

// What a function is, without the rest.
std::vector<std::string> brief_comment(const Function& function);

// "class Scalar", and the source of sines and cosines if the function asks for any.
std::string template_parameters(const FunctionText& text);

// "inline void gravity(const Scalar* q, Scalar* g) noexcept {"; of a member of `stage`, "… Motion<Scalar>::bias(…
// const". What is declared in a header and defined in a source is not inline.
std::string signature(const FunctionText& text, const std::string& stage = "");

// In C: "void panda_gravity(const double* q, double* g)", and what stands behind it: " {" or ";".
std::string c_signature(const std::string& returns, const std::string& name, const std::vector<std::string>& parameters,
                        const std::string& end);

// The parts of a long body go before the function.
void write_parts(kainjow::mustache::data& item, const FunctionText& text);

// An array of arrays: its structural zeros are worth a constant.
bool is_array_of_arrays(const Output& output);

// How a function is called in C and C++, with the declarations of its arguments.
struct ExampleCall {
  std::string function, result;                 // as it is named from outside, and the type that it returns
  std::string scalar, zeros;                    // "double", and what sets an aggregate to zero: "{0}"
  std::string parameters, parameters_argument;  // type of the free symbols' values; empty: there are none
};
std::vector<std::string> call_example(const FunctionText& text, const ExampleCall& how);

}  // namespace flatdyn
