// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of emitted C. One that needs sines and cosines computes them and calls one that takes them.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "code/languages/c/read_file.hpp"

namespace flatdyn {
namespace {

// The index that a token is; -1 if it is not an index.
int index_in(const std::string& token) {
  constexpr std::size_t kMostDigits = 8;
  const bool is_index =
      !token.empty() && token.size() <= kMostDigits && token.find_first_not_of("0123456789") == std::string::npos;
  return is_index ? std::stoi(token) : -1;
}

}  // namespace

std::string CFile::returns_of(const FileFunction& function) const {
  if (returns_number(*function.function)) return scalar_;
  return function.function->validity_conditions.empty() ? "void" : condition_type();
}

// The function that takes sines and cosines; nullptr if there is none.
const ScannedFunction* CFile::given_of(const FileFunction& function) const {
  const auto found = text_.parts().find(prefix_of_definitions_ + function.given);
  return found == text_.parts().end() ? nullptr : &found->second;
}

// In a definition, what is not used is cast to void, and nothing else is.
void CFile::require_used(const ScannedFunction& body, const std::string& name) const {
  std::size_t used = 0, cast = 0;
  for (std::size_t k = body.begin; k < body.end; ++k) {
    if (tokens_[k].text != name || is_member(k)) continue;
    const bool is_cast = k >= body.begin + 3 && tokens_[k - 1].text == ")" && tokens_[k - 2].text == "void";
    ++(is_cast ? cast : used);
  }
  if (cast > 1 || (cast == 1) != (used == 0)) fail(fmt::format("{} is not used, or cast to void", name));
}

// Takes a parameter, in a definition with `body`: const double q[7], double tau[restrict 7], double* condition.
void CFile::parameter(const EmittedParameter& parameter, const ScannedFunction* body, bool& is_first,
                      const ScannedFunction* given) {
  using Kind = EmittedParameter::Kind;
  if (!is_first) expect(",");
  is_first = false;
  const bool is_sized = has_lengths_ && parameter.length > 0 && !parameter.is_number;
  const bool is_restricted = parameter.kind == Kind::output && body != nullptr;
  if (parameter.kind == Kind::parameters) {
    expect("const $exported$parameters*");
  } else {
    expect((parameter.kind == Kind::input ? "const " : "") + scalar_);
    if (!is_sized) expect(is_restricted ? "* restrict" : "*");
  }
  const std::string name = take_name_like(parameter.name);
  if (parameter.kind != Kind::output && name != parameter.name) fail("another parameter");
  if (body != nullptr) require_used(*body, name);
  if (!is_sized) return;
  expect(is_restricted ? "[restrict" : "[");
  if (given != nullptr) {
    length_of_sines(*given);
  } else {
    expect(std::to_string(parameter.length));
  }
  expect("]");
}

// Takes the length of the arrays of sines and cosines: the function reads the last of them, and none beyond.
void CFile::length_of_sines(const ScannedFunction& given) {
  std::set<std::string> parts;
  int last = last_sine_read(given, parts);
  if (take() != std::to_string(last + 1)) fail(fmt::format("the length {} expected", last + 1));
}

// The largest index at which the function, or a part that it calls, reads sines or cosines; -1 if there is none.
int CFile::last_sine_read(const ScannedFunction& function, std::set<std::string>& parts) const {
  int last = -1;
  for (std::size_t k = function.begin; k + 2 < function.end; ++k) {
    const std::string& text = tokens_[k].text;
    if ((text == "sine" || text == "cosine") && tokens_[k + 1].text == "[" && !is_member(k)) {
      last = std::max(last, index_in(tokens_[k + 2].text));
    }
    const auto part = text_.parts().find(text);
    if (part != text_.parts().end() && parts.insert(text).second) {
      last = std::max(last, last_sine_read(part->second, parts));
    }
  }
  return last;
}

// Takes the parameters up to the closing bracket. Where sines are taken, q is only if its values are read.
void CFile::parameter_list(const FileFunction& function, const ScannedFunction* body, bool takes_sines) {
  using Kind = EmittedParameter::Kind;
  bool is_first = true, has_sines = !takes_sines;
  const ScannedFunction* given = given_of(function);
  for (const EmittedParameter& each : parameters_of(function, contents_)) {
    if (!has_sines && each.kind != Kind::parameters) {
      has_sines = true;
      parameter({Kind::input, "sine", 1}, body, is_first, given);
      parameter({Kind::input, "cosine", 1}, body, is_first, given);
    }
    const bool is_read = !takes_sines || each.kind != Kind::input || each.name != "q" || names(*given, "q");
    if (is_read) parameter(each, body, is_first);
  }
  expect(")");
}

void CFile::declarations(const FileFunction& function) {
  for (const FileTable& each : function.zeros) declare(each);
  const std::string returns = (returns_of(function) == "bool" ? "$nodiscard$ " : "") + returns_of(function);
  expect(fmt::format("{} {}(", returns, prefixed(function.name)));
  parameter_list(function, nullptr, false);
  expect(";");
  if (given_of(function) == nullptr) return;
  expect(fmt::format("{} {}(", returns, prefixed(function.given)));
  parameter_list(function, nullptr, true);
  expect(";");
}

void CFile::definitions(const FileFunction& function, const char* linkage) {
  const ScannedFunction& asking = next_function();
  while (follows_part(prefixed(function.name))) part(function, asking);
  if (const ScannedFunction* given = given_of(function)) {
    expect(fmt::format("{} {} {}(", linkage, returns_of(function), prefixed(function.given)));
    parameter_list(function, given, true);
    expect("{");
    take_part_body(given->name);
  }
  expect(fmt::format("{} {} {}(", linkage, returns_of(function), prefixed(function.name)));
  parameter_list(function, &asking, false);
  expect("{");
  take_body(asking);
}

// Whether a part of the function follows: static void arm_gravity_part_1(
bool CFile::follows_part(const std::string& owner) const {
  return is("static") && word(1) == "void" && word(2).starts_with(owner + "_part");
}

void CFile::part(const FileFunction& function, const ScannedFunction& asking) {
  expect("static void");
  const std::string name = take();
  std::vector<std::string> possible = {"const $exported$parameters* parameters"};
  const std::string input = fmt::format("const {}* ", scalar_), output = fmt::format("{}* restrict ", scalar_);
  for (const InputKind kind : function.function->inputs)
    possible.push_back(input + std::string(argument_row(kind).name));
  for (const char* each : {"sine", "cosine"}) possible.push_back(input + each);
  for (const std::string& each : arrays_of_sine_rounds()) possible.push_back(output + each);
  for (const char* each : {"kept", "pivots", "result"}) possible.push_back(output + each);
  for (const ScannedFunction::Parameter& each : asking.parameters) {
    if (each.is_output) possible.push_back(output + each.name);
  }
  expect("(");
  take_parameters_of_part(possible);
  expect("{");
  take_part_body(name);
}

// Takes the functions that multiply positions, if there are any.
void CFile::angles() {
  const std::string name = prefixed("angles");
  while (is("static") && word(1) == "void" && (word(2) == name || word(2).starts_with(name + "_"))) {
    expect("static void");
    const std::string part = take();
    expect(fmt::format("(const {0}* q, {0}* restrict angle) {{", scalar_));
    take_part_body(part);
  }
}

}  // namespace flatdyn
