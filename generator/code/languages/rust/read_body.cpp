// SPDX-License-Identifier: GPL-2.0-or-later
// Statements of Rust: let x = sum; a last expression is the result.
#include <fmt/format.h>

#include <set>

#include "code/languages/rust/read.hpp"

namespace flatdyn {
namespace {

class RustBodyParser : public BodyParser {
 public:
  RustBodyParser(const EmittedText& text, bool is_float) : BodyParser(text), is_float_(is_float) {}

 private:
  std::vector<Form> forms() override {
    arrays_.clear();
    return {
        {[this] { return is("let") && word(1) == "mut" && word(2) == code::kValid; },
         [this] {
           expect_all({"let", "mut"}), first_check();
         }},
        {[this] { return is("let") && word(1) == "mut"; }, [this] { array_of_zeros(); }},
        {[this] { return is("let") && word(1) == "_"; }, [this] { ignored(); }},
        {[this] { return accept("let"); }, [this] { definition(); }},
        {[this] { return is(code::kValid) && word(1) == "&="; }, [this] { further_checks(); }},
        {[this] { return is("sines_and_cosines"); }, [this] { sines(); }},
        {[this] { return is("["); }, [this] { common_assignment(); }},
        {[this] { return is_call_of_part() && is_last_statement(); }, [this] { call_of_part(true, ""); }},
        {[this] { return is_call_of_part(); }, [this] { call_of_part(false); }},
        {[this] { return is_last_statement(); }, [this] { add(result()); }},
        {[] { return true; }, [this] { assignment(); }},
    };
  }

  bool is_call_of_part() const { return word(1) == "(" && text_.parts().count(word()) != 0 && !is_helper(); }
  // Helpers with results are no statements by themselves.
  bool is_helper() const { return is("sign") || is("sqrt") || is("multiply_add"); }

  void definition() {
    code::Define define;
    std::string name = take();
    expect("=");
    define.constants.push_back({std::move(name), sum()});
    expect(";");
    add(std::move(define));
  }

  // Reads let mut kept = [0.0; 7]; whose length may be the number of angles.
  void array_of_zeros() {
    expect_all({"let", "mut"});
    code::Declare::Array array{take(), std::nullopt};
    arrays_.insert(array.name);
    expect_all({"=", "[", "0.0", ";"});
    if (is_number()) {
      array.length = static_cast<std::size_t>(index());
    } else {
      array.count = text_.count_of_angles().name;
      expect(array.count);
      array.length = static_cast<std::size_t>(text_.count_of_angles().value);
    }
    expect_all({"]", ";"});
    add(code::Declare{{std::move(array)}});
  }

  // Reads let _ = qd; of a parameter that is not read.
  void ignored() {
    expect_all({"let", "_", "="});
    add(code::Ignore{take()});
    expect(";");
  }

  // Reads [B[1], B[7]] = [sum; 2];
  void common_assignment() {
    code::Store store;
    const char* before = "[";
    do {
      expect(before);
      store.places.push_back(place());
      before = ",";
    } while (is(","));
    expect_all({"]", "=", "["});
    store.value = sum();
    expect(";");
    if (index() != static_cast<int>(store.places.size())) fail("another number of places");
    expect_all({"]", ";"});
    add(std::move(store));
  }

  // A part of an array: its first entry, and the one behind its last.
  struct Range {
    std::string array;
    int first = 0, end = 0;
  };

  // Reads q[1..7].
  Range range() {
    Range range{take()};
    expect("[");
    const std::string text = take();
    const std::size_t points = text.find("..");
    if (points != std::string::npos) {
      range.first = number_in(text.substr(0, points));
      range.end = number_in(text.substr(points + 2));
    }
    if (text != fmt::format("{}..{}", range.first, range.end) || range.end <= range.first) fail("a range expected");
    expect("]");
    return range;
  }

  static int number_in(const std::string& text) {
    constexpr std::size_t kMostDigits = 6;
    const bool is_number =
        !text.empty() && text.size() <= kMostDigits && text.find_first_not_of("0123456789") == std::string::npos;
    return is_number ? std::stoi(text) : 0;
  }

  // Reads sines_and_cosines(&q[1..7], &mut sine[1..7], &mut cosine[1..7]);
  void sines() {
    expect_all({"sines_and_cosines", "(", "&"});
    const Range angles = range();
    code::FillSines fill{angles.array};
    for (std::string* name : {&fill.sines, &fill.cosines}) {
      expect_all({",", "&", "mut"});
      const Range other = range();
      if (other.first != angles.first || other.end != angles.end) fail("other sines");
      *name = other.array;
    }
    expect_all({")", ";"});
    fill.is_computed = fill.sines != code::kSines;
    if (!fill.is_computed && angles.end > text_.count_of_angles().value) fail("no such joints");
    for (int k = angles.first; k < angles.end; ++k) fill.angles.insert(k);
    add(std::move(fill));
  }

  // Reads valid &= tau[0..7].iter().all(|x| x.is_finite()); or that *x > 0.0; or a single condition.
  void further_checks() {
    const bool is_of_range = word(3) == "[" && word(4).find("..") != std::string::npos;
    if (!is_of_range) {
      further_check();
      return;
    }
    expect_all({code::kValid, "&="});
    Range entries = range();
    expect_all({".", "iter", "(", ")", ".", "all", "(", "|", "x", "|"});
    const auto first = static_cast<std::size_t>(entries.first), end = static_cast<std::size_t>(entries.end);
    if (accept("*")) {
      expect_all({"x", ">", "0.0"});
      if (first != 0) fail("another number of pivots");
      add(code::CheckPositive{std::move(entries.array), end});
    } else {
      expect_all({"x", ".", "is_finite", "(", ")"});
      add(code::CheckFinite{std::move(entries.array), first, end});
    }
    expect_all({")", ";"});
  }

  // Reads tau[3].is_finite(), or that a sum is positive.
  code::Condition condition() override {
    const bool is_of_entry = word(1) == "[" && word(3) == "]" && word(4) == ".";
    if (!is_of_entry) return BodyParser::condition();
    code::Element entry{take(), 0};
    expect("[");
    entry.index = index();
    expect_all({"]", ".", "is_finite", "(", ")"});
    return code::Finite{std::move(entry)};
  }

  // An array of this function is lent: &sine, &mut kept.
  code::Argument argument(const ScannedFunction::Parameter& parameter) override {
    if (arrays_.count(parameter.name) != 0) {
      expect("&");
      if (parameter.is_output) expect("mut");
    }
    return BodyParser::argument(parameter);
  }

  code::Expression factor() override {
    if (word(1) == "(") {
      const std::string function = take();
      expect("(");
      if (function == "sqrt") return call(code::Operation::sqrt, 1);
      if (function == "multiply_add") return call(code::Operation::multiply_add, 3);
      if (function == "sign") return call(code::Operation::sign, 1);
      fail("an unknown function");
    }
    if (is(code::kParameters) && word(1) == ".") {
      expect_all({code::kParameters, "."});
      return code::Parameter{take()};
    }
    return is_number() ? code::Expression(literal(is_float_, "")) : variable_or_entry();
  }

  void whole_literal(const char* wanted) override { expect(wanted); }

  bool is_float_;
  std::set<std::string> arrays_;  // those of the function that is read
};

}  // namespace

std::unique_ptr<BodyParser> RustReader::body_parser(const EmittedText& text) const {
  return std::make_unique<RustBodyParser>(text, scalar_ == "float");
}

}  // namespace flatdyn
