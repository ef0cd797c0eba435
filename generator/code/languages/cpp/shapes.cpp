// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

// A function with a single call, on one line if it fits.
std::string calling(const std::string& parameters, const std::string& callee) {
  const std::string head =
      fmt::format("  [[gnu::always_inline]] auto operator()({}Of&&... of) const noexcept {{", parameters);
  const std::string statement = fmt::format("return {}(of...);", callee);
  const std::string line = head + " " + statement + " }";
  return line.size() <= kLineWidth ? line : head + "\n    " + statement + "\n  }";
}

}  // namespace

std::string shape_of(const ShapedArray& array) {
  const char* const begin = array.is_output ? "Scalar" : "const Scalar";
  if (array.columns == 0) return fmt::format("{} (&{})[{}]", begin, array.name, array.length);
  return fmt::format("{} (&{})[{}][{}]", begin, array.name, array.length / array.columns, array.columns);
}

std::string shape_line(const ShapedFunction& function, std::string (*shape)(const ShapedArray&)) {
  std::vector<std::string> list;
  if (function.has_parameters) list.emplace_back("const Parameters<Scalar>&");
  for (const ShapedArray& each : function.arrays) list.push_back(shape(each));
  return without_newline(list_line(fmt::format("using Shape = {}(", function.returns), list, ");", kStatementIndent));
}

ShapedFunction shaped(const Function& function, const FunctionText& text, const HeaderScope& scope) {
  ShapedFunction result{text.name, text.returns, !scope.parameters.empty(), {}, !is_whole(function), true, ""};
  for (const ArrayArgument& input : text.inputs) result.arrays.push_back({input.name, input.length});
  for (std::size_t k = 0; k < text.outputs.size(); ++k) {
    const Output& output = function.outputs[k];
    const int columns = is_array_of_arrays(output) ? output.cols : 0;
    result.arrays.push_back({text.outputs[k].name, text.outputs[k].length, static_cast<std::size_t>(columns), true});
  }
  return result;
}

bool has_shape(const ShapedFunction& function) {
  return std::none_of(function.arrays.begin(), function.arrays.end(),
                      [](const ShapedArray& array) { return array.length == 0; });
}

void add_stages(std::vector<ShapedFunction>& functions, const std::vector<StageText>& stages,
                const HeaderScope& scope) {
  for (const StageText& stage : stages) {
    for (const StageMember& member : stage.members) {
      const auto is_same = [&member](const ShapedFunction& function) { return function.name == member.text.name; };
      auto found = std::find_if(functions.begin(), functions.end(), is_same);
      if (found == functions.end()) {
        HeaderScope without_parameters = scope;
        without_parameters.parameters.clear();
        functions.push_back(shaped(member.function, member.text, without_parameters));
        found = functions.end() - 1;
        found->is_by_itself = false;
      }
      found->stage = stage.name;
    }
  }
}

void write_shapes(data& header, const std::vector<ShapedFunction>& functions, const std::string& name_space) {
  data shapes(data::type::list);
  bool any = false;
  for (const ShapedFunction& function : functions) {
    if (!has_shape(function)) continue;
    any = true;
    data item;
    item["name"] = function.name;
    item["shape"] = shape_line(function, shape_of);
    item["leaves_out?"] = function.leaves_out;
    item["by_itself?"] = function.is_by_itself;
    item["of_stage?"] = !function.stage.empty();
    item["call"] = calling("", "::" + name_space + "::" + function.name);
    item["call_of_stage"] = calling(fmt::format("const {}<Scalar>& stage, ", function.stage), "stage." + function.name);
    shapes << item;
  }
  header["shaped?"] = any;
  header["shapes"] = data(shapes);
}

}  // namespace flatdyn
