// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "readback/text_reader.hpp"

namespace flatdyn {
namespace {

const std::map<std::string, InputKind>& input_kinds() {
  static const std::map<std::string, InputKind> kinds = {
      {"q", InputKind::q},       {"qd", InputKind::qd},       {"qdd", InputKind::qdd},   {"tau", InputKind::tau},
      {"g_b", InputKind::g_b},   {"v", InputKind::v},         {"a", InputKind::a},       {"h_e", InputKind::h_e},
      {"qd_r", InputKind::qd_r}, {"qdd_r", InputKind::qdd_r}, {"pi_b", InputKind::pi_b}, {"v_r", InputKind::v_r},
      {"a_r", InputKind::a_r},
  };
  return kinds;
}

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

bool TextReader::is_input(const std::string& array) const {
  const auto& parameters = written_.parameters;
  return input_kinds().count(array) != 0 && std::any_of(parameters.begin(), parameters.end(), [&](const auto& each) {
           return each.name == array && !each.is_output;
         });
}

// Reads a sum from left to right; a leading minus changes the sign of the first product.
int TextReader::sum() {
  const bool is_negative = accept("-");
  int value = product();
  if (is_negative) value = lines_.negate(value);
  for (;;) {
    if (accept("+")) {
      value = lines_.add(value, product());
    } else if (accept("-")) {
      value = lines_.subtract(value, product());
    } else {
      return value;
    }
  }
}

int TextReader::product() {
  int value = factor();
  for (;;) {
    if (accept("*")) {
      value = lines_.multiply(value, factor());
    } else if (accept("/")) {
      value = lines_.divide(value, factor());
    } else {
      return value;
    }
  }
}

int TextReader::factor() {
  if (accept("(")) return in_brackets();
  if (notation_.is_cpp && accept("Scalar")) return literal();
  if (notation_.has_lanes && word() == notation_.scalar + "_all") return same_in_all_lanes();
  if (!notation_.is_cpp && !notation_.has_lanes && is_floating(word())) return plain_literal();
  if (notation_.has_math_object && accept("Math")) return library_call();
  if (notation_.has_math_object && word(1) == "(" && (word() == "sin" || word() == "cos")) return sine_or_cosine();
  if (notation_.is_cpp && accept("detail")) {
    expect("::");
    const std::string function = take();
    if (function == "Excess") expect_all({"<", "Scalar", ">", "::", "of"});
    expect("(");
    return function == "stored" ? stored_entry() : function_call(function);
  }
  if (notation_.is_cpp && lane_ == kNoLane && locals_.count("fma") != 0 && accept("fma")) {
    expect("(");
    return multiply_add();
  }
  if (notation_.has_c_functions && word(1) == "(") {
    const std::string function = take();
    expect("(");
    const std::string root = notation_.has_lanes              ? notation_.scalar + "_sqrt"
                             : notation_.constants == "float" ? "sqrtf"
                                                              : "sqrt";
    if (function == root) return function_call("sqrt");
    if (!notation_.has_lanes && function.ends_with("_fma") && text_.parts_.count(function) != 0) return multiply_add();
    const bool is_own = text_.parts_.count(function) != 0;
    if (is_own && function.ends_with("_excess")) return function_call("Excess");
    if (!function.ends_with("_sign") || !is_own) fail("an unknown function");
    return function_call("sign");
  }
  return named_value(take());
}

// Reads arm_lanes_all(0.0825) or arm_lanes_all(parameters->m_1).
int TextReader::same_in_all_lanes() {
  ++at_;
  expect("(");
  int value = 0;
  if (accept("parameters")) {
    expect("->");
    value = member_of("parameters");
  } else {
    const bool is_negative = accept("-");
    value = plain_literal();
    if (is_negative) value = lines_.constant(-lines_[value].value);
  }
  expect(")");
  return value;
}

// Reads the arguments of sign, sqrt or Excess, after the opening bracket.
int TextReader::function_call(const std::string& function) {
  if (function == "Excess") {
    const int value = sum();
    expect(",");
    return lines_.subtract(value, in_brackets());
  }
  if (function == "sign") return lines_.sign(scalar_in_brackets());
  if (function != "sqrt") fail("an unknown function");
  return lines_.sqrt(scalar_in_brackets());
}

// Reads .sin(q[2]), .cos(0.5 * q[2]), .sign(sum) or .sqrt(sum).
int TextReader::library_call() {
  expect(".");
  if (word() == "sin" || word() == "cos") return sine_or_cosine();
  const std::string function = take();
  expect("(");
  return function_call(function);
}

// Reads sin(q[2]) or cos(0.5 * q[2]).
int TextReader::sine_or_cosine() {
  const std::string function = take();
  expect("(");
  const int operation = in_brackets();
  const int angle = angle_at(operation), joint = angle < 0 ? lines_[operation].input.index : 0;
  return function == "sin" ? lines_.sine(joint, angle) : lines_.cosine(joint, angle);
}

// Reads the rest of a bracketed sum, after the opening bracket.
int TextReader::in_brackets() {
  constexpr int kDeepest = 200;
  if (++depth_ > kDeepest) fail("nested too deeply");
  const int value = sum();
  expect(")");
  --depth_;
  return value;
}

// Reads the arguments of a fused multiply-add, after the opening bracket.
int TextReader::multiply_add() {
  constexpr int kDeepest = 200;
  if (++depth_ > kDeepest) fail("nested too deeply");
  const int a = sum();
  expect(",");
  const int b = sum();
  expect(",");
  const int c = sum();
  expect(")");
  --depth_;
  return lines_.fused(a, b, c);
}

// Reads (0.0825) or (-2.0).
int TextReader::literal() {
  expect("(");
  const bool is_negative = accept("-");
  const std::string text = take();
  double value = 0;
  if (!is_floating(text) || !reads_as(text, text.size(), value)) fail("a number expected");
  expect(")");
  return lines_.constant(is_negative ? -value : value);
}

// Reads a literal of C or JavaScript, 0.0825 in double or 0.0825f in float, rounded only once, in its own type.
int TextReader::plain_literal() {
  const std::string text = take();
  const bool is_float = notation_.constants == "float";
  double value = 0;
  float narrow = 0;
  const bool is_number = is_floating(text) && (is_float ? text.back() == 'f' && reads_as(text, text.size() - 1, narrow)
                                                        : reads_as(text, text.size(), value));
  if (!is_number) fail("a number expected");
  return lines_.constant(is_float ? double(narrow) : value);
}

// Reads a variable, an entry of an array, a parameter, or a value that a stage has stored.
int TextReader::named_value(const std::string& name) {
  const auto limbs = limbs_.find(name);
  if (limbs != limbs_.end() && current_ == &written_) return value_of_limb(limbs->second);
  if (accept("[")) {
    const int entry = index();
    expect("]");
    return entry_of(name, entry);
  }
  if (!notation_.has_lanes && accept(notation_.has_c_functions ? "->" : ".")) return member_of(name);
  const auto known = variables_.find(name);
  if (known != variables_.end()) return known->second;
  if (current_ != &written_) fail("an unknown name");
  return lines_.input({InputKind::stored, field(written_.member_of, name)});
}

// Reads the rest of parameters.m1 or stored.x1.
int TextReader::member_of(const std::string& name) {
  if (!is_visible(name)) fail("no such struct");
  const std::string member = take();
  if (name == "parameters") return input({InputKind::parameter, field("Parameters", member)});
  if (name != "stored" || !notation_.is_cpp) fail("no such struct");
  return lines_.input({InputKind::stored, field(written_.member_of, member)});
}

// All inputs are read before an output is written, because they may share memory.
int TextReader::input(Input input) {
  if (has_written_) fail("read after an output is written");
  return lines_.input(input);
}

int TextReader::entry_of(const std::string& name, int entry) {
  if (!is_visible(name)) fail("no array " + name);
  if (is_output(name)) fail("an output that is read");
  if (name == "sine" || name == "cosine") angles_read_.insert(entry);
  if (!is_input(name)) return written_entry(name, entry);
  const InputKind kind = input_kinds().at(name);
  const int length = length_of(kind);
  if (length >= 0 && entry >= length) fail("an entry too many");
  return input({kind, entry});
}

// Reads the rest of detail::stored(dqdd_dtau, 5), after the opening bracket: an entry of an output that an earlier part
// of the function has written, and this one does not. Its index is that among all entries of the outputs.
int TextReader::stored_entry() {
  const std::string name = take();
  expect(",");
  const int entry = index();
  expect(")");
  int before = 0;
  for (const std::string& output : outputs_) {
    const Array& array = arrays_.at(output);
    if (output == name) {
      if (!is_visible(name) || entry >= array.length) fail("no such entry");
      if (array.entries.count(entry) != 0) fail("an entry that is written already");
      return lines_.input({InputKind::stored, before + entry});
    }
    before += array.length;
  }
  fail("no output " + name);
}

int TextReader::written_entry(const std::string& name, int entry) const {
  const auto array = arrays_.find(name);
  if (array == arrays_.end() || array->second.entries.count(entry) == 0) fail("read before it is written");
  return array->second.entries.at(entry);
}

}  // namespace flatdyn
