// SPDX-License-Identifier: GPL-2.0-or-later
// Function → the statements of its function, before any language.
#pragma once

#include <string>
#include <vector>

#include "code/lower/scope.hpp"
#include "code/statement.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct FunctionBody {
  code::Statements statements;
  std::vector<code::Part> parts;          // functions that it calls; none if it is short
  std::vector<Input> inputs;              // the inputs that it reads, without those that an earlier stage has stored
  std::vector<std::string> output_names;  // the outputs' names in the text
  bool uses_sign = false, uses_sqrt = false, uses_excess = false, uses_fma = false, uses_limbs = false,
       uses_zeros = false;
  bool uses_positions = false;  // whether it reads entries of q other than for their sines and cosines
  std::vector<int> angles;      // indices of the angles whose sines and cosines it takes
  bool takes_sines = false, takes_cosines = false;
  int most_lines = 0;  // longer ones are divided

  bool uses_trigonometry() const { return !angles.empty(); }
};

FunctionBody function_body(const Function& function, const std::string& name, const Scope& scope);

// The same in parts, if that is too long. Limbs are then computed one by one.
FunctionBody divided_body(const Function& function, const std::string& name, const Scope& scope,
                          const TextLength& length);

}  // namespace flatdyn
