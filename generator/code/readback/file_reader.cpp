// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/file_reader.hpp"
#include "code/readback/language_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

int length_of_input(InputKind kind, const Function& function, const FileContents& contents) {
  switch (argument_row(kind).length) {
    case ArgumentLength::positions:
      return contents.positions;
    case ArgumentLength::wrench:
      return kWrenchLength;
    case ArgumentLength::vector:
      return kVectorLength;
    case ArgumentLength::one:
      return 1;
    case ArgumentLength::base_parameters:
    case ArgumentLength::own:
      return own_length(function, argument_row(kind).length);
    default:
      return contents.velocities.value_or(contents.joints);
  }
}

bool has_rows(const Output& output) {
  return !output.entries.empty() && (output.layout == Layout::matrix || output.layout == Layout::christoffel);
}

bool is_written_at_all(const Output& output) {
  for (std::size_t e = 0; e < output.entries.size(); ++e) {
    if (!output.leaves_out(e)) return true;
  }
  return output.entries.empty();
}

}  // namespace

bool returns_number(const Function& function) {
  return function.validity_conditions.empty() && function.outputs.size() == 1 &&
         function.outputs[0].layout == Layout::scalar;
}

std::vector<EmittedParameter> parameters_of(const FileFunction& file_function, const FileContents& contents) {
  using Kind = EmittedParameter::Kind;
  const Function& function = *file_function.function;
  std::vector<EmittedParameter> list;
  if (!contents.parameters.empty() && file_function.member_of.empty()) list.push_back({Kind::parameters, "parameters"});
  for (const InputKind kind : function.inputs) {
    list.push_back({Kind::input, argument_row(kind).name, length_of_input(kind, function, contents)});
  }
  if (returns_number(function) || !file_function.made.empty()) return list;
  for (const Output& output : function.outputs) {
    list.push_back({Kind::output, output.name, static_cast<int>(output.entries.size()),
                    has_rows(output) ? output.cols : 0, is_written_at_all(output), output.layout == Layout::scalar});
  }
  return list;
}

FileReader::FileReader(const EmittedText& text, const FileContents& contents)
    : TokenCursor(text.tokens()), text_(text), contents_(contents) {}

void FileReader::run() {
  if (tokens_.empty()) fail("it is empty");
  file();
  if (!at_end()) fail(fmt::format("\"{}\" after the end", word()));
  if (functions_read_ != text_.functions().size()) fail("another number of functions");
  require_all_parts_called();
}

const std::string& FileReader::take() {
  const std::string& text = word();
  ++at_;
  return text;
}

std::vector<Token> FileReader::tokens_of_pattern(const std::string& pattern) const {
  std::string text;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t hole = pattern.find('$', at);
    text += pattern.substr(at, hole - at);
    if (hole == std::string::npos) break;
    const std::size_t end = pattern.find('$', hole + 1);
    text += holes_.at(pattern.substr(hole + 1, end - hole - 1));
    at = end + 1;
  }
  return tokens_of(text);
}

void FileReader::expect(const std::string& pattern) {
  for (const Token& token : tokens_of_pattern(pattern)) {
    if (word() != token.text) fail(fmt::format("\"{}\" expected instead of \"{}\"", token.text, word()));
    ++at_;
  }
}

bool FileReader::follows(const std::string& pattern) const {
  const std::vector<Token> tokens = tokens_of_pattern(pattern);
  return at_ + tokens.size() <= tokens_.size() &&
         std::equal(tokens.begin(), tokens.end(), tokens_.begin() + static_cast<std::ptrdiff_t>(at_),
                    [](const Token& a, const Token& b) { return a.text == b.text; });
}

bool FileReader::accept(const std::string& pattern) {
  if (!follows(pattern)) return false;
  at_ += tokens_of_pattern(pattern).size();
  return true;
}

std::string FileReader::take_name_like(const std::string& wanted) {
  const std::string name = take();
  require_name_like(wanted, name);
  return name;
}

void FileReader::require_name_like(const std::string& wanted, const std::string& name) const {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::string prefix = wanted + (wanted.ends_with('_') ? "" : "_");
  const bool is_numbered = name.starts_with(prefix) && name.size() > prefix.size() &&
                           std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(), is_digit);
  if (name != wanted && !is_numbered) fail(fmt::format("\"{}\" expected instead of \"{}\"", wanted, name));
}

void FileReader::take_text(const std::string& wanted) {
  if (unquoted(take()) != wanted) fail(fmt::format("the text \"{}\" expected", wanted));
}

