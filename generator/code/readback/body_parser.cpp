// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/body_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace flatdyn {
namespace {

// The largest number of checks in a loop.
constexpr int kMostEntries = 1'000'000;

// Whether the text is a number that no compiler takes for a whole one, and without zeros in front.
bool is_floating(const std::string& text) {
  const bool begins = !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
  const bool has_zeros = text.size() > 1 && text[0] == '0' && text[1] != '.' && text[1] != 'e';
  return begins && !has_zeros && text.find_first_of(".e") != std::string::npos;
}

template <class T>
bool reads_as(const std::string& text, std::size_t length, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + length, value);
  return error == std::errc() && end == text.data() + length && std::isfinite(value);
}

}  // namespace

std::vector<ParsedStatement> BodyParser::parse(const ScannedFunction& function, bool is_part) {
  function_ = &function;
  is_part_ = is_part;
  statements_.clear();
  has_checks_ = false;
  const std::vector<Form> table = forms();
  for (at_ = function.begin; at_ < function.end;) {
    statement_begin_ = at_;
    const auto form = std::find_if(table.begin(), table.end(), [](const Form& each) { return each.begins(); });
    if (form == table.end()) fail("an unknown statement");
    form->read();
  }
  if (at_ != function.end) fail("another end");
  return std::move(statements_);
}

void BodyParser::fail(const std::string& what) const { text_.refuse(at_, what); }

// The token's text; "" after the end.
const std::string& BodyParser::word(std::size_t ahead) const {
  static const std::string none;
  return at_ + ahead < text_.tokens().size() ? text_.tokens()[at_ + ahead].text : none;
}

bool BodyParser::is_last_statement() const {
  for (std::size_t k = at_; k < function_->end; ++k) {
    if (text_.tokens()[k].text == ";") return false;
  }
  return true;
}

bool BodyParser::is_on_line_before() const {
  const std::vector<Token>& tokens = text_.tokens();
  return at_ > 0 && at_ < tokens.size() && tokens[at_].line == tokens[at_ - 1].line;
}

std::string BodyParser::take() {
  if (at_ >= text_.tokens().size()) fail("it ends");
  return text_.tokens()[at_++].text;
}

void BodyParser::expect(const std::string& text) {
  if (word() != text) fail(fmt::format("\"{}\" expected", text));
  ++at_;
}

void BodyParser::expect_all(std::initializer_list<const char*> texts) {
  for (const char* text : texts) expect(text);
}

bool BodyParser::accept(const std::string& text) {
  if (word() != text) return false;
  ++at_;
  return true;
}

// Reads a whole number without leading zeros, which would make it octal.
int BodyParser::index() {
  constexpr std::size_t kMostDigits = 8;
  const std::string text = take();
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool is_number = !text.empty() && text.size() <= kMostDigits && std::all_of(text.begin(), text.end(), is_digit);
  if (!is_number || (text.size() > 1 && text.front() == '0')) fail("an index expected");
  return std::stoi(text);
}

bool BodyParser::is_number() const {
  return !word().empty() && std::isdigit(static_cast<unsigned char>(word().front())) != 0;
}

// Reads a sum from left to right; a leading minus changes the sign of the first product.
code::Expression BodyParser::sum() {
  code::Sum result;
  const bool is_negative = accept("-");
  result.addends.push_back({is_negative, product()});
  while (is("+") || is("-")) {
    const bool is_subtracted = take() == "-";
    result.addends.push_back({is_subtracted, product()});
  }
  const auto& [sign, first] = result.addends.front();
  const auto* number = std::get_if<code::Literal>(&first);
  if (is_negative && number != nullptr && number->value == 0) fail("a zero with a sign");
  if (result.addends.size() == 1 && !is_negative) return std::move(result.addends.front().value);
  return result;
}

code::Expression BodyParser::product() {
  std::vector<code::Expression> factors;
  const auto together = [&factors]() -> code::Expression {
    if (factors.size() == 1) return std::move(factors.front());
    return code::Product{std::move(factors)};
  };
  const auto next = [this] { return accept("(") ? nested() : factor(); };
  factors.push_back(next());
  for (;;) {
    if (accept("*")) {
      factors.push_back(next());
    } else if (accept("/")) {
      code::Expression dividend = together();
      factors.clear();
      code::Quotient quotient;
      quotient.operands.push_back(std::move(dividend));
      quotient.operands.push_back(next());
      factors.emplace_back(std::move(quotient));
    } else {
      return together();
    }
  }
}

code::Expression BodyParser::nested() {
  constexpr int kDeepest = 200;
  if (++depth_ > kDeepest) fail("nested too deeply");
  code::Expression value = sum();
  expect(")");
  --depth_;
  return value;
}

code::Expression BodyParser::call(code::Operation operation, int operands) {
  code::Call call{operation, {}};
  for (int k = 1; k < operands; ++k) {
    call.operands.push_back(sum());
    expect(",");
  }
  call.operands.push_back(nested());
  return call;
}

code::Literal BodyParser::literal(bool is_float, const std::string& suffix) {
  const std::string text = take();
  double value = 0;
  float narrow = 0;
  const std::size_t length = text.size() - std::min(suffix.size(), text.size());
  const bool is_number = is_floating(text) && text.ends_with(suffix) &&
                         (is_float ? reads_as(text, length, narrow) : reads_as(text, length, value));
  if (!is_number) fail("a number expected");
  return {Rational(is_float ? double(narrow) : value)};
}

