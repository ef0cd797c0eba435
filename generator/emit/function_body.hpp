// SPDX-License-Identifier: GPL-2.0-or-later
// One Function → the statements of its function in C++, C or JavaScript.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emit/header_scope.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct FunctionBody {
  std::string text;                       // indented lines
  std::string parts;                      // functions that it calls, in C++ for namespace detail; empty if it is short
  std::vector<Input> inputs;              // that it reads, but for what an earlier stage has stored
  std::vector<std::string> output_names;  // as the outputs are called in it
  bool uses_sign = false, uses_sqrt = false;
  bool uses_positions = false;  // reads entries of q, not only for their sines and cosines
  std::vector<int> angles;      // whose sines and cosines it takes, by index
  bool takes_sines = false, takes_cosines = false;

  bool uses_trigonometry() const { return !angles.empty(); }
};

FunctionBody function_body(const Function& function, const std::string& name, const HeaderScope& scope);

}  // namespace flatdyn
