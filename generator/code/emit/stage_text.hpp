// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion of stages to the text of two structs and of the functions that make them.
#pragma once

#include <string>
#include <vector>

#include "code/emit/function_text.hpp"
#include "code/lower/stages.hpp"

namespace flatdyn {

struct StageMember {
  Function function;
  FunctionText text;
};

struct StageText {
  std::string name;                  // "Configuration"
  FunctionText make;                 // at() or with()
  std::string operations;            // the operation count of `make`, in words
  std::vector<StageMember> members;  // without the one that makes the next stage
  std::string fields;                // lines of a struct: "Scalar s_2, c_2, x1;"
};

// Configuration, and Motion if there is one. `scope`: that of the header; the fields' names differ from all names in
// it.
std::vector<StageText> stage_texts(Stages stages, const HeaderScope& scope);

}  // namespace flatdyn
