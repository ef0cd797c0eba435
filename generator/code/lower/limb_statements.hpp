// SPDX-License-Identifier: GPL-2.0-or-later
// The statements that compute all limbs of a set together.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "code/lower/expressions.hpp"
#include "code/lower/limb_plan.hpp"
#include "code/lower/names.hpp"
#include "code/statement.hpp"

namespace flatdyn {

class LimbStatements {
 public:
  // `names`: those of variables; members of classes that are taken out of their vectors get others where they would
  // be that of the vector. `source`: an input, a sine or a cosine as it is read: qd[3].
  LimbStatements(const Function& function, const LimbPlan& plan, const std::vector<Limbs>& sets,
                 std::function<code::Expression(NodeId)> source, NameTable& table, VariableNames& names);

  LimbStatements(const LimbStatements&) = delete;
  LimbStatements& operator=(const LimbStatements&) = delete;

  // The statements before all others: the types of the vectors; and the inputs, sines and cosines that vectors hold.
  code::Statements types() const;
  code::Statements given() const;
  bool reads(NodeId given) const { return plan_.is_read[static_cast<std::size_t>(given)]; }
  const std::vector<LimbStep>& steps() const { return plan_.steps; }
  // The statement of a step.
  code::Statement definition(int of_class) const;
  code::Statement gathered(int index) const;
  code::Statement taken(NodeId member) const;
  // The value that is stored: -t3[1].
  code::Expression stored(NodeId id) const;

 private:
  int lanes(int set) const { return sets_[static_cast<std::size_t>(set)].lanes(); }
  // `is_given`: from the arguments, not from variables, which hold inputs once an output may have overwritten them.
  code::Expression number(const Term& term, bool is_given) const;
  code::Gather put_together(const std::string& name, const Gathered& vector, bool is_given) const;
  code::Expression in_lane(NodeId member, bool is_negative) const;
  const LimbClass& class_of(NodeId member) const;

  const Function& function_;
  const LimbPlan& plan_;
  const std::vector<Limbs>& sets_;
  std::function<code::Expression(NodeId)> source_;
  VariableNames vectors_;  // the names in expressions of vectors
  std::vector<std::string> gathered_;
  GivenOperands operands_;
  NodeExpressions scalars_, vector_expressions_;
  const VariableNames& names_;
};

}  // namespace flatdyn
