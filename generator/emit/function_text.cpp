// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/function_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/table.hpp"
#include "emit/arguments.hpp"
#include "emit/function_body.hpp"

namespace flatdyn {

namespace {

class FunctionWriter {
 public:
  FunctionWriter(const Function& function, const std::string& name, const HeaderScope& scope)
      : function_(function), name_(name), scope_(scope), body_(function_body(function, name, scope)) {}

  FunctionText text() const {
    FunctionText text;
    text.name = name_;
    text.returns = return_type();
    text.parameters = parameters();
    text.inputs = input_arrays();
    text.outputs = output_arrays();
    text.arguments = argument_lines();
    text.reads = reads_text();
    text.result = result_text();
    text.body = body_.text;
    text.parts = body_.parts;
    text.uses_sign = body_.uses_sign;
    text.uses_trigonometry = body_.uses_trigonometry;
    return text;
  }

 private:
  std::string reads_text() const {
    if (scope_.stored.empty()) return list_of_inputs(body_.inputs, scope_.parameters);
    return (body_.inputs.empty() ? "" : list_of_inputs(body_.inputs, scope_.parameters) + " and ") + "what is stored";
  }

  bool makes_stage() const { return !scope_.made.empty(); }

  std::string return_type() const {
    if (makes_stage()) return scope_.made + "<Scalar>";
    return returns_value(function_) ? "Scalar" : function_.positive.empty() ? "void" : "bool";
  }

  bool reads(InputKind kind) const {
    return std::any_of(body_.inputs.begin(), body_.inputs.end(),
                       [kind](const Input& input) { return input.kind == kind; });
  }

  // An argument that is not read has no name, so that no compiler complains.
  static std::string parameter(const std::string& type, const std::string& name, bool used) {
    return type + " " + (used ? name : "/* " + name + " */");
  }

  std::vector<std::string> parameters() const {
    std::vector<std::string> list;
    if (!scope_.parameters.empty()) {
      list.push_back(parameter("const Parameters<Scalar>&", "parameters", reads(InputKind::parameter)));
    }
    for (InputKind kind : function_.inputs) {
      list.push_back(parameter("const Scalar*", input_argument(kind, 0).name, reads(kind)));
    }
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_) && !makes_stage(); ++k) {
      list.push_back(parameter("Scalar*", body_.output_names[k], function_.outputs[k].is_written()));
    }
    if (body_.uses_trigonometry) list.emplace_back("const SinCos& sin_cos = {}");
    return list;
  }

  std::vector<ArrayArgument> input_arrays() const {
    std::vector<ArrayArgument> arrays;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, scope_.joints, function_.base_parameters);
      arrays.push_back({argument.name, static_cast<std::size_t>(argument.length)});
    }
    return arrays;
  }

  std::vector<ArrayArgument> output_arrays() const {
    std::vector<ArrayArgument> arrays;
    if (returns_value(function_) || makes_stage()) return arrays;
    for (std::size_t k = 0; k < function_.outputs.size(); ++k) {
      arrays.push_back({body_.output_names[k], function_.outputs[k].entries.size()});
    }
    return arrays;
  }

  std::vector<std::string> argument_lines() const {
    std::vector<std::vector<std::string>> rows;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, scope_.joints, function_.base_parameters);
      rows.push_back({fmt::format("{}[{}]", argument.name, argument.length), "in", argument.meaning});
    }
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_) && !makes_stage(); ++k) {
      const Output& output = function_.outputs[k];
      rows.push_back({fmt::format("{}[{}]", body_.output_names[k], output.entries.size()), "out", output.meaning});
      Output renamed = output;
      renamed.name = body_.output_names[k];
      const std::string layout = layout_text(renamed);
      if (!layout.empty()) rows.push_back({"", "", layout});
    }
    return aligned_lines(rows);
  }

  std::string result_text() const {
    if (returns_value(function_)) {
      const Output& output = function_.outputs[0];
      return output.name + (output.meaning.empty() ? "" : ": " + output.meaning);
    }
    if (function_.positive.empty()) return "";
    return "false if the result means nothing, because a pivot of B is not positive or not a number";
  }

  const Function& function_;
  const std::string& name_;
  const HeaderScope& scope_;
  FunctionBody body_;
};

}  // namespace

FunctionText function_text(const Function& function, const std::string& name, const HeaderScope& scope) {
  return FunctionWriter(function, name, scope).text();
}

}  // namespace flatdyn
