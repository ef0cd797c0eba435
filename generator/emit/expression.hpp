// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion of nodes to expressions.
#pragma once

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

class ExpressionPrinter {
 public:
  // `is_fused`: by node, which products are multiplied and added at once in sums; empty: sums are plain.
  ExpressionPrinter(const Graph& graph, const VariableNames& names, const Dialect& dialect,
                    std::vector<bool> is_fused = {})
      : graph_(graph),
        names_(names),
        dialect_(dialect),
        is_fused_(std::move(is_fused)),
        magnitudes_(typical_magnitudes(graph)) {}

  // The right-hand side of the node's variable: "c_2 * omega_1_x + s_2 * omega_1_y".
  std::string definition(NodeId id) const { return define(id).code; }
  // The node in a place of its own: its variable, or its definition.
  std::string use(NodeId id) const { return reference(id).code; }

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
    int size;     // its typical magnitude, as a power of two
    NodeId node;  // of the factor; -1 for the constant
  };

  Text define(NodeId id) const;
  Text reference(NodeId id) const;
  std::string operand(NodeId id, Binding at_least) const;  // in parentheses if it binds less tightly
  Text sum(const Node& node, bool negated) const;
  Text plain_sum(const std::vector<Summand>& items) const;
  Text fused_sum(std::vector<Summand> items) const;
  std::string fused(const Summand& product, const std::string& sum) const;
  bool is_multiplied_in_sums(const Summand& item) const;
  std::vector<Summand> summands(const Node& node, bool negated) const;
  static std::vector<Summand> small_first(std::vector<Summand> items);
  const Node* negated_sum(const Node& node) const;
  Text product(const Node& node) const;
  Text quotient(const Node& node) const;

  const Graph& graph_;
  const VariableNames& names_;
  const Dialect& dialect_;
  std::vector<bool> is_fused_;
  std::vector<double> magnitudes_;
};

}  // namespace flatdyn
