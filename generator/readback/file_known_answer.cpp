// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/file_known_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace flatdyn {
namespace {

// The seeds of arguments, and of the tangents of half angles.
const std::map<std::string, int> kSeeds = {{"q", 1},      {"qd", 2},   {"qdd", 3},   {"tau", 4},  {"h_e", 5},
                                           {"symbol", 6}, {"qd_r", 7}, {"qdd_r", 8}, {"pi_b", 9}, {"g_b", 10},
                                           {"v", 11},     {"a", 12},   {"v_r", 13},  {"a_r", 14}};
constexpr int kTangents = 16;

int results_of(const FileFunction& function) { return static_cast<int>(entry_count(*function.function)); }

// The lengths of the arrays that the calls read, in the order of their seeds.
std::map<int, std::pair<std::string, int>> arrays_of(const FileContents& contents,
                                                     const std::vector<KnownCall>& calls) {
  std::map<int, std::pair<std::string, int>> arrays;
  const auto note = [&arrays](const std::string& name, int length) {
    auto& [known, longest] = arrays[kSeeds.at(name)];
    known = name;
    longest = std::max(longest, length);
  };
  if (!contents.parameters.empty()) note("symbol", static_cast<int>(contents.parameters.size()));
  for (const KnownCall& call : calls) {
    for (const EmittedParameter& parameter : parameters_of(*call.function, contents)) {
      if (parameter.kind == EmittedParameter::Kind::input) note(parameter.name, parameter.length);
    }
  }
  return arrays;
}

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

std::string known_answer_pattern(const FileContents& contents, const std::vector<KnownCall>& calls,
                                 const KnownAnswerWords& words) {
  std::string declared, fills, of_calls;
  const auto declare = [&](const std::string& name, int length) {
    declared += fmt::format("{} {}[{}]", declared.empty() ? words.scalar : ",", name, std::max(length, 1));
  };
  int most = 0;
  for (const auto& [seed, array] : arrays_of(contents, calls)) {
    declare(array.first, array.second);
    fills += fmt::format("{}fill({}, {}, seed + {}u);", words.prefix, array.first, array.second, seed);
  }
  if (words.asks_sines) {
    for (const char* name : {"sine", "cosine"}) declare(name, contents.angles);
    fills += fmt::format("{}fill_sines(sine, cosine, {}, seed + {}u);", words.prefix, contents.angles, kTangents);
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
