// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/known_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "emit/writer.hpp"
#include "lower/arguments.hpp"

namespace flatdyn {
namespace {

constexpr const char *kResults = "result", *kSymbols = "symbol", *kGiven = "given";

class AnswerWriter {
 public:
  AnswerWriter(const CodeContent& content, const AnswerStyle& style) : content_(content), style_(style) {
    for (std::size_t k = 0; k < content.texts.size(); ++k) add_call(content.functions[k], content.texts[k]);
  }

  std::string statements() const {
    if (calls_.empty()) return "";
    std::vector<std::string> arrays;
    std::string fills;
    for (const auto& [kind, length] : lengths_) {
      const std::string name = kind == InputKind::parameter ? kSymbols : input_argument(kind, 0).name;
      arrays.push_back(array(name, length));
      fills += call(fmt::format("fill({}, {}, seed + {}u)", name, length, seed_of(kind)));
    }
    if (asks_sines_) {
      const std::size_t angles = content_.scope.angle_count();
      for (const char* name : {"sine", "cosine"}) arrays.push_back(array(name, angles));
      fills += call(fmt::format("fill_sines(sine, cosine, {}, seed + {}u)", angles, kTangentSeed));
    }
    arrays.push_back(array(kResults, most_results_));
    return list_line(style_.scalar + " ", arrays, ";", kStatementIndent) + fills + constants() + calls_;
  }

 private:
  // Arrays have at least one entry.
  static std::string array(const std::string& name, std::size_t length) {
    return fmt::format("{}[{}]", name, std::max<std::size_t>(length, 1));
  }

  std::string call(const std::string& text) const { return code_line(style_.prefix + text + ";", kStatementIndent); }

  // The values of the symbols, and the source of sines and cosines.
  std::string constants() const {
    std::string text;
    if (const auto found = lengths_.find(InputKind::parameter); found != lengths_.end()) {
      std::vector<std::string> members;
      for (std::size_t k = 0; k < found->second; ++k) members.push_back(fmt::format("{}[{}]", kSymbols, k));
      text += list_line(fmt::format("const {} parameters = {{", style_.parameters), members, "};", kStatementIndent);
    }
    if (asks_sines_ && !style_.given.empty()) {
      text += code_line(fmt::format("const {} {} = {{sine, cosine}};", style_.given, kGiven), kStatementIndent);
    }
    return text;
  }

  void note_length(InputKind kind, std::size_t length) {
    std::size_t& known = lengths_[kind];
    known = std::max(known, length);
  }

  void add_call(const Function& function, const FunctionText& text) {
    const std::size_t results = entry_count(function);
    most_results_ = std::max(most_results_, results);
    asks_sines_ = asks_sines_ || text.uses_trigonometry;
    if (!content_.scope.parameters.empty()) note_length(InputKind::parameter, content_.scope.parameters.size());
    for (std::size_t k = 0; k < text.inputs.size(); ++k) note_length(function.inputs[k], text.inputs[k].length);
    const bool is_variant = style_.given.empty() && text.sin_cos_variant;
    const bool returns_verdict = !returns_value(function) && !function.validity_conditions.empty();
    const std::string begin = returns_value(function) ? fmt::format("{}[0] = ", kResults)
                              : returns_verdict       ? "(void)"
                                                      : "";
    // Entries that a scene leaves out are not written.
    if (!is_whole(function)) calls_ += call(fmt::format("fill({}, {}, 0u)", kResults, results));
    calls_ +=
        list_line(fmt::format("{}{}(", begin, is_variant ? text.sin_cos_variant->name : text.name),
                  arguments(text, is_variant), ");", kStatementIndent) +
        code_line(fmt::format("hash = {}hash_of({}, {}, hash);", style_.prefix, kResults, results), kStatementIndent);
  }

  std::vector<std::string> arguments(const FunctionText& text, bool is_variant) const {
    std::vector<std::string> list;
    if (is_variant) {
      list = text.sin_cos_variant->arguments;
    } else {
      if (!content_.scope.parameters.empty()) list.emplace_back("parameters");
      for (const ArrayArgument& input : text.inputs) list.push_back(input.name);
      for (const ArrayArgument& output : text.outputs) list.push_back(output.name);
      if (text.uses_trigonometry) list.emplace_back(kGiven);
    }
    std::map<std::string, std::string> places = {{"parameters", style_.parameters_argument}};
    std::size_t offset = 0;
    for (const ArrayArgument& output : text.outputs) {
      places[output.name] = offset == 0 ? kResults : place_in_results(offset);
      offset += output.length;
    }
    for (std::string& argument : list) {
      if (const auto place = places.find(argument); place != places.end()) argument = place->second;
    }
    return list;
  }

  // MISRA wants no sums of pointers in C.
  std::string place_in_results(std::size_t offset) const {
    return style_.given.empty() ? fmt::format("&{}[{}]", kResults, offset) : fmt::format("{} + {}", kResults, offset);
  }

  const CodeContent& content_;
  const AnswerStyle& style_;
  std::map<InputKind, std::size_t> lengths_;
  std::size_t most_results_ = 0;
  bool asks_sines_ = false;
  std::string calls_;
};

}  // namespace

std::string known_answer_statements(const CodeContent& content, const AnswerStyle& style) {
  return AnswerWriter(content, style).statements();
}

}  // namespace flatdyn
