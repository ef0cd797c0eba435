// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/c/read_body.hpp"

#include <fmt/format.h>

namespace flatdyn {

std::vector<BodyParser::Form> CBodyParser::forms() {
  return {
      {[this] { return accept("for"); }, [this] { expect("("), counted_checks("int", true); }},
      {[this] { return is("return") && calls_part(1); }, [this] { expect("return"), call_of_part(true); }},
      {[this] { return accept("return"); }, [this] { give_back(); }},
      {[this] { return is(code::kValid); }, [this] { further_check(); }},
      {[this] { return accept("const"); }, [this] { expect(text_.scalar()), definitions(); }},
      {[this] { return accept(text_.verdict()); }, [this] { first_check(); }},
      {[this] { return accept(text_.scalar()); }, [this] { arrays(); }},
      {[this] { return accept("("); }, [this] { ignored(); }},
      {[this] { return is_own(word(), "_sines_and_cosines"); }, [this] { sines(); }},
      {[this] { return word(1) == "("; }, [this] { call_of_part(false); }},
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
  code::FillSines fill{take()};
  expect(",");
  const int first = index();
  expect(",");
  const int last = index();
  expect(",");
  fill.sines = take();
  expect(",");
  fill.cosines = take();
  expect_all({")", ";"});
  fill.is_computed = fill.sines != code::kSines;
  if (last < first || (!fill.is_computed && last >= text_.count_of_angles().value)) fail("no such joints");
  for (int k = first; k <= last; ++k) fill.angles.insert(k);
  add(std::move(fill));
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

}  // namespace flatdyn
