// SPDX-License-Identifier: GPL-2.0-or-later
// The arguments of emitted functions in comments.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "code/emit/dialect.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// The expression that reads an input: "qd[1]", "parameters.m1".
std::string access_of_input(const Input& input, const std::vector<std::string>& parameters, const Dialect& dialect);

// The inputs as a list: "q[1..6], qd[0..6], parameters.m1"; "nothing" if there are none.
std::string list_of_inputs(const std::vector<Input>& inputs, const std::vector<std::string>& parameters,
                           const Dialect& dialect);

// The memory layout of an output in words: "7 x 7, row by row".
std::string layout_text(const Output& output);

// The lines of a comment about arguments, a row for each: its name, "in" or "out", its meaning. Columns are aligned,
// and a long meaning goes on in further lines.
std::vector<std::string> argument_lines(const std::vector<std::array<std::string, 3>>& rows);

}  // namespace flatdyn
