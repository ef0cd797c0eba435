// SPDX-License-Identifier: GPL-2.0-or-later
// The statements of one function, executed symbolically one operation after the other.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>

#include "diagnostics/diagnostics.hpp"
#include "readback/emitted_text.hpp"

namespace flatdyn {
namespace {

const std::map<std::string, InputKind>& input_kinds() {
  static const std::map<std::string, InputKind> kinds = {
      {"q", InputKind::q},     {"qd", InputKind::qd},     {"qdd", InputKind::qdd},     {"tau", InputKind::tau},
      {"h_e", InputKind::h_e}, {"qd_r", InputKind::qd_r}, {"qdd_r", InputKind::qdd_r}, {"pi_b", InputKind::pi_b},
  };
  return kinds;
}

}  // namespace

class TextReader {
 public:
  TextReader(const EmittedText& text, const ScannedFunction& written)
      : text_(text), notation_(text.notation_), written_(written) {
    for (const ScannedFunction::Parameter& parameter : written.parameters) {
      if (!parameter.is_output) inputs_.push_back(parameter.name);
    }
  }

  StraightLine read(const Function& like) {
    carry_out(written_);
    std::vector<std::string> outputs;
    for (const ScannedFunction::Parameter& parameter : written_.parameters) {
      if (parameter.is_output) outputs.push_back(parameter.name);
    }
    if (written_.returns != "void" && written_.returns != "bool") outputs = {kReturned};
    if (outputs.size() != like.outputs.size()) fail("another number of outputs");
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      const std::map<int, int>& written = arrays_[outputs[k]];
      std::vector<int> entries(like.outputs[k].entries.size(), -1);
      for (const auto& [entry, value] : written) {
        if (entry >= static_cast<int>(entries.size())) fail("an entry too many");
        entries[static_cast<std::size_t>(entry)] = value;
      }
      if (written_.returns == "bool") check_finite(outputs[k], written);
      lines_.outputs.push_back(std::move(entries));
    }
    return std::move(lines_);
  }

 private:
  static constexpr const char* kReturned = "returned";
  static constexpr const char* kValid = "valid";

  // Every entry that is written must be checked to be finite.
  void check_finite(const std::string& output, const std::map<int, int>& written) const {
    const auto checked = finite_entries_.find(output);
    for (const auto& [entry, value] : written) {
      if (checked == finite_entries_.end() || checked->second.count(entry) == 0) fail("an entry may be infinite");
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::size_t k = std::min(at_, text_.tokens_.size() - 1);
    throw Failure(ExitCode::bug, fmt::format("emitted text cannot be read back: line {}: {} at \"{}\"",
                                             text_.tokens_[k].line, what, text_.tokens_[k].text));
  }

  // The token's text; "" after the end.
  const std::string& word(std::size_t ahead = 0) const {
    static const std::string none;
    return at_ + ahead < text_.tokens_.size() ? text_.tokens_[at_ + ahead].text : none;
  }
  bool is(const char* text) const { return word() == text; }
  bool is_at_end() const { return at_ >= text_.tokens_.size(); }
  std::string take() {
    if (is_at_end()) fail("it ends");
    return text_.tokens_[at_++].text;
  }
  void expect(const char* text) {
    if (!is(text)) fail(fmt::format("\"{}\" expected", text));
    ++at_;
  }
  bool accept(const char* text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }
  void skip_past(const char* text) {
    while (take() != text) {
    }
  }

  // Executes a function or a part. It has variables of its own; arrays are common to all. No part is called twice.
  void carry_out(const ScannedFunction& function) {
    if (!carried_out_.insert(&function).second) fail("a second call of one part");
    const std::size_t back = at_;
    std::map<std::string, int> others = std::move(variables_);
    variables_.clear();
    for (at_ = function.begin; at_ < function.end;) statement();
    variables_ = std::move(others);
    at_ = back;
  }

  void statement() {
    if (is("const") && word(3) == "new") {
      skip_past(";");  // arrays in JavaScript
    } else if (accept("const")) {
      if (notation_.names_types) expect(notation_.scalar.c_str());
      definitions();
    } else if (word() == notation_.scalar || word(1) == "<" || is("(") || is("static_assert")) {
      skip_past(";");  // arrays, an empty stage, "(void)qd;", and compile-time checks
    } else if (accept("sin_cos")) {
      sines_and_cosines();
    } else if (notation_.has_c_functions && ends_with(word(), "_sines_and_cosines")) {
      sines_and_cosines_in_c();
    } else if (accept(notation_.condition)) {
      validity("=");
    } else if (is(kValid) && word(1) == notation_.and_also) {
      validity(notation_.and_also);
    } else if (accept("for")) {
      check_loop();
    } else if (accept("return")) {
      give_back();
    } else if (is("detail") || word(1) == "(") {
      call();
    } else {
      assignment();
    }
  }

  void definitions() {
    do {
      const std::string name = take();
      expect("=");
      if (!variables_.emplace(name, sum()).second) fail("a variable made twice");
    } while (accept(","));
    expect(";");
  }

  // Reads sin_cos(q, Joints<1, 2>(), sine, cosine); or of `angle`, which has been filled.
  void sines_and_cosines() {
    expect("(");
    const std::string angles = take();
    skip_past("<");
    do {
      ask_for_sine(angles, index());
    } while (accept(","));
    skip_past(";");
  }

  void ask_for_sine(const std::string& angles, int k) {
    const int angle = is_input(angles) ? kPosition : angle_at(written_entry(angles, k));
    arrays_["sine"][k] = lines_.sine(k, angle);
    arrays_["cosine"][k] = lines_.cosine(k, angle);
  }

  // The angle of an operation; an entry of q is identified by its index instead.
  int angle_at(int operation) const { return lines_[operation].step == Step::input ? kPosition : operation; }

  bool is_input(const std::string& array) const {
    return std::find(inputs_.begin(), inputs_.end(), array) != inputs_.end();
  }

  static bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
  }

