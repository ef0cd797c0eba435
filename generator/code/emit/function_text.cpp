// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/function_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "code/emit/argument_text.hpp"
#include "code/emit/printer.hpp"
#include "code/lower/arguments.hpp"
#include "code/lower/body.hpp"
#include "code/lower/kernel_parts.hpp"

namespace flatdyn {

namespace {

// The outputs of which the function, a part for a kernel, reads entries.
std::set<int> outputs_read(const Function& function) {
  std::set<int> outputs;
  for (const Input& input : inputs_read(function)) {
    if (input.kind == InputKind::stored) outputs.insert(entry_read(function, input.index).output);
  }
  return outputs;
}

class FunctionWriter {
 public:
  FunctionWriter(const Function& function, const std::string& name, const HeaderScope& scope)
      : function_(function),
        name_(name),
        scope_(scope),
        dialect_(scope.dialect),
        printer_(scope),
        body_(function_body(function, name, scope)),
        statements_(printer_.text(body_.statements)) {
    if (std::count(statements_.begin(), statements_.end(), '\n') <= body_.most_lines) return;
    body_ = divided_body(function, name, scope, printer_);
    statements_ = printer_.text(body_.statements);
  }

  FunctionText text(const std::string& sin_cos_variant_name) const {
    FunctionText text;
    text.name = name_;
    text.returns = return_type();
    text.inputs = input_arrays();
    text.outputs = output_arrays();
    text.arguments = argument_lines(argument_rows());
    text.reads = reads_text();
    text.result = result_text();
    text.body = statements_;
    for (const code::Part& part : body_.parts) {
      text.parts += (text.parts.empty() ? "" : "\n") + (dialect_.before_part() + printer_.text(part));
    }
    text.uses_sign = body_.uses_sign;
    text.uses_sqrt = body_.uses_sqrt;
    text.uses_excess = body_.uses_excess;
    text.uses_fma = body_.uses_fma;
    text.uses_limbs = body_.uses_limbs;
    text.uses_zeros = body_.uses_zeros;
    text.uses_trigonometry = body_.uses_trigonometry();
    text.computes_sines = computes_angles(function_);
    dialect_.declare(text, {body_, scope_, arguments(), sin_cos_variant_name});
    return text;
  }

 private:
  std::string reads_text() const {
    const std::string inputs = list_of_inputs(body_.inputs, scope_.parameters, dialect_);
    if (scope_.stored.empty()) return inputs + entries_read_text();
    return (body_.inputs.empty() ? "" : inputs + " and ") + "what is stored";
  }

  // The outputs of which an earlier part's entries are read: " and dqdd_dtau, which an earlier part has written".
  std::string entries_read_text() const {
    std::string names;
    for (const int output : outputs_read(function_)) {
      names += (names.empty() ? "" : ", ") + body_.output_names[static_cast<std::size_t>(output)];
    }
    return names.empty() ? "" : fmt::format(", and of {} what an earlier part has written", names);
  }

  std::vector<Argument> arguments() const {
    std::vector<Argument> list;
    if (!scope_.parameters.empty()) {
      list.push_back({Argument::Kind::parameters, "parameters", reads(InputKind::parameter)});
    }
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, scope_.counts, function_);
      list.push_back({Argument::Kind::input, argument.name, reads(kind), static_cast<std::size_t>(argument.length)});
    }
    const std::set<int> read = scope_.stored.empty() ? outputs_read(function_) : std::set<int>();
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_) && !makes_stage(); ++k) {
      const Output& output = function_.outputs[k];
      const bool is_used = output.is_written() || read.count(static_cast<int>(k)) != 0;
      list.push_back({Argument::Kind::output, body_.output_names[k], is_used, output.entries.size(),
                      output.layout == Layout::scalar});
    }
    return list;
  }

  bool makes_stage() const { return !scope_.made.empty(); }

  std::string return_type() const {
    if (makes_stage()) return dialect_.stage_type(scope_.made);
    return returns_value(function_)                ? dialect_.scalar()
           : function_.validity_conditions.empty() ? "void"
                                                   : dialect_.condition_type();
  }

  bool reads(InputKind kind) const {
    return std::any_of(body_.inputs.begin(), body_.inputs.end(),
                       [kind](const Input& input) { return input.kind == kind; });
  }

  std::vector<ArrayArgument> input_arrays() const {
    std::vector<ArrayArgument> arrays;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, scope_.counts, function_);
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

  std::vector<std::array<std::string, 3>> argument_rows() const {
    std::vector<std::array<std::string, 3>> rows;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, scope_.counts, function_);
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
    return rows;
  }

  // The matrices whose pivots are asked for, after "a pivot of".
  std::string inverted_text() const {
    if (!function_.inverted.empty()) return function_.inverted;
    return function_.task.empty() ? "B" : "B" + task_conditions_text();
  }

  // The conditions of the task, after "B".
  std::string task_conditions_text() const {
    const Task& task = function_.task;
    const char* const of_angles = task.orientation == Orientation::zyz ? ", or sin(theta)," : ", or cos(theta),";
    return fmt::format(" or of J B^-1 J^T{}{}", task.is_damped() ? " + lambda^2 1" : "",
                       task.rates_are_of_angles() ? of_angles : "");
  }

  std::string result_text() const {
    if (returns_value(function_)) {
      const Output& output = function_.outputs[0];
      return output.name + (output.meaning.empty() ? "" : ": " + output.meaning);
    }
    if (function_.validity_conditions.empty()) return "";
    const bool asks_loops = function_.loop_conditions > 0;
    const bool asks_pivots = function_.validity_conditions.size() > static_cast<std::size_t>(function_.loop_conditions);
    const char* const lost = compares_pivots(function_) ? "not positive or lost in rounding" : "not positive";
    return fmt::format("false if the result means nothing: if {}{}an entry of the result is not a finite number{}",
                       asks_loops ? "a closed loop is within 1e-6 of being singular (6e-5 in float), or " : "",
                       asks_pivots ? fmt::format("a pivot of {} is {}, or ", inverted_text(), lost) : "",
                       proven_text());
  }

  std::string proven_text() const {
    const double share = function_.proven_pivot_share;
    if (share == 0) return "";
    return fmt::format(
        ". Proven: {} each pivot of {} is at least {:.2g} of the size of its terms, so that rounding cannot cancel it",
        scope_.proven_positions, function_.inverted.empty() ? "B" : "it", share);
  }

  const Function& function_;
  const std::string& name_;
  const HeaderScope& scope_;
  const Dialect& dialect_;
  Printer printer_;
  FunctionBody body_;
  std::string statements_;  // of the body
};

}  // namespace

bool can_be_launched(const FunctionText& text) {
  return std::all_of(text.outputs.begin(), text.outputs.end(),
                     [](const ArrayArgument& each) { return each.length > 0; });
}

FunctionText function_text(const Function& function, const std::string& name, const HeaderScope& scope,
                           const std::string& sin_cos_variant_name) {
  return FunctionWriter(function, name, scope).text(sin_cos_variant_name);
}

}  // namespace flatdyn
