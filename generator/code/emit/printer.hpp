// SPDX-License-Identifier: GPL-2.0-or-later
// Code → text in languages with the syntax of C. What these differ in, the dialect says.
#pragma once

#include <string>

#include "code/emit/dialect.hpp"
#include "code/emit/header_scope.hpp"
#include "code/statement.hpp"

namespace flatdyn {

class Printer : public TextLength {
 public:
  explicit Printer(const HeaderScope& scope) : scope_(scope), dialect_(scope.dialect) {}

  std::string text(const code::Expression& expression) const { return bound(expression).text; }
  // Indented lines.
  std::string text(const code::Statements& statements) const;
  // The definition of a function.
  std::string text(const code::Part& part) const;

  int lines_of(const code::Statement& statement) const override;
  int lines_of(const code::Statements& statements) const override;
  int lines_of(const code::Part& part) const override;

 private:
  // The precedence of the outermost operator. A leading minus binds like a sum, so that it never meets another sign.
  enum class Binding { sum, quotient, product, atom };
  struct Bound {
    std::string text;
    Binding binding = Binding::atom;
  };

  Bound bound(const code::Expression& expression) const;
  std::string operand(const code::Expression& expression, Binding at_least) const;  // in parentheses if need be
  std::string call(const code::Call& call) const;
  Bound product(const code::Product& product) const;
  Bound sum(const code::Sum& sum) const;

  std::string line(const code::Define& define) const;
  std::string line(const code::Declare& declare) const;
  std::string line(const code::DeclareStage& stage) const;
  std::string line(const code::Store& store) const;
  std::string line(const code::StoreZeros& zeros) const;
  std::string line(const code::FillSines& fill) const;
  std::string line(const code::Check& check) const;
  std::string line(const code::CheckFinite& check) const;
  std::string line(const code::CheckPositive& check) const;
  std::string line(const code::CallPart& call) const;
  std::string line(const code::Return& give_back) const;
  std::string line(const code::Ignore& ignore) const;
  std::string line(const code::UseLanes& use) const;
  std::string line(const code::Gather& gather) const;
  std::string line(const code::DefineLanes& define) const;

  std::string condition(const code::Condition& condition) const;
  std::string place(const code::Place& place) const;
  std::string declared(const code::Argument& argument) const;

  const HeaderScope& scope_;
  const Dialect& dialect_;
};

}  // namespace flatdyn