  static bool begins_with_digit(const std::string& text) {
    return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
  }

  // Reads arm_sines_and_cosines(q, 1, 6, sine, cosine); with all angles between the two.
  void sines_and_cosines_in_c() {
    ++at_;
    expect("(");
    const std::string angles = take();
    expect(",");
    const int first = index();
    expect(",");
    const int last = index();
    for (const char* text : {",", "sine", ",", "cosine", ")", ";"}) expect(text);
    constexpr int kMostJoints = 10'000;
    if (last - first > kMostJoints) fail("too many joints");
    for (int k = first; k <= last; ++k) ask_for_sine(angles, k);
  }

  // Reads "Scalar(0.0)" or "0.0f", of this value.
  void literal_of(double value) {
    if (notation_.wraps_literals) expect("Scalar");
    const int read = notation_.wraps_literals ? literal() : plain_literal();
    if (lines_[read].value != value) fail(fmt::format("{} expected", value));
  }
  void zero() { literal_of(0); }

  // Reads "bool valid = true;", "valid &= D_2 > Scalar(0.0);" or "valid &= Scalar(0.0) * qdd[1] < Scalar(1.0);".
  void validity(const char* sign) {
    expect(kValid);
    expect(sign);
    if (is_zero_times()) {
      zero_times();
      const auto [array, entry] = target();
      finite_entries_[array].insert(entry);
      expect("<");
      literal_of(1);
    } else if (!accept("true")) {
      lines_.validity_conditions.push_back(sum());
      expect(">");
      zero();
    }
    expect(";");
  }

  bool is_zero_times() const {
    return notation_.wraps_literals ? is("Scalar") && word(2) == "0.0" && word(4) == "*"
                                    : begins_with_digit(word()) && word(1) == "*";
  }

  void zero_times() {
    zero();
    expect("*");
  }

  // Reads for (const Scalar& pivot : pivots) valid &= pivot > Scalar(0.0); or for (int k = 0; k < 7; ++k) { valid &=
  // pivots[k] > 0.0f; }; and for (int k = 0; k < 7; ++k) valid &= Scalar(0.0) * qdd[k] < Scalar(1.0);
  void check_loop() {
    expect("(");
    if (accept("const")) {
      for (const char* text : {"Scalar", "&", "pivot", ":", "pivots", ")", kValid, "&=", "pivot", ">"}) expect(text);
      zero();
      expect(";");
      add_pivots();
      return;
    }
    for (const char* text : {notation_.counter, "k", "="}) expect(text);
    const int first = index();
    for (const char* text : {";", "k", "<"}) expect(text);
    const int end = index();
    for (const char* text : {";", "+", "+", "k", ")"}) expect(text);
    if (!notation_.wraps_literals) expect("{");
    for (const char* text : {kValid, notation_.and_also}) expect(text);
    counted_check(first, end);
    expect(";");
    if (!notation_.wraps_literals) expect("}");
  }

