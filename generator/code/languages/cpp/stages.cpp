// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/stages.hpp"

#include <fmt/format.h>

#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/cpp/function.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

// A call as a user would write it: "here.inertia_matrix(B);".
std::string call(const std::string& receiver, const FunctionText& text) {
  std::string arguments;
  for (const auto* arrays : {&text.inputs, &text.outputs}) {
    for (const ArrayArgument& array : *arrays) arguments += (arguments.empty() ? "" : ", ") + array.name;
  }
  const std::string result = text.returns == "void" ? "" : fmt::format("const auto {}_result = ", text.name);
  return fmt::format("{}{}.{}({});", result, receiver, text.name, arguments);
}

std::vector<std::string> example(const std::vector<StageText>& stages, const std::string& name_space) {
  static const char* const kNames[] = {"here", "moving"};
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const FunctionText& make = stages[k].make;
    const bool first_has_parameters = k == 0 && make.parameters.size() > make.inputs.size() + 1;
    lines.push_back(
        k == 0 ? fmt::format("const auto here = {}::at({}q);", name_space, first_has_parameters ? "parameters, " : "")
               : fmt::format("const auto moving = here.with({});", make.inputs.front().name));
    for (const StageMember& member : stages[k].members) lines.push_back(call(kNames[k], member.text));
  }
  return lines;
}

// The declaration in the struct: "void bias(Scalar* n) const noexcept;".
std::string declaration(const FunctionText& text) {
  const std::vector<std::string>& parameters = is_declared_apart(text) ? text.declared : text.parameters;
  const std::string line = list_line(fmt::format("{}{} {}(", not_to_discard(text.returns), text.returns, text.name),
                                     parameters, ") const noexcept;", kStatementIndent);
  return without_newline(line);
}

std::vector<std::string> comment_of_maker(const StageText& stage) {
  const std::string what = stage.make.name == "at"
                               ? "Computes the terms that depend on positions only and are needed more than once."
                               : "Computes the terms that depend on velocities, too, and are needed more than once.";
  std::vector<std::string> lines = {what};
  for (const std::string& argument : stage.make.arguments) lines.push_back(argument);
  const std::string facts = "Reads " + stage.make.reads + ". Operations: " + stage.operations + ".";
  for (const std::string& line : wrapped_words(facts, kCommentWidth)) lines.push_back(line);
  return lines;
}

data struct_of(const std::vector<StageText>& stages, std::size_t k) {
  static const char* const kComments[] = {"The robot at given positions.",
                                          "The robot at given positions and velocities."};
  data item, declarations(data::type::list);
  const auto declare = [&declarations](const FunctionText& text, const std::vector<std::string>& brief) {
    data line("declaration", declaration(text));
    if (is_declared_apart(text)) line["brief"] = list_of(brief);
    declarations << line;
  };
  for (const StageMember& member : stages[k].members) declare(member.text, brief_comment(member.function));
  if (k + 1 < stages.size()) declare(stages[k + 1].make, {comment_of_maker(stages[k + 1]).front()});
  item["name"] = stages[k].name;
  item["comment"] = std::string(kComments[k]);
  item["declarations"] = data(declarations);
  item["fields?"] = !stages[k].fields.empty();
  item["fields"] = without_newline(stages[k].fields);
  return item;
}

data definition(const FunctionText& text, const std::vector<std::string>& comment, const std::string& stage) {
  data item;
  write_parts(item, text);
  write_template(item, text, stage);
  // If declarations are separate, a member is declared in its struct.
  const bool is_in_header = !is_declared_apart(text) || stage.empty();
  item["in_header?"] = is_in_header;
  item["comment"] = list_of(comment);
  item["header_comment"] = list_of(is_in_header ? comment : std::vector<std::string>{});
  item["asks_scalar?"] = stage.empty();  // a member's scalar is checked when its stage is made
  item["body"] = without_newline(text.body);
  return item;
}

}  // namespace

void write_stages(data& header, const std::vector<StageText>& stages, const std::string& name_space) {
  header["staged?"] = true;
  header["stage_example"] = list_of(example(stages, name_space));
  data structs(data::type::list), definitions(data::type::list);
  for (std::size_t k = stages.size(); k-- > 0;) structs << struct_of(stages, k);
  for (std::size_t k = 0; k < stages.size(); ++k) {
    definitions << definition(stages[k].make, comment_of_maker(stages[k]), k == 0 ? "" : stages[k - 1].name);
    for (const StageMember& member : stages[k].members) {
      definitions << definition(member.text, function_comment(member.function, member.text), stages[k].name);
    }
  }
  header["structs"] = data(structs);
  header["definitions"] = data(definitions);
}

}  // namespace flatdyn
