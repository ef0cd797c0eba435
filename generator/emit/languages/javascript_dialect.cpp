// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/languages/javascript_dialect.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emit/literals.hpp"
#include "emit/page.hpp"
#include "emit/sections.hpp"
#include "emit/writer.hpp"
#include "model/identifiers.hpp"
#include "templates.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

std::string type_of_argument(const FunctionText& text, const std::string& name) {
  if (name == "parameters") return "Parameters";
  const auto is_output = [&name](const ArrayArgument& output) { return output.name == name; };
  return std::any_of(text.outputs.begin(), text.outputs.end(), is_output) ? "Numbers" : "ArrayLike<number>";
}

// Type annotations for editors, after the text for people.
std::vector<std::string> types(const FunctionText& text) {
  std::vector<std::string> lines;
  for (const std::string& name : text.parameters) {
    lines.push_back(fmt::format("@param {{{}}} {}", type_of_argument(text, name), name));
  }
  if (text.returns != "void") {
    lines.push_back(fmt::format("@returns {{{}}}", text.returns == "bool" ? "boolean" : text.returns));
  }
  return lines;
}

// Lines of an example of a call. `module`: the file's name without extension.
std::vector<std::string> javascript_example(const FunctionText& text, const std::string& module,
                                            const std::vector<std::string>& parameters) {
  const std::string robot = cpp_identifier(module);
  std::vector<std::string> lines = {fmt::format("import * as {} from './{}.js';", robot, comment_text(module))};
  if (!parameters.empty()) {
    std::vector<std::string> members;
    for (const std::string& name : parameters) members.push_back(name + ": 1");
    const std::string list = fmt::format("const parameters = {{{}}};", fmt::join(members, ", "));
    for (const std::string& line : wrapped_words(list, kCommentWidth - 2)) lines.push_back(line);
  }
  for (const auto* arrays : {&text.inputs, &text.outputs}) {
    for (const ArrayArgument& array : *arrays) {
      lines.push_back(fmt::format("const {} = new Float64Array({});", array.name, array.length));
    }
  }
  const char* receiver = text.returns == "void" ? "" : "const result = ";
  lines.push_back(fmt::format("{}{}.{}({});", receiver, robot, text.name, fmt::join(text.parameters, ", ")));
  return lines;
}

}  // namespace

std::vector<std::string> JavascriptDialect::reserved() const {
  return {"Math",        "Float64Array", "Infinity",       "NaN",       "undefined", "null",     "arguments",
          "await",       "debugger",     "eval",           "extends",   "finally",   "function", "implements",
          "import",      "in",           "instanceof",     "interface", "let",       "package",  "super",
          "sin",         "cos",          "sine_of_turned", "typeof",    "var",       "with",     "yield",
          "joint_count", "joint_names",  "parameter_names"};
}

std::string JavascriptDialect::literal(const Rational& value) const { return decimal_literal(value); }

std::string JavascriptDialect::infinity(bool negative) const { return negative ? "-Infinity" : "Infinity"; }

std::string JavascriptDialect::text(const std::string& value) const { return javascript_string(value); }

std::string JavascriptDialect::sign(const std::string& of) const { return "Math.sign(" + of + ")"; }

std::string JavascriptDialect::sqrt(const std::string& of) const { return "Math.sqrt(" + of + ")"; }

std::string JavascriptDialect::angle_function(const std::string& function, int, const std::string& angle) const {
  return fmt::format("{}{}({})", sines_ == Sines::library ? "Math." : "", function, angle);
}

std::string JavascriptDialect::array(const std::string& name, std::size_t length) const {
  return fmt::format("{} = new Float64Array({})", name, length);
}

void JavascriptDialect::declare(FunctionText& text, const UndeclaredFunction& function) const {
  for (const Argument& argument : function.arguments) text.parameters.push_back(argument.name);
}

std::string JavascriptDialect::count_definition(const std::string& name, int value) const {
  return fmt::format("const {} = {};\n", name, value);
}

std::string JavascriptDialect::definition_begin(const ConstantArray& array) const {
  return fmt::format("const {} = [", array.name);
}

std::string JavascriptDialect::check_loop(std::size_t first, std::size_t end, const std::string& check) const {
  return braced_check_loop("let", first, end, check);
}

std::string JavascriptDialect::all_positive(const std::string& array, std::size_t length) const {
  return check_loop(0, length, fmt::format("{}[{}] > {}", array, kCounter, literal(0)));
}

std::vector<FileTemplate> JavascriptDialect::files() const { return {{".js", templates::module_js}}; }

std::string JavascriptDialect::member(const std::string& name, const std::string& unit) const {
  return name + (unit.empty() ? "" : " - " + unit);
}

void JavascriptDialect::write_function(data& item, const Function& function, const FunctionText& text) const {
  std::vector<std::string> comment = function_comment(function, text);
  for (std::string& line : comment) line = with_replaced(line, "*/", "* /");
  item["comment"] = list_of(comment);
  item["types"] = list_of(types(text));
  item["signature"] = without_newline(list_line("function " + text.name + "(", text.parameters, ") {", 0));
}

void JavascriptDialect::write_page(data& page, const CodeContent& content) const {
  const char* const begin = form_ == JavascriptForm::module ? "export {" : "return {";
  page["exports"] = without_newline(list_line(begin, content.exports, "};", 0));
  if (content.texts.empty()) return;
  page["example"] = list_of(javascript_example(content.texts.front(), content.file_name, content.scope.parameters));
}

}  // namespace flatdyn
