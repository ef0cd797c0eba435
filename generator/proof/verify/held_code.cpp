// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/held_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/unreadable_text.hpp"
#include "truth/definition/exact.hpp"

namespace flatdyn {
namespace {

constexpr const char* kAround = "";  // the section around the functions

std::string full_name(const ScannedFunction& function) {
  return function.member_of.empty() ? function.name : function.member_of + "::" + function.name;
}

// The tokens of a text, divided into the bodies of its functions and their parts, by name, and what is around them.
using Sections = std::map<std::string, std::vector<Token>>;

// The tokens as they are compared. The guard of a header, which depends on the version and the bytes of the robot file,
// becomes "GUARD". The "return" of a result on another line becomes another word, since JavaScript returns nothing
// then.
std::vector<Token> comparable(std::vector<Token> tokens) {
  for (std::size_t k = 0; k + 1 < tokens.size(); ++k) {
    if (tokens[k].text == "return" && tokens[k + 1].line != tokens[k].line) tokens[k].text = "return ";
  }
  const std::string begin = "#ifndef FLATDYN_";
  const auto first = std::find_if(tokens.begin(), tokens.end(),
                                  [&begin](const Token& token) { return token.text.starts_with(begin); });
  if (first == tokens.end()) return tokens;
  const std::string guard = first->text.substr(std::string("#ifndef ").size());
  for (Token& token : tokens) {
    const std::size_t at = token.is_directive() ? token.text.find(guard) : std::string::npos;
    if (at != std::string::npos) token.text.replace(at, guard.size(), "GUARD");
  }
  return tokens;
}

Sections sections_of(const EmittedText& text) {
  const std::vector<Token> tokens = comparable(text.tokens());
  std::map<std::size_t, std::pair<std::size_t, std::string>> bodies;  // by their begin: end and name
  for (const ScannedFunction& each : text.functions()) bodies[each.begin] = {each.end, full_name(each)};
  for (const auto& [name, part] : text.parts()) bodies[part.begin] = {part.end, name};
  Sections sections;
  for (std::size_t k = 0; k < tokens.size();) {
    const auto body = bodies.find(k);
    if (body == bodies.end() || body->second.first <= k) {
      sections[kAround].push_back(tokens[k++]);
      continue;
    }
    std::vector<Token>& section = sections[body->second.second];
    for (; k < body->second.first; ++k) section.push_back(tokens[k]);
  }
  return sections;
}

// The beginning of the names of a function's parts, and in C that of the function that takes its sines and cosines.
std::string begin_of_parts(const ScannedFunction& function) {
  constexpr std::string_view kGiven = "_given";
  std::string name = (function.member_of.empty() ? "" : function.member_of + "_") + function.name;
  if (name.ends_with(kGiven)) name.resize(name.size() - kGiven.size());
  return name;
}

// The sections that are read with a function: its own, and those of its parts, whose names begin so. Helpers, such as
// the text's own sines, are not among them: what they compute is known by their text alone.
void note_sections(const EmittedText& text, const ScannedFunction& function, const std::string& name,
                   const std::string& begin, std::set<std::string>& sections) {
  if (!sections.insert(name).second) return;
  for (std::size_t k = function.begin; k < function.end; ++k) {
    const auto part = text.parts().find(text.tokens()[k].text);
    if (part == text.parts().end() || !part->first.starts_with(begin)) continue;
    note_sections(text, part->second, part->first, begin, sections);
  }
}

std::string entry_name(const Function& function, const ExactMismatch& mismatch) {
  for (const Output& output : function.outputs) {
    if (output.name != mismatch.output) continue;
    return output.layout == Layout::scalar ? output.name : fmt::format("{}[{}]", output.name, mismatch.entry);
  }
  return "what it returns";
}

std::string described(const ExactResult& result, const Function& function) {
  constexpr std::size_t kMost = 4;
  if (result.mismatches.empty()) return "it has other outputs";
  std::string names;
  for (std::size_t k = 0; k < std::min(kMost, result.mismatches.size()); ++k) {
    names += (k == 0 ? "" : ", ") + entry_name(function, result.mismatches[k]);
  }
  return fmt::format("{} of {} entries differ: {}{}", result.mismatches.size(), result.entries, names,
                     result.mismatches.size() > kMost ? ", …" : "");
}

class HeldComparison {
 public:
  HeldComparison(const EmittedText& held, const EmittedText& own, std::vector<Function> functions, std::uint64_t seed)
      : held_(held), own_(own), functions_(std::move(functions)), seed_(seed) {}

  HeldReport run() {
    compare_sections();
    for (std::size_t k = 0; k < functions_.size(); ++k) report_.functions.push_back(compared(k));
    for (const ScannedFunction& each : held_.functions()) note_unknown(each);
    for (auto& [name, differences] : differences_) {
      if (settled_.count(name) != 0) continue;
      for (TextDifference& each : differences) report_.differences.push_back(std::move(each));
    }
    return std::move(report_);
  }

 private:
  void compare_sections() {
    const Sections held = sections_of(held_), own = sections_of(own_);
    for (const auto& [name, tokens] : own) {
      const auto found = held.find(name);
      if (found == held.end()) continue;  // said of the function
      std::vector<TextDifference> differences = differences_of(found->second, tokens, report_.is_only_first);
      for (TextDifference& each : differences) each.function = name;
      if (!differences.empty()) differences_[name] = std::move(differences);
    }
  }

