// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/reader_c.hpp"

#include <fmt/format.h>

#include "readback/file_reader.hpp"
#include "readback/language_reader.hpp"

namespace flatdyn {

std::vector<BodyParser::Form> CBodyParser::forms() {
  return {
      {[this] { return accept("for"); }, [this] { expect("("), counted_checks("int", true); }},
      {[this] { return is("return") && calls_part(1); }, [this] { expect("return"), part(true); }},
      {[this] { return accept("return"); }, [this] { give_back(); }},
      {[this] { return is(code::kValid); }, [this] { further_check(); }},
      {[this] { return accept("const"); }, [this] { expect(text_.scalar()), definitions(); }},
      {[this] { return accept(text_.verdict()); }, [this] { first_check(); }},
      {[this] { return accept(text_.scalar()); }, [this] { arrays(); }},
      {[this] { return accept("("); }, [this] { ignored(); }},
      {[this] { return is_own(word(), "_sines_and_cosines"); }, [this] { sines(); }},
      {[this] { return word(1) == "("; }, [this] { part(false); }},
      {[] { return true; }, [this] { assignment(); }},
  };
}

bool CBodyParser::is_own(const std::string& function, const char* end) const {
  return function.ends_with(end) && text_.parts().count(function) != 0;
}

// Whether a call of a function over arrays follows.
bool CBodyParser::calls_part(std::size_t ahead) const {
  const auto part = text_.parts().find(word(ahead));
  return part != text_.parts().end() && !part->second.parameters.empty() && word(ahead + 1) == "(";
}

// Reads the rest of (void)qd; which all parameters have that are not read.
void CBodyParser::ignored() {
  expect_all({"void", ")"});
  add(code::Ignore{take()});
  expect(";");
}

// Reads sine[ARM_JOINT_COUNT], cosine[ARM_JOINT_COUNT]; or kept[7], pivots[3], result[1];
void CBodyParser::arrays() {
  code::Declare declare;
  do {
    declare.arrays.push_back(array());
    if (!declare.arrays.back().length) fail("an array expected");
  } while (accept(","));
  expect(";");
  add(std::move(declare));
}

// Reads arm_sines_and_cosines(q, 1, 6, sine, cosine); with all angles between the two.
void CBodyParser::sines() {
  take();
  expect("(");
  code::FillSines fill{take(), {}};
  expect(",");
  const int first = index();
  expect(",");
  const int last = index();
  expect_all({",", "sine", ",", "cosine", ")", ";"});
  if (last < first || last >= text_.count_of_angles().value) fail("no such joints");
  for (int k = first; k <= last; ++k) fill.angles.insert(k);
  add(std::move(fill));
}

void CBodyParser::part(bool is_returned) {
  const auto part = text_.parts().find(take());
  if (part == text_.parts().end()) fail("a call of what is no part");
  arguments_of(part->second, is_returned);
}

code::Expression CBodyParser::factor() {
  if (word(1) == "(") {
    const std::string function = take();
    expect("(");
    if (function == root()) return call(code::Operation::sqrt, 1);
    if (is_own(function, "_fma")) return call(code::Operation::multiply_add, 3);
    if (is_own(function, "_excess")) return call(code::Operation::excess, 2);
    if (is_own(function, "_sign")) return call(code::Operation::sign, 1);
    fail("an unknown function");
  }
  if (is(code::kParameters) && word(1) == "->") {
    expect_all({code::kParameters, "->"});
    return code::Parameter{take()};
  }
  return is_number() ? code::Expression(literal(is_float())) : variable_or_entry();
}

void CBodyParser::whole_literal(const char* wanted) { expect(wanted + std::string(is_float() ? "f" : "")); }

namespace {

// Vectors with a lane for each state: arm_lanes_all(0.0825), arm_lanes_all(parameters->m_1), arm_lanes_sqrt(x).
class LanesBodyParser : public CBodyParser {
 public:
  using CBodyParser::CBodyParser;

 private:
  code::Expression factor() override {
    if (word() == spread()) return same_in_all_lanes();
    const bool is_fused = word().ends_with("_fma") && word(1) == "(";
    if (is_number() || is_fused || word(1) == "->") fail("a number of one state");
    return CBodyParser::factor();
  }

  code::Expression same_in_all_lanes() {
    expect_all({spread().c_str(), "("});
    code::Expression value;
    if (is(code::kParameters)) {
      value = CBodyParser::factor();
    } else {
      const bool is_negative = accept("-");
      code::Literal number = literal(is_float());
      if (is_negative) number.value = -number.value;
      value = std::move(number);
    }
    expect(")");
    return value;
  }

  void whole_literal(const char* wanted) override {
    expect_all({spread().c_str(), "("});
    CBodyParser::whole_literal(wanted);
    expect(")");
  }
  std::size_t tokens_of_literal() const override { return 4; }

  // Reads ~(arm_lanes_mask){0}.
  bool accept_always() override {
    if (!accept("~")) return false;
    expect_all({"(", text_.verdict().c_str(), ")", "{", "0", "}"});
    return true;
  }

  std::string root() const override { return text_.scalar() + "_sqrt"; }
  std::string spread() const { return text_.scalar() + "_all"; }
};

class CReader : public LanguageReader {
 public:
  explicit CReader(std::string number) : number_(std::move(number)) {}
  ScannedText scan(const std::vector<Token>& tokens) const override { return scan_c(tokens, number_); }
  std::string scalar(const ScannedText&) const override { return number_; }
  std::string constants() const override { return number_; }
  std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const override {
    return std::make_unique<CBodyParser>(text, number_);
  }
  void read_file(const EmittedText& text, const FileContents& contents) const override { read_c_file(text, contents); }

 protected:
  const std::string& number() const { return number_; }

 private:
  std::string number_;
};

class LanesReader : public CReader {
 public:
  using CReader::CReader;
  std::string scalar(const ScannedText& found) const override { return found.lanes; }
  std::string verdict(const ScannedText& found) const override { return found.lanes + "_mask"; }
  std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const override {
    return std::make_unique<LanesBodyParser>(text, number());
  }
  void read_file(const EmittedText& text, const FileContents& contents) const override {
    read_lanes_file(text, contents);
  }
};

}  // namespace

AnyLanguageReader c_reader(const std::string& scalar) { return std::make_shared<CReader>(scalar); }

AnyLanguageReader lanes_reader(const std::string& scalar) { return std::make_shared<LanesReader>(scalar); }

}  // namespace flatdyn
