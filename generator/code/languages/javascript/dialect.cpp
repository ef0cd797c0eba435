// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/javascript/dialect.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/literals.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "robot/model/identifiers.hpp"
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

// The statement that refuses arrays of other lengths: "if (q.length !== 7 || g.length !== 7) {".
std::string check_of_lengths(const std::string& function, const std::vector<Argument>& arguments) {
  std::string condition, line = "  if (";
  std::vector<std::string> names, lengths;
  int inputs = 0;
  for (const Argument& argument : arguments) {
    if (argument.kind == Argument::Kind::parameters) continue;
    inputs += argument.kind == Argument::Kind::input ? 1 : 0;
    const std::string part =
        fmt::format("{}{}.length !== {}", names.empty() ? "" : "|| ", argument.name, argument.length);
    const bool fits = line.size() + part.size() + 2 <= kLineWidth;  // with the bracket and the brace
    if (!names.empty() && !fits) {
      condition += line + "\n";
      line = std::string(2 * kStatementIndent, ' ') + part;
    } else {
      line += (names.empty() ? "" : " ") + part;
    }
    names.push_back(argument.name);
    lengths.push_back(std::to_string(argument.length));
  }
  if (names.empty()) return "";
  return condition + line + ") {\n" +
         list_line(fmt::format("check_lengths('{}', {{", function), names,
                   fmt::format("}}, [{}], {});", fmt::join(lengths, ", "), inputs), 2 * kStatementIndent) +
         code_line("}", kStatementIndent);
}

// Lines such as "export declare function gravity(q: ArrayLike<number>, g: Numbers): void;".
std::string typescript_declaration(const FunctionText& text) {
  std::vector<std::string> parameters;
  for (const std::string& name : text.parameters) {
    parameters.push_back(fmt::format("{}: {}", name, type_of_argument(text, name)));
  }
  const std::string returns = text.returns == "bool" ? "boolean" : text.returns;
  return without_newline(list_line("export declare function " + text.name + "(", parameters, "): " + returns + ";", 0));
}

}  // namespace

std::vector<std::string> JavascriptDialect::reserved() const {
  return {"Math",
          "Float64Array",
          "Infinity",
          "NaN",
          "undefined",
          "null",
          "arguments",
          "await",
          "debugger",
          "eval",
          "extends",
          "finally",
          "function",
          "implements",
          "import",
          "in",
          "instanceof",
          "interface",
          "let",
          "package",
          "super",
          "sin",
          "cos",
          "sine_of_turned",
          "typeof",
          "var",
          "with",
          "yield",
          "joint_count",
          "joint_names",
          "parameter_names",
          "check_lengths",
          "Object",
          "RangeError"};
}

std::string JavascriptDialect::literal(const Rational& value) const { return decimal_literal(value); }

std::string JavascriptDialect::infinity(bool negative) const { return negative ? "-Infinity" : "Infinity"; }

std::string JavascriptDialect::text(const std::string& value) const { return javascript_string(value); }

std::string JavascriptDialect::sign(const std::string& of) const { return "Math.sign(" + of + ")"; }

std::string JavascriptDialect::sqrt(const std::string& of) const { return "Math.sqrt(" + of + ")"; }

std::string JavascriptDialect::angle_function(const std::string& function, const std::string& angle) const {
  return fmt::format("{}{}({})", sines_ == Sines::library ? "Math." : "", function, angle);
}

std::string JavascriptDialect::array(const std::string& name, const std::string& length) const {
  return fmt::format("{} = new Float64Array({})", name, length);
}

void JavascriptDialect::declare(FunctionText& text, const UndeclaredFunction& function) const {
  for (const Argument& argument : function.arguments) text.parameters.push_back(argument.name);
  if (form_ == JavascriptForm::module) text.body = check_of_lengths(text.name, function.arguments) + text.body;
}

std::string JavascriptDialect::count_definition(const std::string& name, int value) const {
  return fmt::format("const {} = {};\n", name, value);
}

std::string JavascriptDialect::definition_begin(const code::Table& table) const {
  return fmt::format("const {} = [", table.name);
}

std::vector<FileTemplate> JavascriptDialect::files() const {
  if (form_ == JavascriptForm::types) return {{".d.ts", templates::module_d_ts}};
  return {{".js", templates::module_js}};
}

std::string JavascriptDialect::member(const std::string& name, const std::string& unit) const {
  if (form_ == JavascriptForm::types) return name + ": number;" + (unit.empty() ? "" : "  // " + unit);
  return name + (unit.empty() ? "" : " - " + unit);
}

void JavascriptDialect::write_function(data& item, const Function& function, const FunctionText& text) const {
  std::vector<std::string> comment = function_comment(function, text);
  for (std::string& line : comment) line = with_replaced(line, "*/", "* /");
  item["comment"] = list_of(comment);
  item["types"] = list_of(types(text));
  item["declaration"] = typescript_declaration(text);
  item["signature"] = without_newline(list_line("function " + text.name + "(", text.parameters, ") {", 0));
}

// The constants that a module exports, with their types.
void JavascriptDialect::write_types(data& page, const CodeContent& content) const {
  data list(data::type::list);
  for (const std::string& name : content.exports) {
    const bool is_function =
        name == "close_loops" || std::any_of(content.texts.begin(), content.texts.end(),
                                             [&name](const FunctionText& text) { return text.name == name; });
    if (is_function) continue;
    data item;
    item["name"] = name;
    item["type"] = std::string(name.ends_with("_count")   ? "number"
                               : name.ends_with("_names") ? "readonly string[]"
                                                          : "readonly number[]");
    list << item;
  }
  page["module"] = comment_text(content.file_name);
  page["constants_exported"] = data(list);
}

void JavascriptDialect::write_page(data& page, const CodeContent& content) const {
  write_types(page, content);
  page["checks_lengths?"] = form_ == JavascriptForm::module && !content.texts.empty();
  page["has_licence?"] = form_ == JavascriptForm::module;
  const char* const begin = form_ == JavascriptForm::module ? "export {" : "return {";
  page["exports"] = without_newline(list_line(begin, content.exports, "};", 0));
  if (content.texts.empty()) return;
  page["example"] = list_of(javascript_example(content.texts.front(), content.file_name, content.scope.parameters));
}

}  // namespace flatdyn
