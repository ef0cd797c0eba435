// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/literals.hpp"
#include "code/emit/partial_output.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"
#include "derivation/dynamics/euler_angles.hpp"
#include "graph/count.hpp"
#include "graph/passes/fuse_products.hpp"

namespace flatdyn {

std::string without_newline(std::string text) {
  if (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

bool is_array_of_arrays(const Output& output) {
  return !output.entries.empty() && (output.layout == Layout::matrix || output.layout == Layout::christoffel);
}

namespace {

// The sentence about zeros: " Always zero: 6 of 9 entries of B." or, for a vector, " Always zero: g[0]."
std::string zeros(const Function& function, std::size_t o, const FunctionText& text) {
  const Output& output = function.outputs[o];
  std::string list;
  int count = 0;
  for (std::size_t e = 0; e < output.entries.size() && !text.outputs.empty(); ++e) {
    if (!function.graph.is_zero(output.entries[e]) || output.leaves_out(e)) continue;
    list += fmt::format("{}{}[{}]", count == 0 ? "" : ", ", text.outputs[o].name, e);
    ++count;
  }
  if (count == 0) return "";
  if (!is_array_of_arrays(output)) return " Always zero: " + list + ".";
  return fmt::format(" Always zero: {} of the {} entries of {}.", count, output.entries.size(), text.outputs[o].name);
}

// The meaning of the numbers if the scene asks for angles or for damping.
std::string task_facts(const Task& task) {
  std::string facts;
  if (task.rates_are_of_angles())
    facts += " " + describe_angles(task.orientation) + ". J is the analytical Jacobian, of their rates.";
  if (task.is_damped()) {
    facts += fmt::format(
        " Damped: J B^-1 J^T + lambda^2 1 is inverted, lambda = {}, so that B_A is never larger than 1 / lambda^2; a "
        "force"
        " f on the task accelerates it by lambda^2 f less than B_A says.",
        decimal_literal(task.damping));
  }
  return facts;
}

}  // namespace

std::vector<std::string> brief_comment(const Function& function) {
  const std::string equation = function.equation.empty() ? "" : " " + function.equation;
  return wrapped_words(comment_text(function.summary + equation + "."), kCommentWidth);
}

namespace {

std::string velocity_of(const Function& function) {
  const bool floats = std::find(function.inputs.begin(), function.inputs.end(), InputKind::v) != function.inputs.end();
  return input_argument(with_base(InputKind::qd, floats), 0).name;
}

}  // namespace

std::vector<std::string> function_comment(const Function& function, const FunctionText& text) {
  std::vector<std::string> lines = brief_comment(function);
  for (const std::string& argument : text.arguments) lines.push_back(argument);
  const std::string result = text.result.empty() ? "" : "Returns " + comment_text(text.result) + ".";
  for (const std::string& line : wrapped_words(result, kCommentWidth)) lines.push_back(line);
  std::string facts =
      "Reads " + text.reads + ". Operations: " + to_string(operations_as_written(function, text.uses_fma)) + ".";
  if (function.at_rest) facts += " Holds where " + velocity_of(function) + " = 0, and does not read it.";
  facts += task_facts(function.task);
  facts += partial_output_text(function, text.outputs);
  for (std::size_t o = 0; o < function.outputs.size(); ++o) facts += zeros(function, o, text);
  for (const std::string& line : wrapped_words(facts, kCommentWidth)) lines.push_back(line);
  return lines;
}

void write_parts(kainjow::mustache::data& item, const FunctionText& text) {
  item["parts?"] = !text.parts.empty();
  item["part_of"] = text.name;
  item["parts"] = without_newline(text.parts);
}

std::vector<std::string> call_example(const FunctionText& text, const ExampleCall& how) {
  std::vector<std::string> lines;
  std::string declarations, call = how.parameters.empty() ? "" : how.parameters_argument;
  const auto add = [&](const ArrayArgument& array, const std::string& initial) {
    declarations += fmt::format("{}{}[{}]{}", declarations.empty() ? "" : ", ", array.name,
                                std::max(array.length, decltype(array.length)(1)), initial);
    call += (call.empty() ? "" : ", ") + array.name;
  };
  for (const ArrayArgument& array : text.inputs) add(array, " = " + how.zeros);
  for (const ArrayArgument& array : text.outputs) add(array, "");
  if (!how.parameters.empty()) {
    lines.push_back(fmt::format("{} parameters = {};  // then set its members", how.parameters, how.zeros));
  }
  if (!declarations.empty()) lines.push_back(fmt::format("{} {};", how.scalar, declarations));
  const std::string receiver = how.result == "void" ? "" : "const " + how.result + " result = ";
  lines.push_back(fmt::format("{}{}({});", receiver, how.function, call));
  return lines;
}

}  // namespace flatdyn
