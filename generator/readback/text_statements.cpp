// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "readback/text_reader.hpp"

namespace flatdyn {
namespace {

bool ends_in(const std::string& text, const std::string& end) { return text.ends_with(end); }

}  // namespace

void TextReader::statement() {
  if (ending_ != Ending::none) fail("a statement after the result");
  if (accept("for")) {
    loop_of_checks();
  } else if (accept("return")) {
    give_back();
  } else if (!checks_.empty()) {
    go_on_with_conditions();
  } else if (is("const") && word(3) == "new") {
    new_arrays();
  } else if (is("using")) {
    type_of_limbs();
  } else if (is("const") && current_ == &written_ && types_of_limbs_.count(word(1)) != 0) {
    expect("const");
    limbs();
  } else if (accept("const")) {
    if (notation_.names_types) expect(notation_.scalar);
    definitions();
  } else if (accept(notation_.condition.c_str())) {
    begin_conditions();
  } else if (notation_.names_types && accept(notation_.scalar.c_str())) {
    arrays();
  } else if (word(1) == "<") {
    stage();
  } else if (is("(")) {
    unread();
  } else if (is("static_assert")) {
    check_of_scalar();
  } else if (is("constexpr")) {
    fused_operation();
  } else if (notation_.is_cpp && accept("sin_cos")) {
    sines_and_cosines();
  } else if (notation_.has_c_functions && ends_in(word(), "_sines_and_cosines")) {
    sines_and_cosines_in_c();
  } else if (is("detail") || word(1) == "(") {
    if (call() != Ending::none) fail("a result that is dropped");
  } else {
    assignment();
  }
}

void TextReader::definitions() {
  do {
    const std::string name = take();
    refuse_known(name);
    expect("=");
    variables_.emplace(name, sum());
  } while (accept(","));
  expect(";");
}

// Reads arrays in JavaScript: const kept = new Float64Array(7), result = new Float64Array(1);
void TextReader::new_arrays() {
  if (!notation_.has_math_object) fail("an unknown statement");
  expect("const");
  do {
    const std::string name = take();
    expect_all({"=", "new", "Float64Array", "("});
    const int length = index();
    const bool is_of_sines = name == "sine" || name == "cosine";
    if (is_of_sines && length < count_of_sines().value) fail("another length");
    if (name == "result" && length != 1) fail("another length");
    if (!is_of_sines && name != "kept" && name != "pivots" && name != "result") fail("an unknown array");
    declare(name, length);
    expect(")");
  } while (accept(","));
  expect(";");
}

// Reads Scalar sine[joint_count], cosine[joint_count]; or Scalar kept[7], pivots[3], result;
void TextReader::arrays() {
  do {
    array_of_numbers(take());
  } while (accept(","));
  expect(";");
}

void TextReader::array_of_numbers(const std::string& name) {
  if (name == "result") {
    if (!notation_.is_cpp) expect_all({"[", "1", "]"});
    declare(name, 1);
    return;
  }
  expect("[");
  if (name == "kept" || name == "pivots") {
    declare(name, index());
  } else if (name == "sine" || name == "cosine" || (name == "angle" && text_.count("angle_count") != nullptr)) {
    expect(count_of_sines().name);
    declare(name, count_of_sines().value);
  } else {
    fail("an unknown array");
  }
  expect("]");
}

// Reads Configuration<Scalar> stage;
void TextReader::stage() {
  if (current_ != &written_ || !notation_.is_cpp || !outputs_.empty()) fail("an unknown statement");
  expect(written_.returns);
  expect_all({"<", "Scalar", ">"});
  const std::string name = take();
  declare(name, static_cast<int>(like_.outputs[0].entries.size()));
  outputs_ = {name};
  expect(";");
}

// Reads (void)qd; in C, whose parameters all have names.
void TextReader::unread() {
  if (!notation_.has_c_functions) fail("an unknown statement");
  expect_all({"(", "void", ")"});
  const std::string name = take();
  if (!is_visible(name) || locals_.count(name) != 0) fail("no parameter");
  expect(";");
}

// Reads the check that every function makes at compile time, as its first statement.
void TextReader::check_of_scalar() {
  if (!notation_.is_cpp || at_ != written_.begin) fail("a check in another place");
  expect_all({"static_assert", "(", "detail", "::", "Interface", "::", "checked", "<", "Scalar", ">", "(", ")"});
  expect_all({")", ";"});
}

// Reads constexpr detail::MultiplyAdd<Scalar> fma{}; which a function has once.
void TextReader::fused_operation() {
  if (!notation_.is_cpp || !locals_.insert("fma").second) fail("an unknown statement");
  expect_all({"constexpr", "detail", "::", "MultiplyAdd", "<", "Scalar", ">", "fma", "{", "}", ";"});
}

// Reads "B[1] = B[7] = sum;": entries until there is no further =. The sum is read before any entry is written.
void TextReader::assignment() {
  std::vector<std::pair<std::string, int>> targets;
  const std::size_t last = last_assignment();
  while (at_ < last) {
    targets.push_back(target());
    expect("=");
  }
  if (targets.empty()) fail("an unknown statement");
  const int value = sum();
  for (const auto& [array, entry] : targets) write(array, entry, value);
  expect(";");
}

std::size_t TextReader::last_assignment() const {
  std::size_t last = at_;
  for (std::size_t ahead = 0; word(ahead) != ";" && !word(ahead).empty(); ++ahead) {
    if (word(ahead) == "=") last = at_ + ahead + 1;
  }
  return last;
}

// Reads "B[1]", "stage.x1" or "result": an array and the index in it.
std::pair<std::string, int> TextReader::target() {
  const std::string name = take();
  if (name == "result" && notation_.is_cpp) return {name, 0};
  if (!notation_.has_c_functions && accept(".")) {
    if (!is_output(name)) fail("no stage");
    return {name, field(written_.returns, take())};
  }
  expect("[");
  const int entry = index();
  expect("]");
  return {name, entry};
}

// Writes an entry, once; only places of values that parts keep are used again.
void TextReader::write(const std::string& array, int entry, int value) {
  const auto found = arrays_.find(array);
  if (found == arrays_.end() || !is_visible(array)) fail("no array " + array);
  if (found->second.length >= 0 && entry >= found->second.length) fail("an entry too many");
  const bool is_new = found->second.entries.insert_or_assign(entry, value).second;
  if (!is_new && array != "kept") fail(fmt::format("{}[{}] is written twice", array, entry));
  has_written_ = has_written_ || is_output(array);
}

// Reads what a function returns: true, positive, a stage, or a value.
void TextReader::give_back() {
  const bool is_on_line = !is_at_end() && text_.tokens_[at_].line == text_.tokens_[at_ - 1].line;
  if (!is_on_line) fail("a result on another line");  // JavaScript would return nothing
  const auto part = text_.parts_.find(word());
  const bool is_call = part != text_.parts_.end() && word(1) == "(" && !part->second.parameters.empty();
  if (notation_.has_c_functions && is_call) {
    ending_ = call();
    return;
  }
  if (current_->returns == notation_.scalar) {
    const bool is_whole = notation_.is_cpp && is("result") && word(1) == ";";
    arrays_[kReturned].entries[0] = is_whole ? written_entry(take(), 0) : sum();
    ending_ = Ending::value;
  } else if (current_->returns == notation_.verdict) {
    ending_ = checks_.empty() ? Ending::always : Ending::checked;
    if (!checks_.empty()) {
      expect(checks_);
    } else if (!accept_always()) {
      fail("true expected");
    }
  } else {
    if (locals_.count(word()) == 0 || !is_output(word())) fail("a result expected");
    ++at_;
    ending_ = Ending::stage;
  }
  expect(";");
}

}  // namespace flatdyn
