// SPDX-License-Identifier: GPL-2.0-or-later
// Statements of JavaScript: no type is named; sin(q[2]) or Math.sin(q[2]), Math.sign(x), parameters.m_1.
#include "code/languages/javascript/read.hpp"

namespace flatdyn {
namespace {

class JavascriptBodyParser : public BodyParser {
 public:
  using BodyParser::BodyParser;

 private:
  std::vector<Form> forms() override {
    return {
        {[this] { return accept("for"); }, [this] { expect("("), counted_checks("let", true); }},
        {[this] { return accept("return"); }, [this] { give_back(); }},
        {[this] { return is(code::kValid); }, [this] { further_check(); }},
        {[this] { return is("const") && word(3) == "new"; }, [this] { expect("const"), arrays(); }},
        {[this] { return accept("const"); }, [this] { definitions(); }},
        {[this] { return accept("let"); }, [this] { first_check(); }},
        {[this] { return word(1) == "("; }, [this] { call_of_part(false); }},
        {[] { return true; }, [this] { assignment(); }},
    };
  }

  // Reads kept = new Float64Array(7), result = new Float64Array(1);
  void arrays() {
    code::Declare declare;
    do {
      std::string name = take();
      expect_all({"=", "new", "Float64Array", "("});
      declare.arrays.push_back({std::move(name), static_cast<std::size_t>(index())});
      expect(")");
    } while (accept(","));
    expect(";");
    add(std::move(declare));
  }

  code::Expression factor() override {
    const bool is_of_library = is("Math") && word(1) == ".";
    if (is_of_library) expect_all({"Math", "."});
    if (is_of_library || word(1) == "(") {
      const std::string function = take();
      expect("(");
      if (function == "sin") return call(code::Operation::sine, 1);
      if (function == "cos") return call(code::Operation::cosine, 1);
      if (is_of_library && function == "sign") return call(code::Operation::sign, 1);
      if (is_of_library && function == "sqrt") return call(code::Operation::sqrt, 1);
      fail("an unknown function");
    }
    if (is(code::kParameters) && word(1) == ".") {
      expect_all({code::kParameters, "."});
      return code::Parameter{take()};
    }
    return is_number() ? code::Expression(literal(false)) : variable_or_entry();
  }

  const char* continues_verdict() const override { return "&&="; }
  void whole_literal(const char* wanted) override { expect(wanted); }
};

}  // namespace

std::unique_ptr<BodyParser> JavascriptReader::body_parser(const EmittedText& text) const {
  return std::make_unique<JavascriptBodyParser>(text);
}

}  // namespace flatdyn
