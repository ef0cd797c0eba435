// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/limb_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "emit/writer.hpp"

namespace flatdyn {

LimbText::LimbText(const Function& function, const LimbPlan& plan, const std::vector<Limbs>& sets,
                   const Dialect& dialect, std::function<std::string(NodeId)> source, NameTable& table,
                   VariableNames& names)
    : function_(function),
      plan_(plan),
      sets_(sets),
      dialect_(dialect),
      source_(std::move(source)),
      vectors_(names),
      printer_(function.graph, names, dialect),
      vector_printer_(function.graph, vectors_, dialect, {}, &operands_) {
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

const LimbClass& LimbText::class_of(NodeId member) const {
  return plan_.classes.classes[static_cast<std::size_t>(plan_.classes.of(member))];
}

std::string LimbText::type(int set) const {
  return fmt::format("{}{}", kLimbs, sets_[static_cast<std::size_t>(set)].lanes());
}

std::string LimbText::types() const {
  std::set<int> lanes;
  for (const LimbClass& each : plan_.classes.classes) lanes.insert(sets_[static_cast<std::size_t>(each.set)].lanes());
  std::string text;
  for (const int each : lanes) text += code_line(dialect_.limbs_definition(each), kStatementIndent);
  return text;
}

std::string LimbText::number(const Term& term, bool is_given) const {
  if (term.node < 0) return dialect_.literal(term.coefficient);
  const bool is_negative = term.coefficient < 0;
  const std::string text = is_given ? source_(term.node) : printer_.use(term.node);
  const bool is_atom = text.find(' ') == std::string::npos && text.front() != '-';
  return is_negative ? "-" + (is_atom ? text : "(" + text + ")") : text;
}

// The statement that puts a vector together; the last limb fills the lanes that are left.
std::string LimbText::put_together(const std::string& name, const Gathered& vector, bool is_given) const {
  std::vector<std::string> items;
  const auto lanes = static_cast<std::size_t>(sets_[static_cast<std::size_t>(vector.set)].lanes());
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    items.push_back(number(vector.numbers[std::min(lane, vector.numbers.size() - 1)], is_given));
  }
  return list_line(fmt::format("const {} {} = {{", type(vector.set), name), items, "};", kStatementIndent);
}

std::string LimbText::given() const {
  std::string text;
  for (const int of : plan_.given) {
    const LimbClass& each = plan_.classes.classes[static_cast<std::size_t>(of)];
    Gathered vector{each.set, {}};
    for (std::size_t limb = 0; limb < each.members.size(); ++limb) {
      vector.numbers.push_back({each.signs[limb], each.members[limb]});
    }
    text += put_together(vectors_[static_cast<std::size_t>(each.members.front())], vector, true);
  }
  return text;
}

std::string LimbText::definition(int of_class) const {
  const LimbClass& each = plan_.classes.classes[static_cast<std::size_t>(of_class)];
  const NodeId first = each.members.front();
  const std::string value = vector_printer_.definition(first);
  return code_line(fmt::format("const {} {} = {};", type(each.set), vectors_[static_cast<std::size_t>(first)], value),
                   kStatementIndent);
}

std::string LimbText::gathered(int index) const {
  const auto k = static_cast<std::size_t>(index);
  return put_together(gathered_[k], plan_.gathered[k], false);
}

// A number of a vector: "t3[1]"; negative if that is how the member is computed.
std::string LimbText::in_lane(NodeId member, bool is_negative) const {
  const LimbClass& each = class_of(member);
  const auto limb = static_cast<std::size_t>(plan_.classes.limb(member));
  return fmt::format("{}{}[{}]", is_negative != (each.signs[limb] < 0) ? "-" : "",
                     vectors_[static_cast<std::size_t>(each.members.front())], limb);
}

std::string LimbText::taken(NodeId member) const {
  const std::string& name = printer_.use(member);
  return code_line(fmt::format("{}{} = {};", dialect_.constant(), name, in_lane(member, false)), kStatementIndent);
}

std::string LimbText::stored(NodeId id) const {
  const Term value = without_negations(function_.graph, id);
  const Op op = function_.graph[value.node].op;
  const bool is_given = op == Op::input || op == Op::sin || op == Op::cos;
  return !is_given && plan_.classes.has(value.node) ? in_lane(value.node, value.coefficient < 0) : printer_.use(id);
}

}  // namespace flatdyn
