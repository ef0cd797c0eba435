// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion of nodes to expressions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emit/dialect.hpp"
#include "emit/magnitudes.hpp"
#include "graph/graph.hpp"

namespace flatdyn {

// The variable that holds a node, by id; empty for a node that is written inline where it is used.
using VariableNames = std::vector<std::string>;

// Whether code has fused multiply-adds.
bool has_fused(const std::string& code);

// Variables in place of operands and coefficients, by the node whose expression has them and the operand; -1 as
// operand: the constant of a sum. The size of a coefficient is replaced, its sign is not.
struct GivenOperands {
  std::map<std::pair<NodeId, NodeId>, std::string> operands, coefficients;
};

class ExpressionPrinter {
 public:
  // `is_fused`: by node, which products are multiplied and added at once in sums; empty: sums are plain.
  ExpressionPrinter(const Graph& graph, const VariableNames& names, const Dialect& dialect,
                    std::vector<bool> is_fused = {}, const GivenOperands* given = nullptr)
      : graph_(graph),
        names_(names),
        dialect_(dialect),
        is_fused_(std::move(is_fused)),
        magnitudes_(typical_magnitudes(graph)),
        given_(given) {}

  // The right-hand side of the node's variable: "c_2 * omega_1_x + s_2 * omega_1_y".
  std::string definition(NodeId id) const { return define(id).code; }
  // The node in a place of its own: its variable, or its definition.
  std::string use(NodeId id) const { return reference(id).code; }
  // The terms of a sum, its constant included (node -1), in the order of its expression.
  std::vector<Term> terms_in_order(NodeId id) const;

 private:
  // The precedence of the outermost operator. A leading minus binds like a sum, so that it never meets another sign.
  enum class Binding { sum, quotient, product, atom };
  struct Text {
    std::string code;
    Binding binding = Binding::atom;
  };

  struct Summand {
    Rational coefficient;
    std::string factor;  // empty for the constant
    Binding binding;
    int size;               // its typical magnitude, as a power of two
    NodeId node;            // of the factor; -1 for the constant
    std::string by_name{};  // a variable in place of the coefficient's size
  };

  Text define(NodeId id) const;
  Text reference(NodeId id) const;
  std::string operand(NodeId user, NodeId id, Binding at_least) const;  // in parentheses if it binds less tightly
  std::string coefficient_of(NodeId user, NodeId id) const;
  std::string size_text(const Summand& item) const;
  Text sum(NodeId id, bool negated) const;
  Text plain_sum(const std::vector<Summand>& items) const;
  Text fused_sum(std::vector<Summand> items) const;
  std::string fused(const Summand& product, const std::string& sum) const;
  bool is_multiplied_in_sums(const Summand& item) const;
  std::vector<Summand> summands(NodeId id, bool negated) const;
  static std::vector<Summand> small_first(std::vector<Summand> items);
  std::optional<NodeId> negated_sum(const Node& node) const;
  Text product(NodeId id) const;
  Text quotient(NodeId id) const;

  const Graph& graph_;
  const VariableNames& names_;
  const Dialect& dialect_;
  std::vector<bool> is_fused_;
  std::vector<double> magnitudes_;
  const GivenOperands* given_;  // nullptr: none
};

}  // namespace flatdyn
