// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/kernel/derivation.hpp"

#include <algorithm>
#include <sstream>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

[[noreturn]] void cannot_import(const Number& expression) {
  std::ostringstream text;
  text << "expression cannot cross into the graph: " << expression;
  throw Failure(FailureKind::unsupported, text.str(),
                "use rational expressions, sin, cos and tanh of the free symbols");
}

// The text of an expression; it does not depend on the order in which GiNaC keeps operands.
std::string canonical_text(const Number& e) {
  std::ostringstream head;
  if (GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::numeric>(e)) {
    head << e;
    return head.str();
  }
  const GiNaC::basic& object = GiNaC::ex_to<GiNaC::basic>(e);
  head << (GiNaC::is_a<GiNaC::function>(e) ? GiNaC::ex_to<GiNaC::function>(e).get_name() : typeid(object).name());
  std::vector<std::string> operands;
  for (const Number& operand : e) operands.push_back(canonical_text(operand));
  if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) std::sort(operands.begin(), operands.end());
  std::string text = head.str() + "(";
  for (const std::string& operand : operands) text += operand + ",";
  return text + ")";
}

bool is_foreign(const Number& factor) {
  if (GiNaC::is_a<GiNaC::function>(factor)) return true;
  return GiNaC::is_a<GiNaC::power>(factor) && !factor.op(1).info(GiNaC::info_flags::posint);
}

}  // namespace

Derivation::Derivation(const std::vector<GiNaC::symbol>& parameters) {
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const NodeId id = graph_.input({InputKind::parameter, static_cast<int>(k)});
    node_of_[parameters[k]] = id;
    symbol_of_[id] = parameters[k];
  }
}

Number Derivation::input(InputKind kind, int index) { return symbol_of(graph_.input({kind, index})); }

Number Derivation::symbol_of(NodeId id) {
  const auto known = symbol_of_.find(id);
  if (known != symbol_of_.end()) return known->second;
  const GiNaC::symbol symbol;
  symbol_of_[id] = symbol;
  node_of_[symbol] = id;
  return symbol;
}

// The symbol of a node. Numbers stay numbers and negatives stay negatives, as signs must be visible to GiNaC's
// collection of like terms.
Number Derivation::name_node(NodeId id, const std::string& name) {
  const Node& node = graph_[id];
  if (node.op == Op::constant) return to_number(node.value);
  if (node.op == Op::sum && node.terms.size() == 1 && node.value == 0) {
    const Rational coefficient = node.terms[0].coefficient;
    // The name belongs to the negative; its operand keeps its own name, or none.
    if (coefficient == -1) return -name_node(node.terms[0].node, "");
  }
  if (node.op != Op::input && !name.empty()) graph_.set_name(id, name);
  return symbol_of(id);
}

Number Derivation::named(const Number& expression, const std::string& name) {
  const NodeId id = node(expression);
  return is_rational(expression) ? expression : name_node(id, name);
}

Vec3 Derivation::named(const Vec3& expression, const std::string& name) {
  return {named(expression[0], name + "_x"), named(expression[1], name + "_y"), named(expression[2], name + "_z")};
}

Mat3 Derivation::named_symmetric(const Mat3& expression, const std::string& name) {
  static const char* const kAxes[] = {"x", "y", "z"};
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      result[i][j] = result[j][i] = named(expression[i][j], name + "_" + kAxes[i] + kAxes[j]);
    }
  }
  return result;
}

Number Derivation::sin(const Number& angle, const std::string& name) {
  return name_node(graph_.sin(node(angle)), name);
}

Number Derivation::cos(const Number& angle, const std::string& name) {
  return name_node(graph_.cos(node(angle)), name);
}

Number Derivation::sign(const Number& argument, const std::string& name) {
  return name_node(graph_.sign(node(argument)), name);
}

Number Derivation::sqrt(const Number& argument, const std::string& name) {
  return name_node(graph_.sqrt(node(argument)), name);
}

Number Derivation::tanh(const Number& argument, const std::string& name) {
  return name_node(graph_.tanh(node(argument)), name);
}

Number Derivation::quotient(const Number& numerator, const Number& denominator, const std::string& name) {
  const NodeId above = node(numerator);
  return name_node(graph_.quotient(above, node(denominator)), name);
}

// Makes nodes of factors that are not symbols yet: sin, cos and reciprocals of free symbols. They are processed in the
// order of their canonical text, whatever order GiNaC has them in.
void Derivation::import_foreign_factors(const Number& expanded) {
  std::map<std::string, Number> foreign;
  const auto visit_factor = [&](const Number& factor) {
    if (is_foreign(factor) && !node_of_.contains(factor)) foreign.emplace(canonical_text(factor), factor);
  };
  const auto visit_term = [&](const Number& term) {
    if (GiNaC::is_a<GiNaC::mul>(term)) {
      for (const Number& factor : term) visit_factor(factor);
    } else {
      visit_factor(term);
    }
  };
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    for (const Number& term : expanded) visit_term(term);
  } else {
    visit_term(expanded);
  }
  for (const auto& [text, factor] : foreign) node_of_[factor] = import_foreign(factor);
}

NodeId Derivation::import_foreign(const Number& factor) {
  if (GiNaC::is_a<GiNaC::power>(factor)) {
    const Number exponent = factor.op(1);
    if (!exponent.info(GiNaC::info_flags::negint)) cannot_import(factor);
    return graph_.quotient(graph_.constant(1), node(GiNaC::pow(factor.op(0), -exponent)));
  }
  const std::string name = GiNaC::is_a<GiNaC::function>(factor) ? GiNaC::ex_to<GiNaC::function>(factor).get_name() : "";
  if (name == "sin") return graph_.sin(node(factor.op(0)));
  if (name == "cos") return graph_.cos(node(factor.op(0)));
  if (name == "tanh") return graph_.tanh(node(factor.op(0)));
  cannot_import(factor);
}

void Derivation::multiply_by(const Number& factor, Monomial& monomial) const {
  if (is_rational(factor)) {
    monomial.coefficient *= to_rational(factor);
    return;
  }
  const bool is_power = GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::posint);
  const int repeat = is_power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
  const auto known = node_of_.find(is_power ? factor.op(0) : factor);
  if (known == node_of_.end()) cannot_import(factor);
  monomial.factors.insert(monomial.factors.end(), static_cast<std::size_t>(repeat), known->second);
}

Derivation::Monomial Derivation::monomial(const Number& term) {
  Monomial result;
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (const Number& factor : term) multiply_by(factor, result);
  } else {
    multiply_by(term, result);
  }
  std::sort(result.factors.begin(), result.factors.end());
  return result;
}

NodeId Derivation::node(const Number& expression) {
  const Number e = expression.expand();
  import_foreign_factors(e);
  std::vector<Monomial> monomials;
  if (GiNaC::is_a<GiNaC::add>(e)) {
    for (const Number& term : e) monomials.push_back(monomial(term));
  } else {
    monomials.push_back(monomial(e));
  }
  std::sort(monomials.begin(), monomials.end(),
            [](const Monomial& a, const Monomial& b) { return a.factors < b.factors; });
  Rational constant = 0;
  std::vector<Term> terms;
  for (const Monomial& m : monomials) {
    if (m.factors.empty()) {
      constant += m.coefficient;
    } else {
      terms.push_back({m.coefficient, graph_.product(m.factors)});
    }
  }
  return graph_.sum(std::move(terms), constant);
}

}  // namespace flatdyn
