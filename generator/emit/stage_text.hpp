// SPDX-License-Identifier: GPL-2.0-or-later
// Stages → the text of two structs, and of what makes them.
#pragma once

#include <string>
#include <vector>

#include "emit/function_text.hpp"
#include "emit/stages.hpp"

namespace flatdyn {

struct StageMember {
  Function function;
  FunctionText text;
};

struct StageText {
  std::string name;                  // "Configuration"
  FunctionText make;                 // at(), with()
  std::string operations;            // of make, as counted
  std::vector<StageMember> members;  // without the one that makes the next stage
  std::string fields;                // "Scalar s_2, c_2, x1;", lines of a struct
};

// Configuration, and Motion if there is one. `scope`: of the header; no field is called as anything in it.
std::vector<StageText> stage_texts(Stages stages, const HeaderScope& scope);

}  // namespace flatdyn
