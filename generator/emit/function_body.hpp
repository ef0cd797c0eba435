// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion of a Function to the statements of its function.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emit/header_scope.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct FunctionBody {
  std::string text;                       // indented lines
  std::string parts;                      // functions that it calls; empty if it is short
  std::vector<Input> inputs;              // the inputs that it reads, without those that an earlier stage has stored
  std::vector<std::string> output_names;  // the outputs' names in the text
  bool uses_sign = false, uses_sqrt = false, uses_excess = false, uses_fma = false, uses_limbs = false;
  bool uses_positions = false;  // whether it reads entries of q other than for their sines and cosines
  std::vector<int> angles;      // indices of the angles whose sines and cosines it takes
  bool takes_sines = false, takes_cosines = false;
  bool is_too_long = false;  // for one function

  bool uses_trigonometry() const { return !angles.empty(); }
};

FunctionBody function_body(const Function& function, const std::string& name, const HeaderScope& scope);

}  // namespace flatdyn