  // Reads pivots[k] > 0.0, or 0.0 * qdd[k] < 1.0.
  void counted_check(int first, int end) {
    if (accept("pivots")) {
      for (const char* text : {"[", "k", "]", ">"}) expect(text);
      if (first != 0 || end != static_cast<int>(arrays_["pivots"].size())) fail("another number of pivots");
      add_pivots();
      zero();
    } else {
      zero_times();
      std::set<int>& entries = finite_entries_[take()];
      for (const char* text : {"[", "k", "]", "<"}) expect(text);
      constexpr int kMostEntries = 1'000'000;
      if (first < 0 || end - first > kMostEntries) fail("too many entries");
      for (int k = first; k < end; ++k) entries.insert(k);
      literal_of(1);
    }
  }

  void add_pivots() {
    for (const auto& [index, pivot] : arrays_["pivots"]) lines_.validity_conditions.push_back(pivot);
  }

  // Reads what a function returns: valid, a stage, or a value.
  void give_back() {
    if (word(1) == "(" && text_.parts_.count(word()) != 0) {
      call();
      return;
    }
    if (written_.returns == notation_.scalar) {
      const bool is_array = arrays_.count(word()) != 0 && word(1) == ";";
      arrays_[kReturned][0] = is_array ? written_entry(take(), 0) : sum();
    } else if (written_.returns != "bool") {
      arrays_[kReturned] = arrays_[take()];
    } else {
      expect(kValid);
    }
    expect(";");
  }

  // Reads detail::f_part_1(q, kept, B);
  void call() {
    if (accept("detail")) expect("::");
    const auto part = text_.parts_.find(take());
    if (part == text_.parts_.end()) fail("a call of what is no part");
    if (notation_.passes_by_name) {
      arguments_of(part->second);
    } else {
      skip_past(";");
    }
    carry_out(part->second);
  }

  // Checks that every argument has the name of the part's parameter.
  void arguments_of(const ScannedFunction& part) {
    const char* before = "(";
    for (const ScannedFunction::Parameter& parameter : part.parameters) {
      expect(before);
      expect(parameter.name.c_str());
      before = ",";
    }
    expect(")");
    expect(";");
  }

  // Reads "B[1] = B[7] = sum;": entries until there is no further =. The sum is read before any entry is written.
  void assignment() {
    std::vector<std::pair<std::string, int>> targets;
    const std::size_t last = last_assignment();
    while (at_ < last) {
      targets.push_back(target());
      expect("=");
    }
    const int value = sum();
    for (const auto& [array, entry] : targets) arrays_[array][entry] = value;
    expect(";");
  }

  std::size_t last_assignment() const {
    std::size_t last = at_;
    for (std::size_t ahead = 0; word(ahead) != ";" && !word(ahead).empty(); ++ahead) {
      if (word(ahead) == "=") last = at_ + ahead + 1;
    }
    return last;
  }

  // Reads "B[1]", "stage.x1" or "result": an array and the index in it.
  std::pair<std::string, int> target() {
    const std::string name = take();
    if (accept(".")) return {name, field(written_.returns, take())};
    if (!accept("[")) return {name, 0};
    const int entry = index();
    expect("]");
    return {name, entry};
  }

  int field(const std::string& structure, const std::string& name) const {
    const auto fields = text_.fields_.find(structure);
    if (fields == text_.fields_.end()) fail("no struct " + structure);
    const auto found = std::find(fields->second.begin(), fields->second.end(), name);
    if (found == fields->second.end()) fail("no field " + name);
    return static_cast<int>(found - fields->second.begin());
  }

