// SPDX-License-Identifier: GPL-2.0-or-later
#include "languages/cpp/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emit/sections.hpp"
#include "emit/writer.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

std::string input_of(const ArrayArgument& array) {
  return fmt::format("const Scalar (&{})[{}]", array.name, array.length);
}

std::string output_of(const ArrayArgument& array, const Output& output) {
  if (!is_array_of_arrays(output)) return fmt::format("Scalar (&{})[{}]", array.name, array.length);
  const auto columns = static_cast<std::size_t>(output.cols);
  return fmt::format("Scalar (&{})[{}][{}]", array.name, array.length / columns, columns);
}

// A function with a single call, on one line if it fits.
std::string calling(const std::string& parameters, const std::string& callee) {
  const std::string head =
      fmt::format("  [[gnu::always_inline]] auto operator()({}Of&&... of) const noexcept {{", parameters);
  const std::string statement = fmt::format("return {}(of...);", callee);
  const std::string line = head + " " + statement + " }";
  return line.size() <= kLineWidth ? line : head + "\n    " + statement + "\n  }";
}

// Whether the parameter is an array of length 0, which C++ does not have.
bool is_empty(const std::string& parameter) { return parameter.find("[0]") != std::string::npos; }

}  // namespace

ShapedFunction shaped(const Function& function, const FunctionText& text, const HeaderScope& scope) {
  ShapedFunction result{text.name, text.returns, {}, !is_whole(function), true, ""};
  if (!scope.parameters.empty()) result.parameters.emplace_back("const Parameters<Scalar>&");
  for (const ArrayArgument& input : text.inputs) result.parameters.push_back(input_of(input));
  for (std::size_t k = 0; k < text.outputs.size(); ++k) {
    result.parameters.push_back(output_of(text.outputs[k], function.outputs[k]));
  }
  return result;
}

bool has_shape(const ShapedFunction& function) {
  return std::none_of(function.parameters.begin(), function.parameters.end(), is_empty);
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
    item["shape"] = without_newline(
        list_line(fmt::format("using Shape = {}(", function.returns), function.parameters, ");", kStatementIndent));
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