// Takes a number in decimal, with its sign, and followed by this character unless that is 0.
double FileReader::take_literal(char suffix) {
  const bool is_negative = word() == "-";
  if (is_negative) ++at_;
  std::string text = take();
  if (suffix != 0 && text.ends_with(suffix)) {
    text.pop_back();
  } else if (suffix != 0) {
    fail("another type of number");
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(value) &&
                         text.find_first_of(".e") != std::string::npos;
  if (!is_number) fail("a number expected");
  return is_negative ? -value : value;
}

void FileReader::take_number(const FileTable& table, double wanted) {
  if (table.type == "Real") {
    take_real(wanted);
  } else if (table.type == "bool") {
    take_flag(wanted > 0);
  } else if (take() != fmt::format("{}", static_cast<int>(wanted))) {
    fail(fmt::format("another number in {}", table.name));
  }
}

void FileReader::take_flag(bool wanted) {
  if (take() != (wanted ? "1" : "0")) fail("another flag");
}

void FileReader::take_entries(const FileTable& table, const char* end) {
  const std::size_t count = table.texts.size() + table.numbers.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0) expect(",");
    if (table.texts.empty()) {
      take_number(table, table.numbers[k]);
    } else {
      take_text(table.texts[k]);
    }
  }
  expect(end);
}

bool FileReader::uses(const std::vector<std::string>& words) const {
  const auto is_in = [&](const ScannedFunction& function) {
    const auto begin = tokens_.begin() + static_cast<std::ptrdiff_t>(function.begin);
    const auto end = tokens_.begin() + static_cast<std::ptrdiff_t>(function.end);
    const auto is_word = [](const Token& token, const std::string& text) { return token.text == text; };
    for (auto at = begin;; ++at) {
      at = std::search(at, end, words.begin(), words.end(), is_word);
      if (at == end) return false;
      if (!is_member(static_cast<std::size_t>(at - tokens_.begin()))) return true;
    }
  };
  const auto is_in_part = [&](const std::string& name) { return is_in(text_.parts().at(name)); };
  return std::any_of(text_.functions().begin(), text_.functions().end(), is_in) ||
         std::any_of(parts_read_.begin(), parts_read_.end(), is_in_part);
}

void FileReader::require_helper(const char* helper, bool is_there, bool is_used) const {
  if (is_there != is_used) fail(fmt::format("{} is {}there", helper, is_there ? "" : "not "));
}

const ScannedFunction& FileReader::next_function() {
  if (functions_read_ >= text_.functions().size()) fail("no further function");
  return text_.functions()[functions_read_++];
}

std::vector<std::string> FileReader::names_of_outputs(const FileFunction& function) const {
  std::vector<std::string> names;
  if (function.made.empty() && functions_read_ < text_.functions().size()) {
    const auto& parameters = text_.functions()[functions_read_].parameters;
    const std::size_t count = std::min(parameters.size(), function.function->outputs.size());
    for (std::size_t k = parameters.size() - count; k < parameters.size(); ++k) names.push_back(parameters[k].name);
  } else {
    for (const Output& output : function.function->outputs) names.push_back(output.name);
  }
  return names;
}

std::vector<std::string> FileReader::names_of_outputs_read() const {
  std::vector<std::string> names;
  for (const ScannedFunction::Parameter& parameter : text_.functions().at(functions_read_ - 1).parameters) {
    if (parameter.is_output) names.push_back(parameter.name);
  }
  return names;
}

bool FileReader::names(const ScannedFunction& function, const std::string& name) const {
  for (std::size_t at = function.begin; at < function.end; ++at) {
    if (tokens_[at].text == name && !is_member(at)) return true;
  }
  return false;
}

bool FileReader::is_member(std::size_t at) const {
  return at > 0 && (tokens_[at - 1].text == "." || tokens_[at - 1].text == "->");
}

void FileReader::take_body(const ScannedFunction& function) {
  if (at_ != function.begin) fail("another place of a function");
  at_ = function.end;
  expect("}");
}

void FileReader::take_part_body(const std::string& name) {
  const auto part = text_.parts().find(name);
  if (part == text_.parts().end() || !parts_read_.insert(name).second) fail("no part " + name);
  take_body(part->second);
}

std::vector<std::string> FileReader::arrays_of_sine_rounds() const {
  constexpr int kMostRounds = 8;
  std::vector<std::string> arrays;
  for (int round = 1; round <= kMostRounds; ++round) {
    for (const char* array : {code::kAngles, code::kSines, code::kCosines}) {
      arrays.push_back(fmt::format("{}_{}", array, round));
    }
  }
  return arrays;
}

void FileReader::take_parameters_of_part(const std::vector<std::string>& patterns) {
  bool is_first = true;
  for (const std::string& pattern : patterns) {
    if (is(")")) break;
    const std::string next = (is_first ? "" : ", ") + pattern;
    if (!follows(next + ",") && !follows(next + ")")) continue;
    expect(next);
    is_first = false;
  }
  expect(")");
}

// Every part is part of a function, whose statements are read.
void FileReader::require_all_parts_called() const {
  std::set<std::string> called;
  for (const ScannedFunction& function : text_.functions()) note_called(function, called);
  for (const std::string& part : parts_read_) {
    if (called.count(part) == 0) fail(fmt::format("nothing calls {}", part));
  }
}

void FileReader::note_called(const ScannedFunction& function, std::set<std::string>& called) const {
  for (std::size_t k = function.begin; k < function.end; ++k) {
    const auto part = text_.parts().find(tokens_[k].text);
    if (part != text_.parts().end() && called.insert(part->first).second) note_called(part->second, called);
  }
}

void read_file(const EmittedText& text, const FileContents& contents) { text.language().read_file(text, contents); }

}  // namespace flatdyn
