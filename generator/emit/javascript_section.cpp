// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/javascript_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emit/page.hpp"
#include "emit/sections.hpp"
#include "emit/writer.hpp"
#include "model/identifiers.hpp"

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

}  // namespace

void write_javascript_function(data& item, const Function& function, const FunctionText& text) {
  std::vector<std::string> comment = function_comment(function, text);
  for (std::string& line : comment) line = with_replaced(line, "*/", "* /");
  item["comment"] = list_of(comment);
  item["types"] = list_of(types(text));
  item["signature"] = without_newline(list_line("function " + text.name + "(", text.parameters, ") {", 0));
}

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

}  // namespace flatdyn
