// SPDX-License-Identifier: GPL-2.0-or-later
// The text of statements that compute all limbs of a set together.
#pragma once

#include <functional>
#include <string>

#include "emit/expression.hpp"
#include "emit/limb_plan.hpp"
#include "emit/names.hpp"

namespace flatdyn {

class LimbText {
 public:
  // `names`: those of variables; members of classes that are taken out of their vectors get others where they would
  // be that of the vector. `source`: the text of an input, a sine or a cosine: "qd[3]".
  LimbText(const Function& function, const LimbPlan& plan, const std::vector<Limbs>& sets, const Dialect& dialect,
           std::function<std::string(NodeId)> source, NameTable& table, VariableNames& names);

  LimbText(const LimbText&) = delete;
  LimbText& operator=(const LimbText&) = delete;

  // The statements before all others: the types of the vectors; and the inputs, sines and cosines that vectors hold.
  std::string types() const;
  std::string given() const;
  bool reads(NodeId given) const { return plan_.is_read[static_cast<std::size_t>(given)]; }
  const std::vector<LimbStep>& steps() const { return plan_.steps; }
  // The statements of a step.
  std::string definition(int of_class) const;
  std::string gathered(int index) const;
  std::string taken(NodeId member) const;
  // The value that is stored: "-t3[1]".
  std::string stored(NodeId id) const;

 private:
  std::string type(int set) const;
  // `is_given`: from the arguments, not from variables, which hold inputs once an output may have overwritten them.
  std::string number(const Term& term, bool is_given) const;
  std::string put_together(const std::string& name, const Gathered& vector, bool is_given) const;
  std::string in_lane(NodeId member, bool is_negative) const;
  const LimbClass& class_of(NodeId member) const;

  const Function& function_;
  const LimbPlan& plan_;
  const std::vector<Limbs>& sets_;
  const Dialect& dialect_;
  std::function<std::string(NodeId)> source_;
  VariableNames vectors_;  // the names in expressions of vectors
  std::vector<std::string> gathered_;
  GivenOperands operands_;
  ExpressionPrinter printer_, vector_printer_;
};

}  // namespace flatdyn
