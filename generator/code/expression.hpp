// SPDX-License-Identifier: GPL-2.0-or-later
// The expressions of emitted code, before any language. The tree is the order of evaluation: sums and products go from
// the left, and each operation is rounded.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "graph/rational.hpp"

namespace flatdyn::code {

struct Expression;
struct Addend;

// A constant.
struct Literal {
  Rational value;
};

// A local variable: c_2.
struct Variable {
  std::string name;
};

// An entry of an array: q[2]. In a loop, the entry of its counter is that of `kCounted`.
struct Element {
  std::string array;
  int index = 0;
};
inline constexpr int kCounted = -1;

// A number that is declared before it is stored.
struct Number {
  std::string name;
};

// The value of a free symbol of the robot, a field of the structure of this name.
inline constexpr const char* kParameters = "parameters";
struct Parameter {
  std::string name;
};

// A field of a structure: stage.x1.
struct Field {
  std::string structure, name;
};

// An entry of an output that an earlier kernel has written.
struct WrittenEntry {
  std::string output;
  int index = 0;
};

struct Sum {
  std::vector<Addend> addends;  // one: its value, or the value's negative
};

struct Product {
  std::vector<Expression> operands;
};

struct Quotient {
  std::vector<Expression> operands;  // the dividend and the divisor
};

struct Negation {
  std::vector<Expression> operands;  // one
};

// Operations that languages call by a name. multiply_add: a b + c, rounded once. excess: its operands are a sum and the
// first term of that sum; the value is positive if the rounded sum is above the term.
enum class Operation { sign, sqrt, sine, cosine, multiply_add, excess };

struct Call {
  Operation operation = Operation::sign;
  std::vector<Expression> operands;
};

using AnyExpression = std::variant<Literal, Variable, Element, Number, Parameter, Field, WrittenEntry, Sum, Product,
                                   Quotient, Negation, Call>;

struct Expression : AnyExpression {
  using AnyExpression::AnyExpression;
};

struct Addend {
  bool is_negative = false;
  Expression value;
};

// The expression without its leading minus, and whether it had one. Sums of several addends are left as they are.
Addend without_sign(Expression expression);

// Whether the expression is a value or a call, which binds more tightly than any operator.
bool is_atom(const Expression& expression);

}  // namespace flatdyn::code
