// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/file_known_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace flatdyn {
namespace {

constexpr const char* kSymbolsArray = "symbol";

// Arguments have the seeds 1, 2, … in the order of their table, without 16, which is that of tangents.
int seed_of_input(const std::string& name) {
  constexpr int kOfTangents = 16;
  const ArgumentRow* row = find_argument(name);
  const int place = 1 + static_cast<int>(row == nullptr ? InputKind::parameter : row->kind);
  return place < kOfTangents ? place : place + 1;
}

int results_of(const FileFunction& function) { return static_cast<int>(entry_count(*function.function)); }

std::string call_text(const KnownCall& call, const FileContents& contents, const KnownAnswerWords& words) {
  const Function& function = *call.function->function;
  const int results = results_of(*call.function);
  std::string text = is_whole(function) ? "" : fmt::format("{}fill(result, {}, 0u);", words.prefix, results);
  std::vector<int> lengths;
  for (const EmittedParameter& parameter : parameters_of(*call.function, contents)) {
    if (parameter.kind == EmittedParameter::Kind::output) lengths.push_back(parameter.length);
  }
  int offset = 0;
  std::size_t output = 0;
  std::string arguments;
  for (const std::string& argument : call.arguments) {
    arguments += arguments.empty() ? "" : ", ";
    if (!argument.empty()) {
      arguments += argument;
      continue;
    }
    arguments += offset == 0           ? "result"
                 : words.given.empty() ? fmt::format("&result[{}]", offset)
                                       : fmt::format("result + {}", offset);
    offset += lengths.at(output++);
  }
  const bool drops_verdict = !returns_number(function) && !function.validity_conditions.empty();
  return text + fmt::format("{}{}({});hash = {}hash_of(result, {}, hash);",
                            returns_number(function) ? "result[0] = "
                            : drops_verdict          ? "(void)"
                                                     : "",
                            call.name, arguments, words.prefix, results);
}

}  // namespace

std::vector<KnownInput> known_inputs(const FileContents& contents) {
  std::map<int, KnownInput> arrays;
  const auto note = [&arrays](const std::string& name, int length) {
    const int seed = seed_of_input(name);
    KnownInput& known = arrays[seed];
    known = {name, std::max(known.length, length), seed};
  };
  if (!contents.parameters.empty()) note(kSymbolsArray, static_cast<int>(contents.parameters.size()));
  for (const FileFunction& function : contents.functions) {
    if (computes_angles(*function.function)) continue;
    for (const EmittedParameter& parameter : parameters_of(function, contents)) {
      if (parameter.kind == EmittedParameter::Kind::input) note(parameter.name, parameter.length);
    }
  }
  std::vector<KnownInput> list;
  for (const auto& [seed, input] : arrays) list.push_back(input);
  return list;
}

std::string known_answer_pattern(const FileContents& contents, const std::vector<KnownCall>& calls,
                                 const KnownAnswerWords& words) {
  std::string declared, fills, of_calls;
  const auto declare = [&](const std::string& name, int length) {
    declared += fmt::format("{} {}[{}]", declared.empty() ? words.scalar : ",", name, std::max(length, 1));
  };
  int most = 0;
  for (const KnownInput& each : known_inputs(contents)) {
    declare(each.name, each.length);
    fills += fmt::format("{}fill({}, {}, seed + {}u);", words.prefix, each.name, each.length, each.seed);
  }
  if (words.asks_sines) {
    for (const char* name : {"sine", "cosine"}) declare(name, contents.angles);
    fills += fmt::format("{}fill_sines(sine, cosine, {}, seed + {}u);", words.prefix, contents.angles, kSeedOfTangents);
  }
  for (const KnownCall& call : calls) {
    most = std::max(most, results_of(*call.function));
    of_calls += call_text(call, contents, words);
  }
  declare("result", most);
  for (std::size_t k = 0; k < contents.parameters.size(); ++k) {
    fills += fmt::format("{} symbol[{}]", k == 0 ? "const " + words.parameters + " parameters = {" : ",", k);
  }
  if (!contents.parameters.empty()) fills += "};";
  if (words.asks_sines && !words.given.empty()) fills += "const " + words.given + " given = {sine, cosine};";
  return declared + ";" + fills + of_calls;
}

bool is_hash(const std::string& token) {
  constexpr std::size_t kLength = 2 + 16 + 1;
  return token.size() == kLength && token.starts_with("0x") && token.ends_with('u') &&
         token.find_first_not_of("0123456789abcdef", 2) == token.size() - 1;
}

}  // namespace flatdyn
