// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/known_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"

namespace flatdyn {
namespace {

constexpr const char *kResults = "result", *kGiven = "given";

class AnswerWriter {
 public:
  AnswerWriter(const CodeContent& content, const AnswerStyle& style)
      : content_(content), style_(style), state_(known_state(content)) {
    for (std::size_t k = 0; k < content.texts.size(); ++k) {
      if (!computes_angles(content.functions[k])) add_call(content.functions[k], content.texts[k]);
    }
  }

  std::string statements() const {
    if (calls_.empty()) return "";
    std::vector<std::string> arrays;
    std::string fills;
    for (const KnownArray& each : state_.arrays) {
      arrays.push_back(array(each.name, each.length));
      fills += call(fmt::format("fill({}, {}, seed + {}u)", each.name, each.length, seed_of(each.kind)));
    }
    if (asks_sines()) {
      for (const char* name : {"sine", "cosine"}) arrays.push_back(array(name, state_.angles));
      fills += call(fmt::format("fill_sines(sine, cosine, {}, seed + {}u)", state_.angles, kTangentSeed));
    }
    arrays.push_back(array(kResults, state_.most_results));
    return list_line(style_.scalar + " ", arrays, ";", kStatementIndent) + fills + constants() + calls_;
  }

 private:
  // Arrays have at least one entry.
  static std::string array(const std::string& name, std::size_t length) {
    return fmt::format("{}[{}]", name, std::max<std::size_t>(length, 1));
  }

  // Where functions take sines and cosines as arrays, a helper fills these, whoever needs them; in C++ they are a
  // constant of this function.
  bool asks_sines() const { return state_.angles > 0 && (style_.given.empty() || asks_given_); }

  std::string call(const std::string& text) const { return code_line(style_.prefix + text + ";", kStatementIndent); }

  // The values of the symbols, and the source of sines and cosines.
  std::string constants() const {
    std::string text;
    if (const std::size_t symbols = content_.scope.parameters.size(); symbols > 0) {
      std::vector<std::string> members;
      for (std::size_t k = 0; k < symbols; ++k) members.push_back(fmt::format("{}[{}]", kSymbols, k));
      text += list_line(fmt::format("const {} parameters = {{", style_.parameters), members, "};", kStatementIndent);
    }
    if (asks_sines() && !style_.given.empty()) {
      text += code_line(fmt::format("const {} {} = {{sine, cosine}};", style_.given, kGiven), kStatementIndent);
    }
    return text;
  }

  void add_call(const Function& function, const FunctionText& text) {
    const std::size_t results = entry_count(function);
    const bool is_variant = style_.given.empty() && text.sin_cos_variant;
    asks_given_ = asks_given_ || text.uses_trigonometry;
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
  KnownState state_;
  std::string calls_;
  bool asks_given_ = false;  // whether any of these functions takes a source of sines and cosines
};

}  // namespace

KnownState known_state(const CodeContent& content) {
  KnownState state;
  std::map<InputKind, std::size_t> lengths;
  const auto note = [&lengths](InputKind kind, std::size_t length) { lengths[kind] = std::max(lengths[kind], length); };
  if (!content.scope.parameters.empty()) note(InputKind::parameter, content.scope.parameters.size());
  for (std::size_t k = 0; k < content.texts.size(); ++k) {
    const Function& function = content.functions[k];
    const FunctionText& text = content.texts[k];
    if (text.uses_trigonometry || text.computes_sines) state.angles = content.scope.angle_count();
    if (computes_angles(function)) continue;
    for (std::size_t i = 0; i < text.inputs.size(); ++i) note(function.inputs[i], text.inputs[i].length);
    state.most_results = std::max(state.most_results, entry_count(function));
  }
  for (const auto& [kind, length] : lengths) {
    state.arrays.push_back({kind == InputKind::parameter ? kSymbols : input_argument(kind, 0).name, kind, length});
  }
  return state;
}

std::string known_answer_statements(const CodeContent& content, const AnswerStyle& style) {
  return AnswerWriter(content, style).statements();
}

}  // namespace flatdyn
