// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/limb_statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace flatdyn {
namespace {

code::Expression with_sign(bool is_negative, code::Expression value) {
  return is_negative ? code::Expression(code::Negation{{std::move(value)}}) : value;
}

}  // namespace

LimbStatements::LimbStatements(const Function& function, const LimbPlan& plan, const std::vector<Limbs>& sets,
                               std::function<code::Expression(NodeId)> source, NameTable& table, VariableNames& names)
    : function_(function),
      plan_(plan),
      sets_(sets),
      source_(std::move(source)),
      vectors_(names),
      scalars_(function.graph, names),
      vector_expressions_(function.graph, vectors_, {}, nullptr, &operands_),
      names_(names) {
  for (std::size_t k = 0; k < plan.gathered.size(); ++k) {
    const bool is_constant = plan.gathered[k].numbers.front().node < 0;
    gathered_.push_back(table.unique(fmt::format("{}{}", is_constant ? "k" : "l", k + 1)));
  }
  for (const auto& [place, index] : plan.operands) {
    operands_.operands[place] = gathered_[static_cast<std::size_t>(index)];
  }
  for (const auto& [place, index] : plan.coefficients) {
    operands_.coefficients[place] = gathered_[static_cast<std::size_t>(index)];
  }
  for (std::size_t k = 0; k < plan.classes.classes.size(); ++k) {
    const LimbClass& each = plan.classes.classes[k];
    if (each.is_given() || plan.is_vector[k]) {
      std::string& of_scalar = names[static_cast<std::size_t>(each.members.front())];
      of_scalar = table.unique(of_scalar + "_of_1");
    }
  }
}

const LimbClass& LimbStatements::class_of(NodeId member) const {
  return plan_.classes.classes[static_cast<std::size_t>(plan_.classes.of(member))];
}

code::Statements LimbStatements::types() const {
  std::set<int> all;
  for (const LimbClass& each : plan_.classes.classes) all.insert(lanes(each.set));
  code::Statements statements;
  for (const int each : all) statements.emplace_back(code::UseLanes{each});
  return statements;
}

code::Expression LimbStatements::number(const Term& term, bool is_given) const {
  if (term.node < 0) return code::Literal{term.coefficient};
  return with_sign(term.coefficient < 0, is_given ? source_(term.node) : scalars_.use(term.node));
}

// The statement that puts a vector together; the last limb fills the lanes that are left.
code::Gather LimbStatements::put_together(const std::string& name, const Gathered& vector, bool is_given) const {
  code::Gather gather{lanes(vector.set), name, {}};
  for (int lane = 0; lane < gather.lanes; ++lane) {
    const auto limb = std::min(static_cast<std::size_t>(lane), vector.numbers.size() - 1);
    gather.numbers.push_back(number(vector.numbers[limb], is_given));
  }
  return gather;
}

code::Statements LimbStatements::given() const {
  code::Statements statements;
  for (const int of : plan_.given) {
    const LimbClass& each = plan_.classes.classes[static_cast<std::size_t>(of)];
    Gathered vector{each.set, {}};
    for (std::size_t limb = 0; limb < each.members.size(); ++limb) {
      vector.numbers.push_back({each.signs[limb], each.members[limb]});
    }
    statements.emplace_back(put_together(vectors_[static_cast<std::size_t>(each.members.front())], vector, true));
  }
  return statements;
}

code::Statement LimbStatements::definition(int of_class) const {
  const LimbClass& each = plan_.classes.classes[static_cast<std::size_t>(of_class)];
  const NodeId first = each.members.front();
  return code::DefineLanes{lanes(each.set), vectors_[static_cast<std::size_t>(first)],
                           vector_expressions_.definition(first)};
}

code::Statement LimbStatements::gathered(int index) const {
  const auto k = static_cast<std::size_t>(index);
  return put_together(gathered_[k], plan_.gathered[k], false);
}

// A number of a vector: t3[1]; negative if that is how the member is computed.
code::Expression LimbStatements::in_lane(NodeId member, bool is_negative) const {
  const LimbClass& each = class_of(member);
  const int limb = plan_.classes.limb(member);
  return with_sign(is_negative != (each.signs[static_cast<std::size_t>(limb)] < 0),
                   code::Element{vectors_[static_cast<std::size_t>(each.members.front())], limb});
}

code::Statement LimbStatements::taken(NodeId member) const {
  return code::Define{{{names_[static_cast<std::size_t>(member)], in_lane(member, false)}}};
}

code::Expression LimbStatements::stored(NodeId id) const {
  const Term value = without_negations(function_.graph, id);
  const Op op = function_.graph[value.node].op;
  const bool is_given = op == Op::input || op == Op::sin || op == Op::cos;
  return !is_given && plan_.classes.has(value.node) ? in_lane(value.node, value.coefficient < 0) : scalars_.use(id);
}

}  // namespace flatdyn
