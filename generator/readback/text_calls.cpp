// SPDX-License-Identifier: GPL-2.0-or-later
// Calls: of parts, and of what computes sines and cosines.
#include <fmt/format.h>

#include <algorithm>

#include "readback/text_reader.hpp"

namespace flatdyn {

// Executes a function or a part. It has variables of its own; arrays are common to all. No part is called twice.
void TextReader::carry_out(const ScannedFunction& function) {
  if (!carried_out_.insert(&function).second) fail("a second call of one part");
  const std::size_t back = at_;
  const ScannedFunction* caller = current_;
  std::map<std::string, int> variables = std::move(variables_);
  std::set<std::string> locals = std::move(locals_);
  std::string checks = std::move(checks_);
  current_ = &function;
  variables_.clear();
  locals_.clear();
  checks_.clear();
  ending_ = Ending::none;
  for (at_ = function.begin; at_ < function.end;) statement();
  if (at_ != function.end) fail("another end");
  const bool is_wanted = ending_ == wanted_ending(function.returns) ||
                         (ending_ == Ending::checked && function.returns == notation_.verdict);
  if (!is_wanted) fail(fmt::format("another result of {}", function.name));
  if (!checks_.empty()) require_all_checked();
  if (!checks_.empty() && ending_ != Ending::checked) fail("checks that are dropped");
  current_ = caller;
  variables_ = std::move(variables);
  locals_ = std::move(locals);
  checks_ = std::move(checks);
  at_ = back;
}

TextReader::Ending TextReader::wanted_ending(const std::string& returns) const {
  if (returns.empty() || returns == "void") return Ending::none;
  if (returns == notation_.scalar) return Ending::value;
  return returns == notation_.verdict ? Ending::always : Ending::stage;
}

// Reads detail::f_part_1(q, kept, B); and returns what the part has returned.
TextReader::Ending TextReader::call() {
  const bool is_in_part = current_ != &written_;
  if (notation_.is_cpp && !is_in_part) expect_all({"detail", "::"});
  const auto part = text_.parts_.find(take());
  if (part == text_.parts_.end()) fail("a call of what is no part");
  arguments_of(part->second);
  carry_out(part->second);
  const Ending ending = ending_;
  ending_ = Ending::none;
  return ending;
}

// Checks that every argument has the name of the part's parameter, and is known here. The stage that a member belongs
// to is *this.
void TextReader::arguments_of(const ScannedFunction& part) {
  const char* before = "(";
  for (const ScannedFunction::Parameter& parameter : part.parameters) {
    expect(before);
    if (notation_.is_cpp && parameter.name == "stored" && current_ == &written_) {
      expect_all({"*", "this"});
    } else {
      if (parameter.name.empty() || !is_visible(parameter.name)) fail("an argument that is not known here");
      expect(parameter.name);
    }
    before = ",";
  }
  if (part.parameters.empty()) expect("(");
  expect_all({")", ";"});
}

// The array whose sines and cosines are asked for.
std::string TextReader::array_of_angles() const { return text_.count("angle_count") == nullptr ? "q" : "angle"; }

void TextReader::begin_sines() {
  for (const char* array : {"sine", "cosine"}) {
    if (locals_.count(array) == 0) fail(fmt::format("no array {}", array));
  }
}

// Reads sin_cos(q, Joints<1, 2>(), sine, cosine); or of `angle`, which has been filled.
void TextReader::sines_and_cosines() {
  if (asked_for_sines_ || current_ != &written_) fail("sines and cosines in another place");
  asked_for_sines_ = true;
  begin_sines();
  const std::string angles = array_of_angles();
  expect("(");
  expect(angles);
  expect_all({",", "Joints", "<"});
  int last = -1;
  do {
    const int k = index();
    if (k <= last) fail("joints in another order");
    ask_for_sine(angles, last = k);
  } while (accept(","));
  expect_all({">", "(", ")", ",", "sine", ",", "cosine", ")", ";"});
}

// Reads arm_sines_and_cosines(q, 1, 6, sine, cosine); with all angles between the two.
void TextReader::sines_and_cosines_in_c() {
  if (text_.parts_.count(take()) == 0) fail("a call of what is no part");
  begin_sines();
  const std::string angles = array_of_angles();
  expect("(");
  expect(angles);
  expect(",");
  const int first = index();
  expect(",");
  const int last = index();
  expect_all({",", "sine", ",", "cosine", ")", ";"});
  if (last >= count_of_sines().value || last < first) fail("no such joints");
  for (int k = first; k <= last; ++k) ask_for_sine(angles, k);
}

void TextReader::ask_for_sine(const std::string& angles, int k) {
  if (has_written_) fail("read after an output is written");
  if (k >= count_of_sines().value) fail("no such joint");
  const bool is_position = angles == "q";
  if (is_position && !is_input(angles)) fail("no argument q");
  const int angle = is_position ? kPosition : angle_at(written_entry(angles, k));
  angles_asked_.insert(k);
  write("sine", k, lines_.sine(k, angle));
  write("cosine", k, lines_.cosine(k, angle));
}

// The angle of an operation; an entry of q is identified by its index instead.
int TextReader::angle_at(int operation) const {
  const Operation& made = lines_[operation];
  return made.step == Step::input && made.input.kind == InputKind::q ? kPosition : operation;
}

}  // namespace flatdyn
