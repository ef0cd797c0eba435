// SPDX-License-Identifier: GPL-2.0-or-later
// Nodes → expressions: which order the terms of sums have, and which products are fused with sums.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "code/expression.hpp"
#include "graph/graph.hpp"

namespace flatdyn {

// The variable that holds a node, by id; empty for a node that is written inline where it is used.
using VariableNames = std::vector<std::string>;

// Nodes that are no variables but read wherever they are used.
using ReadInPlace = std::map<NodeId, code::Expression>;

// Variables in place of operands and coefficients, by the node whose expression has them and the operand; -1 as
// operand: the constant of a sum. The size of a coefficient is replaced, its sign is not.
struct GivenOperands {
  std::map<std::pair<NodeId, NodeId>, std::string> operands, coefficients;
};

class NodeExpressions {
 public:
  // `is_fused`: by node, which products are multiplied and added at once in sums; empty: sums are plain.
  NodeExpressions(const Graph& graph, const VariableNames& names, std::vector<bool> is_fused = {},
                  const ReadInPlace* in_place = nullptr, const GivenOperands* given = nullptr);

  // The right-hand side of the node's variable: "c_2 * omega_1_x + s_2 * omega_1_y".
  code::Expression definition(NodeId id) const;
  // The node in a place of its own: its variable, or its definition.
  code::Expression use(NodeId id) const;
  // The terms of a sum, its constant included (node -1), in the order of its expression.
  std::vector<Term> terms_in_order(NodeId id) const;

 private:
  struct Summand {
    Rational coefficient;
    NodeId node;          // of the factor; -1 for the constant
    int size;             // its typical magnitude, as a power of two
    std::string by_name;  // a variable in place of the coefficient's size

    bool is_constant() const { return node < 0; }
    bool is_plain() const { return !is_constant() && by_name.empty() && abs(coefficient) == 1; }
  };

  code::Expression operand(NodeId user, NodeId id) const;
  std::string coefficient_of(NodeId user, NodeId id) const;
  code::Expression sum(NodeId id, bool negated) const;
  code::Expression plain_sum(NodeId user, const std::vector<Summand>& items) const;
  code::Addend first_addend(NodeId user, const Summand& item) const;
  code::Expression magnitude(NodeId user, const Summand& item) const;
  code::Expression fused_sum(NodeId user, std::vector<Summand> items) const;
  code::Expression fused(const Summand& product, code::Expression sum) const;
  bool is_multiplied_in_sums(const Summand& item) const;
  std::vector<Summand> summands(NodeId id, bool negated) const;
  static std::vector<Summand> small_first(std::vector<Summand> items);
  std::optional<NodeId> negated_sum(const Node& node) const;
  std::vector<code::Expression> operands(NodeId id) const;

  const Graph& graph_;
  const VariableNames& names_;
  std::vector<bool> is_fused_;
  std::vector<double> magnitudes_;
  const ReadInPlace* in_place_;  // nullptr: none
  const GivenOperands* given_;   // nullptr: none
};

}  // namespace flatdyn