code::Literal BodyParser::signed_literal(bool is_float) {
  const bool is_negative = accept("-");
  code::Literal result = literal(is_float);
  if (is_negative && result.value == 0) fail("a zero with a sign");
  if (is_negative) result.value = -result.value;
  return result;
}

code::Expression BodyParser::variable_or_entry() {
  std::string name = take();
  if (!accept("[")) return code::Variable{std::move(name)};
  const int entry = index();
  expect("]");
  return code::Element{std::move(name), entry};
}

void BodyParser::definitions() {
  code::Define define;
  do {
    std::string name = take();
    expect("=");
    define.constants.push_back({std::move(name), sum()});
  } while (accept(","));
  expect(";");
  add(std::move(define));
}

// Arrays of angles have the constant that is their number.
code::Declare::Array BodyParser::array() {
  code::Declare::Array array{take(), std::nullopt};
  if (!accept("[")) return array;
  if (is_number()) {
    array.length = static_cast<std::size_t>(index());
  } else {
    array.count = text_.count_of_angles().name;
    expect(array.count);
    array.length = static_cast<std::size_t>(text_.count_of_angles().value);
  }
  expect("]");
  return array;
}

// Reads entries until there is no further =. The sum is read before any entry is written.
void BodyParser::assignment() {
  code::Store store;
  const std::size_t last = last_assignment();
  while (at_ < last) {
    store.places.push_back(place());
    expect("=");
  }
  if (store.places.empty()) fail("an unknown statement");
  store.value = sum();
  expect(";");
  add(std::move(store));
}

std::size_t BodyParser::last_assignment() const {
  std::size_t last = at_;
  for (std::size_t ahead = 0; word(ahead) != ";" && !word(ahead).empty(); ++ahead) {
    if (word(ahead) == "=") last = at_ + ahead + 1;
  }
  return last;
}

code::Place BodyParser::place() {
  std::string name = take();
  expect("[");
  const int entry = index();
  expect("]");
  return code::Element{std::move(name), entry};
}

void BodyParser::give_back() {
  if (!is_on_line_before()) fail("a result on another line");  // JavaScript would return nothing
  add(result());
  expect(";");
}

code::Return BodyParser::result() {
  code::Return result;
  if (!has_checks_ || !accept(code::kValid)) result.value = sum();
  return result;
}

void BodyParser::call_of_part(bool is_returned, const std::string& end) {
  const auto part = text_.parts().find(take());
  if (part == text_.parts().end()) fail("a call of what is no part");
  code::CallPart call{part->first, {}, is_part_, is_returned};
  const char* before = "(";
  for (const ScannedFunction::Parameter& parameter : part->second.parameters) {
    expect(before);
    call.arguments.push_back(argument(parameter));
    before = ",";
  }
  if (part->second.parameters.empty()) expect("(");
  expect(")");
  if (!end.empty()) expect(end);
  add(std::move(call));
}

// An argument has the name of the part's parameter.
code::Argument BodyParser::argument(const ScannedFunction::Parameter& parameter) {
  if (parameter.name.empty()) fail("an argument that is not known here");
  expect(parameter.name);
  return {code::Argument::Role::input, parameter.name};
}

void BodyParser::first_check() {
  if (take() != code::kValid) fail("an unknown variable of checks");
  expect("=");
  code::Check check{true, code::Always{}};
  if (!accept_always()) check.condition = condition();
  expect(";");
  has_checks_ = true;
  add(std::move(check));
}

void BodyParser::further_check() {
  expect_all({code::kValid, continues_verdict()});
  code::Check check{false, condition()};
  expect(";");
  add(std::move(check));
}

// Reads "D_2 > 0", or "0 * tau[3] < 1" of an entry of an output: sums do not read outputs.
code::Condition BodyParser::condition() {
  const std::size_t factor = tokens_of_literal();
  const bool is_of_entry = word(factor) == "*" && word(factor + 2) == "[" && word(factor + 5) == "<";
  if (!is_of_entry) {
    code::Positive positive{sum()};
    expect(">");
    whole_literal("0.0");
    return positive;
  }
  whole_literal("0.0");
  expect("*");
  code::Element entry{take(), 0};
  expect("[");
  entry.index = index();
  expect_all({"]", "<"});
  whole_literal("1.0");
  return code::Finite{std::move(entry)};
}

void BodyParser::counted_checks(const char* counter, bool has_braces) {
  expect_all({counter, code::kCounter, "="});
  const int first = index();
  expect_all({";", code::kCounter, "<"});
  const int end = index();
  expect_all({";", "++", code::kCounter, ")"});
  if (has_braces) expect("{");
  expect_all({code::kValid, continues_verdict()});
  const bool is_of_entries = word(tokens_of_literal()) == "*";
  if (is_of_entries) {
    whole_literal("0.0");
    expect("*");
  }
  std::string array = take();
  expect_all({"[", code::kCounter, "]", is_of_entries ? "<" : ">"});
  whole_literal(is_of_entries ? "1.0" : "0.0");
  expect(";");
  if (has_braces) expect("}");
  if (end <= first || end > kMostEntries) fail("another number of entries");
  if (is_of_entries) {
    add(code::CheckFinite{std::move(array), static_cast<std::size_t>(first), static_cast<std::size_t>(end)});
  } else {
    if (first != 0) fail("another number of pivots");
    add(code::CheckPositive{std::move(array), static_cast<std::size_t>(end)});
  }
}

}  // namespace flatdyn
