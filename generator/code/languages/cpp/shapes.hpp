// SPDX-License-Identifier: GPL-2.0-or-later
// C++ functions as types that know the shapes of their arguments, for adapters such as flatdyn/eigen.hpp.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "code/emit/function_text.hpp"
#include "code/emit/stage_text.hpp"

namespace flatdyn {

struct ShapedArray {
  std::string name;
  std::size_t length = 0, columns = 0;  // columns: of an array of arrays; else 0
  bool is_output = false;
};

struct ShapedFunction {
  std::string name;                 // "jacobian"
  std::string returns;              // "void"
  bool has_parameters = false;      // whether the first argument is Parameters
  std::vector<ShapedArray> arrays;  // the others, in order
  bool leaves_out = false;          // whether a scene leaves out entries of its outputs
  bool is_by_itself = true;         // whether it exists outside of a stage
  std::string stage;                // the stage that it is a member of, if any: "Configuration"
};

// The argument with its shape: "const Scalar (&q)[7]", "Scalar (&J)[6][7]".
std::string shape_of(const ShapedArray& array);

// The line "using Shape = void(const Scalar (&q)[7], Scalar (&g)[7]);", with `shape` for each array.
std::string shape_line(const ShapedFunction& function, std::string (*shape)(const ShapedArray&));

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
