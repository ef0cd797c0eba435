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
  bool leaves_out = false;              // entries of its outputs, as a scene says
  bool is_by_itself = true;             // not only of a stage
  std::string stage;                    // whose member it is, if of any: "Configuration"
};

// `text`: of the function by itself.
ShapedFunction shaped(const Function& function, const FunctionText& text, const HeaderScope& scope);

// Which of the functions are members of stages; those that are nothing else are added.
void add_stages(std::vector<ShapedFunction>& functions, const std::vector<StageText>& stages, const HeaderScope& scope);

// Those whose arrays all have entries: C++ has no others. `name_space`: where the functions are.
void write_shapes(kainjow::mustache::data& header, const std::vector<ShapedFunction>& functions,
                  const std::string& name_space);

}  // namespace flatdyn