  int index() {
    const std::string text = take();
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) fail("an index expected");
    return value;
  }

  // Reads a sum from left to right; a leading minus changes the sign of the first product.
  int sum() {
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

  int product() {
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

  int factor() {
    if (accept("(")) return in_brackets();
    if (accept("Scalar")) return literal();
    if (!notation_.wraps_literals && begins_with_digit(word())) return plain_literal();
    if (notation_.has_math_object && accept("Math")) return library_call();
    if (notation_.has_c_functions && ends_with(word(), "_sign") && word(1) == "(") {
      at_ += 2;
      return lines_.sign(in_brackets());
    }
    if (notation_.has_c_functions && (is("sqrt") || is("sqrtf")) && word(1) == "(") {
      at_ += 2;
      return lines_.sqrt(in_brackets());
    }
    if (accept("detail")) {
      expect("::");
      const bool is_root = accept("sqrt");
      if (!is_root) expect("sign");
      expect("(");
      return is_root ? lines_.sqrt(in_brackets()) : lines_.sign(in_brackets());
    }
    return named_value(take());
  }

  // Reads .sin(q[2]), .cos(0.5 * q[2]), .sign(sum) or .sqrt(sum).
  int library_call() {
    expect(".");
    const std::string function = take();
    expect("(");
    if (function == "sign") return lines_.sign(in_brackets());
    if (function == "sqrt") return lines_.sqrt(in_brackets());
    if (function != "sin" && function != "cos") fail("an unknown function");
    const int operation = in_brackets();
    const int angle = angle_at(operation), joint = angle < 0 ? lines_[operation].input.index : 0;
    return function == "sin" ? lines_.sine(joint, angle) : lines_.cosine(joint, angle);
  }

  // Reads the rest of a bracketed sum, after the opening bracket.
  int in_brackets() {
    constexpr int kDeepest = 200;
    if (++depth_ > kDeepest) fail("nested too deeply");
    const int value = sum();
    expect(")");
    --depth_;
    return value;
  }

  // Reads (0.0825) or (-2.0).
  int literal() {
    expect("(");
    const bool is_negative = accept("-");
    const std::string text = take();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    if (!is_number) fail("a number expected");
    expect(")");
    return lines_.constant(is_negative ? -value : value);
  }

  // Reads a literal of C or JavaScript, 0.0825 in double or 0.0825f in float, rounded only once, in its own type.
  int plain_literal() {
    const std::string text = take();
    const bool is_float = notation_.scalar == "float";
    const char* const last = text.data() + text.size() - (is_float ? 1 : 0);
    double value = 0;
    float narrow = 0;
    const auto [end, error] =
        is_float ? std::from_chars(text.data(), last, narrow) : std::from_chars(text.data(), last, value);
    if (error != std::errc() || end != last || (is_float && *last != 'f')) fail("a number expected");
    return lines_.constant(is_float ? double(narrow) : value);
  }

  // Reads a variable, an entry of an array, a parameter, or a value that a stage has stored.
  int named_value(const std::string& name) {
    if (accept("[")) {
      const int entry = index();
      expect("]");
      return entry_of(name, entry);
    }
    const bool is_pointed_at = notation_.has_c_functions && is("-") && word(1) == ">";
    if (is_pointed_at) at_ += 1;
    if (accept(is_pointed_at ? ">" : ".")) {
      const std::string member = take();
      if (name == "parameters") return lines_.input({InputKind::parameter, field("Parameters", member)});
      if (name == "stored") return lines_.input({InputKind::stored, field(written_.member_of, member)});
      fail("no such struct");
    }
    const auto known = variables_.find(name);
    if (known != variables_.end()) return known->second;
    return lines_.input({InputKind::stored, field(written_.member_of, name)});
  }

  int entry_of(const std::string& name, int entry) {
    if (is_input(name)) {
      const auto kind = input_kinds().find(name);
      if (kind == input_kinds().end()) fail("an unknown argument");
      return lines_.input({kind->second, entry});
    }
    return written_entry(name, entry);
  }

  int written_entry(const std::string& name, int entry) const {
    const auto array = arrays_.find(name);
    if (array == arrays_.end() || array->second.count(entry) == 0) fail("read before it is written");
    return array->second.at(entry);
  }

  static constexpr int kPosition = -1;  // stands for an angle that is an entry of q

  const EmittedText& text_;
  const EmittedNotation& notation_;
  const ScannedFunction& written_;
  std::vector<std::string> inputs_;
  StraightLine lines_;
  std::map<std::string, int> variables_;
  std::map<std::string, std::map<int, int>> arrays_;
  std::map<std::string, std::set<int>> finite_entries_;  // those that are checked, by output
  std::set<const ScannedFunction*> carried_out_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

// The function with the types of its parameters, which in JavaScript follow from their order.
ScannedFunction EmittedText::as_called(std::size_t k, const Function& like) const {
  ScannedFunction written = functions_.at(k);
  if (notation_.names_types) return written;
  const bool has_symbols = !written.parameters.empty() && written.parameters.front().name == "parameters";
  const bool returns = written.parameters.size() == like.inputs.size() + (has_symbols ? 1 : 0);
  written.returns = returns ? notation_.scalar : like.validity_conditions.empty() ? "void" : "bool";
  const std::size_t outputs = returns ? 0 : like.outputs.size();
  for (std::size_t p = written.parameters.size() - std::min(outputs, written.parameters.size());
       p < written.parameters.size(); ++p) {
    written.parameters[p].is_output = true;
  }
  return written;
}

StraightLine EmittedText::operations(std::size_t k, const Function& like) const {
  const ScannedFunction written = as_called(k, like);
  return TextReader(*this, written).read(like);
}

Function EmittedText::read(std::size_t k, const Function& like) const { return graph_of(operations(k, like), like); }

}  // namespace flatdyn
