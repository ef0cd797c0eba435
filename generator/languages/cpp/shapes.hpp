// SPDX-License-Identifier: GPL-2.0-or-later
// C++ functions as types that know the shapes of their arguments, for adapters such as flatdyn/eigen.hpp.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "emit/function_text.hpp"
#include "emit/stage_text.hpp"

namespace flatdyn {

struct ShapedFunction {
  std::string name;                     // "jacobian"
  std::string returns;                  // "void"
  std::vector<std::string> parameters;  // "const Scalar (&q)[7]", "Scalar (&J)[6][7]"
  bool leaves_out = false;              // whether a scene leaves out entries of its outputs
  bool is_by_itself = true;             // whether it exists outside of a stage
  std::string stage;                    // the stage that it is a member of, if any: "Configuration"
};

// `text`: that of the function outside of stages.
ShapedFunction shaped(const Function& function, const FunctionText& text, const HeaderScope& scope);

// Whether its arrays all have entries: C++ has no empty ones.
bool has_shape(const ShapedFunction& function);

// Marks the functions that are members of stages, and adds those that are members only.
void add_stages(std::vector<ShapedFunction>& functions, const std::vector<StageText>& stages, const HeaderScope& scope);

// Writes the functions whose arrays all have entries, as C++ has no empty arrays. `name_space`: that of the functions.
void write_shapes(kainjow::mustache::data& header, const std::vector<ShapedFunction>& functions,
                  const std::string& name_space);

}  // namespace flatdyn
