// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/read_body.hpp"

namespace flatdyn {
namespace {

constexpr const char* kLanesType = "Limbs";

bool is_lanes_type(const std::string& name) { return name.starts_with(kLanesType) && name.size() == 6; }

}  // namespace

std::vector<BodyParser::Form> CppBodyParser::forms() {
  has_fused_ = false;
  lengths_.clear();
  return {
      {[this] { return is("for"); }, [this] { loop_of_checks(); }},
      {[this] { return accept("return"); }, [this] { give_back(); }},
      {[this] { return is(code::kValid); }, [this] { further_check(); }},
      {[this] { return is("using"); }, [this] { type_of_lanes(); }},
      {[this] { return is("const") && is_lanes_type(word(1)); }, [this] { lanes(); }},
      {[this] { return accept("const"); }, [this] { expect("Scalar"), definitions(); }},
      {[this] { return accept("bool"); }, [this] { first_check(); }},
      {[this] { return accept("Scalar"); }, [this] { arrays(); }},
      {[this] { return word(1) == "<"; }, [this] { stage(); }},
      {[this] { return is("static_assert"); }, [this] { check_of_scalar(); }},
      {[this] { return is("constexpr"); }, [this] { fused_operation(); }},
      {[this] { return is("sin_cos") || is("DefaultSinCos"); }, [this] { sines(); }},
      {[this] { return word(2) == "Zeros"; }, [this] { zeros(); }},
      {[this] { return is("detail") || word(1) == "("; }, [this] { part(); }},
      {[] { return true; }, [this] { assignment(); }},
  };
}

// Reads the check that every function makes at compile time, as its first statement.
void CppBodyParser::check_of_scalar() {
  if (!is_at_begin()) fail("a check in another place");
  expect_all({"static_assert", "(", "detail", "::", "Interface", "::", "checked", "<", "Scalar", ">", "(", ")"});
  expect_all({")", ";"});
}

// Reads constexpr detail::MultiplyAdd<Scalar> fma{}; which a function has once.
void CppBodyParser::fused_operation() {
  if (has_fused_) fail("an unknown statement");
  has_fused_ = true;
  expect_all({"constexpr", "detail", "::", "MultiplyAdd", "<", "Scalar", ">", "fma", "{", "}", ";"});
}

// Reads sine[joint_count], cosine[joint_count]; or kept[7], pivots[3], result;
void CppBodyParser::arrays() {
  code::Declare declare;
  do {
    declare.arrays.push_back(array());
    const auto& [name, length, count] = declare.arrays.back();
    if ((name == "result") == length.has_value()) fail("an array or a number expected");
    lengths_[name] = length.value_or(1);
  } while (accept(","));
  expect(";");
  add(std::move(declare));
}

// Reads Configuration<Scalar> stage;
void CppBodyParser::stage() {
  code::DeclareStage stage{take(), ""};
  expect_all({"<", "Scalar", ">"});
  stage.name = take();
  expect(";");
  add(std::move(stage));
}

// Reads sin_cos(q, Joints<1, 2>(), sine, cosine); or DefaultSinCos()(angle_1, Joints<0, 1>(), sine_1, cosine_1);
void CppBodyParser::sines() {
  code::FillSines fill;
  fill.is_computed = accept("DefaultSinCos");
  if (fill.is_computed) {
    expect_all({"(", ")", "("});
  } else {
    expect_all({"sin_cos", "("});
  }
  fill.array = take();
  expect_all({",", "Joints", "<"});
  do {
    const int k = index();
    if (!fill.angles.empty() && k <= *fill.angles.rbegin()) fail("joints in another order");
    fill.angles.insert(k);
  } while (accept(","));
  expect_all({">", "(", ")", ","});
  fill.sines = take();
  expect(",");
  fill.cosines = take();
  expect_all({")", ";"});
  add(std::move(fill));
}

// Reads for (const Scalar& pivot : pivots) valid &= pivot > Scalar(0.0); or checks that are counted.
void CppBodyParser::loop_of_checks() {
  expect_all({"for", "("});
  if (!accept("const")) return counted_checks("int", false);
  expect_all({"Scalar", "&", "pivot", ":"});
  code::CheckPositive check{take(), 0};
  check.length = lengths_[check.array];
  expect_all({")", code::kValid, "&=", "pivot", ">"});
  whole_literal("0.0");
  expect(";");
  add(std::move(check));
}

// Reads using Limbs4 = detail::Limbs<Scalar, 4>;
void CppBodyParser::type_of_lanes() {
  expect("using");
  const std::string name = take();
  expect_all({"=", "detail", "::", kLanesType, "<", "Scalar", ","});
  const int lanes = index();
  expect_all({">", ";"});
  if (name != kLanesType + std::to_string(lanes)) fail("an unknown type");
  add(code::UseLanes{lanes});
}

// Reads const Limbs4 x = {q[0], -q[3], q[6], -q[9]}; or const Limbs4 x = sum;
void CppBodyParser::lanes() {
  expect("const");
  const int lanes = take().back() - '0';
  const std::string name = take();
  expect("=");
  if (!accept("{")) {
    add(code::DefineLanes{lanes, name, sum()});
  } else {
    code::Gather gather{lanes, name, {}};
    do {
      gather.numbers.push_back(sum());
    } while (accept(","));
    expect("}");
    add(std::move(gather));
  }
  expect(";");
}

// Reads detail::f_part_1(q, kept, B); parts call one another without detail::.
void CppBodyParser::part() {
  if (!is_part_) expect_all({"detail", "::"});
  call_of_part(false);
}

// Reads detail::Zeros::store<9>(B + 3);
void CppBodyParser::zeros() {
  expect_all({"detail", "::", "Zeros", "::", "store", "<"});
  const int count = index();
  expect_all({">", "("});
  code::StoreZeros zeros{take()};
  if (accept("+")) zeros.first = static_cast<std::size_t>(index());
  zeros.end = zeros.first + static_cast<std::size_t>(count);
  expect_all({")", ";"});
  add(std::move(zeros));
}

// The stage that a member belongs to is *this.
code::Argument CppBodyParser::argument(const ScannedFunction::Parameter& parameter) {
  if (parameter.name != "stored" || is_part_) return BodyParser::argument(parameter);
  expect_all({"*", "this"});
  return {code::Argument::Role::stage, parameter.name, 0, function_->member_of};
}

// Reads B[1], stage.x1 or result.
code::Place CppBodyParser::place() {
  if (is("result")) return code::Number{take()};
  if (word(1) != ".") return BodyParser::place();
  code::Field place{take(), ""};
  expect(".");
  place.name = take();
  return place;
}

code::Expression CppBodyParser::factor() {
  if (accept("Scalar")) {
    expect("(");
    code::Literal value = signed_literal(false);
    expect(")");
    return value;
  }
  if (accept("detail")) return detail_call();
  if (has_fused_ && is("fma") && word(1) == "(") {
    expect_all({"fma", "("});
    return call(code::Operation::multiply_add, 3);
  }
  if (is("result")) return code::Number{take()};
  return word(1) == "." ? member() : variable_or_entry();
}

code::Expression CppBodyParser::detail_call() {
  expect("::");
  const std::string function = take();
  if (function == "Excess") expect_all({"<", "Scalar", ">", "::", "of"});
  expect("(");
  if (function == "sign") return call(code::Operation::sign, 1);
  if (function == "sqrt") return call(code::Operation::sqrt, 1);
  if (function == "Excess") return call(code::Operation::excess, 2);
  if (function != "stored") fail("an unknown function");
  code::WrittenEntry entry{take(), 0};
  expect(",");
  entry.index = index();
  expect(")");
  return entry;
}

code::Expression CppBodyParser::member() {
  const std::string structure = take();
  expect(".");
  const std::string name = take();
  if (structure == code::kParameters) return code::Parameter{name};
  return code::Field{structure, name};
}

// Reads Scalar(0.0).
void CppBodyParser::whole_literal(const char* wanted) { expect_all({"Scalar", "(", wanted, ")"}); }

}  // namespace flatdyn