  std::optional<std::size_t> place_of(const std::string& name) const {
    for (std::size_t k = 0; k < held_.functions().size(); ++k) {
      if (full_name(held_.functions()[k]) == name) return k;
    }
    return std::nullopt;
  }

  int line_of(std::size_t place) const {
    const std::size_t begin = held_.functions()[place].begin;
    return held_.tokens()[begin == 0 ? 0 : begin - 1].line;
  }

  HeldFunction compared(std::size_t k) {
    const std::string name = full_name(own_.functions()[k]);
    const std::optional<std::size_t> place = place_of(name);
    if (!place) return {name, HeldVerdict::missing};
    std::set<std::string> sections;
    for (const auto& [text, number] : {std::pair(&own_, k), std::pair(&held_, *place)}) {
      const ScannedFunction& function = text->functions()[number];
      note_sections(*text, function, name, begin_of_parts(function), sections);
    }
    const bool is_same = std::none_of(sections.begin(), sections.end(), [this](const std::string& section) {
      return differences_.count(section) != 0 || own_.parts().count(section) != held_.parts().count(section);
    });
    HeldFunction result = is_same ? HeldFunction{name} : read(k, *place, name);
    result.line = line_of(*place);
    if (result.is_right()) settled_.insert(sections.begin(), sections.end());
    return result;
  }

  // Compares what the statements compute, in exact arithmetic.
  HeldFunction read(std::size_t k, std::size_t place, const std::string& name) const {
    const Function printed = as_printed(functions_[k], own_.constants());
    try {
      const ExactResult result = prove_equal(printed, held_.read(place, printed), {seed_, 1});
      if (result.equal) return {name, HeldVerdict::equal};
      return {name, HeldVerdict::different, described(result, printed)};
    } catch (const UnreadableText& failure) {
      return {name, HeldVerdict::unreadable, fmt::format("line {}: {}", failure.line(), failure.what_is_wrong())};
    } catch (const std::exception& failure) {
      return {name, HeldVerdict::unreadable, failure.what()};
    }
  }

  void note_unknown(const ScannedFunction& function) {
    const std::string name = full_name(function);
    const bool is_known = std::any_of(report_.functions.begin(), report_.functions.end(),
                                      [&name](const HeldFunction& each) { return each.name == name; });
    if (is_known) return;
    report_.functions.push_back({name, HeldVerdict::unknown, "", line_of(*place_of(name))});
  }

  const EmittedText &held_, &own_;
  std::vector<Function> functions_;
  std::uint64_t seed_;
  std::map<std::string, std::vector<TextDifference>> differences_;  // by section
  std::set<std::string> settled_;                                   // sections of functions that are right
  HeldReport report_;
};

// The function of the text, or its part, that has a token at this line; empty: none has.
std::string function_at(const EmittedText& text, int line) {
  const auto has_line = [&text, line](const ScannedFunction& function) {
    return function.begin < function.end && text.tokens()[function.begin].line <= line &&
           line <= text.tokens()[function.end - 1].line;
  };
  for (const ScannedFunction& each : text.functions()) {
    if (has_line(each)) return full_name(each);
  }
  for (const auto& [name, part] : text.parts()) {
    if (has_line(part)) return name;
  }
  return "";
}

// Compares texts one of which cannot be divided into functions.
HeldReport compared_as_wholes(const std::string& held, const EmittedText& own, const UnreadableText& failure) {
  HeldReport report;
  report.unreadable = failure.what_is_wrong();
  report.unreadable_line = failure.line();
  report.differences = differences_of(comparable(tokens_of(held)), comparable(own.tokens()), report.is_only_first);
  for (TextDifference& each : report.differences) each.function = function_at(own, each.own_line);
  return report;
}

// Where statements compute the same as others, the rules of the text that are not about values have to hold as well:
// which checks, helpers and arguments there are.
void read_as_a_file(const EmittedText& text, const WrittenCode& code, HeldReport& report) {
  const bool has_others = std::any_of(report.functions.begin(), report.functions.end(),
                                      [](const HeldFunction& each) { return each.verdict == HeldVerdict::equal; });
  if (!has_others || !report.passed()) return;
  try {
    read_file(text, contents_of(code));
  } catch (const UnreadableText& failure) {
    report.unreadable = failure.what_is_wrong();
    report.unreadable_line = failure.line();
  }
}

}  // namespace

bool HeldReport::passed() const {
  return unreadable.empty() && differences.empty() &&
         std::all_of(functions.begin(), functions.end(), [](const HeldFunction& each) { return each.is_right(); });
}

HeldReport compare_held(const std::string& held, const EmittedText& own, const WrittenCode& code, std::uint64_t seed) {
  HeldReport report;
  try {
    const EmittedText text(held, reader_of(code.options));
    report = HeldComparison(text, own, functions_in_text(code), seed).run();
    read_as_a_file(text, code, report);
  } catch (const UnreadableText& failure) {
    report = compared_as_wholes(held, own, failure);
  }
  std::stable_sort(report.differences.begin(), report.differences.end(),
                   [](const TextDifference& a, const TextDifference& b) { return a.line < b.line; });
  return report;
}

}  // namespace flatdyn
