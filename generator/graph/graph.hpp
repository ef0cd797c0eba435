// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn's own expression graph: hash-consed, exact, in a total order that depends only on how it was built.
//
// A node is made once and never changes. Operands exist before the node that uses them, so ids are a topological order
// and a total order at once. Sums and products are n-ary and kept in normal form by the constructors below: like terms
// are collected, constants folded, nested products flattened, operands sorted. Signs and coefficients live in sums.
//
// Sums that differ by their sign share one node: the first term of a sum of two or more summands is positive, and the
// negative of the sum is that node scaled by -1 (free). So sum(), quotient(), sin() … may return a scaled node. A sum
// within a sum stays a node of its own, so that what was named stays shared; a scaled node within a sum is folded into
// it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/argument.hpp"
#include "graph/hash_index.hpp"
#include "graph/rational.hpp"

namespace flatdyn {

using NodeId = std::int32_t;

struct Input {
  InputKind kind = InputKind::q;
  int index = 0;

  bool operator==(const Input&) const = default;
};

struct Term {
  Rational coefficient;
  NodeId node = 0;

  bool operator==(const Term&) const = default;
};

enum class Op : std::uint8_t { constant, input, sum, product, quotient, sin, cos, sign, sqrt, tanh };

// One operation. `op` decides which members are used:
//   constant  value
//   input     input
//   sum       value + Σ coefficient_k · node_k; terms sorted by node, no term zero, no node a constant.
//             A single term with value 0 is a scaled node (coefficient not 1).
//             From sum_without_folding only: a term ±1 · a scaled node.
//   product   Π operands, sorted, repeated for powers, at least two; none a constant, a product or a scaled node.
//             From product_without_folding only: an operand may be a product, or a scaled node whose coefficient is not
//             -1.
//   quotient  operands[0] / operands[1]; neither is a scaled node, the denominator is not a constant
//   sin, cos, sign   of operands[0], which is not scaled by a negative number (sign: not scaled at all); sign(0) = 0
//   sqrt      of operands[0], which is not 0 and not 1
//   tanh      of operands[0], which is not 0 and not scaled by a negative number. Nothing emits it: the last pass
//             replaces it (graph/passes/expand_tanh.hpp).
struct Node {
  Op op = Op::constant;
  Rational value = 0;
  Input input;
  std::vector<Term> terms;
  std::vector<NodeId> operands;

  bool operator==(const Node&) const = default;
};

// Whether the node is a scaled node: a sum that is coefficient · node and nothing else.
inline bool is_scaled(const Node& node) { return node.op == Op::sum && node.terms.size() == 1 && node.value.is_zero(); }

// Whether the node is the negative of another one. Negation is free and is written wherever it is used.
inline bool is_negation(const Node& node) { return is_scaled(node) && node.terms[0].coefficient == -1; }

class Graph {
 public:
  // The constructors return the node with this value in normal form; they add a node only if there is none yet.
  NodeId constant(const Rational& value);
  NodeId input(Input input);
  NodeId sum(std::vector<Term> terms, const Rational& constant = 0);
  NodeId product(std::vector<NodeId> factors);
  NodeId scaled(const Rational& coefficient, NodeId node);
  NodeId quotient(NodeId numerator, NodeId denominator);  // throws std::domain_error for the constant denominator 0
  NodeId sin(NodeId angle);
  NodeId cos(NodeId angle);
  NodeId sign(NodeId argument);
  NodeId sqrt(NodeId argument);
  NodeId tanh(NodeId argument);

  // As sum and product, but operands that are scaled nodes or products stay as they are instead of being folded in.
  // Passes use them to keep such a node as an operand where several uses share it, and to copy their results.
  NodeId sum_without_folding(std::vector<Term> terms, const Rational& constant = 0);
  NodeId product_without_folding(const std::vector<NodeId>& factors);

  // Removes all nodes but those kept, whose operands are kept, too. Returns the new ids by the old ones; -1: removed.
  std::vector<NodeId> remove_all_but(const std::vector<bool>& kept);

  // Copies `node` of any graph into this one, operand k becoming image[k]. Nothing is folded.
  NodeId copy(const Node& node, const std::vector<NodeId>& image);

  const Node& operator[](NodeId id) const { return nodes_[static_cast<std::size_t>(id)]; }
  NodeId size() const { return static_cast<NodeId>(nodes_.size()); }

  bool is_constant(NodeId id) const { return (*this)[id].op == Op::constant; }
  bool is_zero(NodeId id) const { return is_constant(id) && (*this)[id].value == 0; }
  // Whether the node is coefficient · node: a single term and no constant.
  bool is_scaled(NodeId id) const { return flatdyn::is_scaled((*this)[id]); }

  // Names a node for readers, e.g. "omega_3_x"; if the node becomes a variable, this is the variable's name. The first
  // name given stays. Constants and inputs have none.
  void set_name(NodeId id, std::string name);
  const std::string* name(NodeId id) const;
  void take_name(const Graph& from, NodeId id, NodeId image);  // names `image` as node `id` of the other graph

 private:
  NodeId intern(Node node);
  void index_all();
  bool can_be_named(NodeId id) const;
  std::shared_ptr<const std::string>& name_place(NodeId id);
  NodeId make_sum(std::vector<Term> terms, Rational constant);
  NodeId make_product(const Rational& coefficient, std::vector<NodeId> factors);

  std::vector<Node> nodes_;
  HashIndex index_;
  NodeId indexed_ = 0;                                     // the number of nodes in the index, which are the first ones
  std::vector<std::shared_ptr<const std::string>> names_;  // by node, as far as there are any; copies share them
};

// Copies the name of a node, if it has one, to its image in another graph.
inline void copy_name(const Graph& from, NodeId id, Graph& to, NodeId image) { to.take_name(from, id, image); }

// The angle of a sine or cosine as a multiple of an input.
Term angle_of(const Graph& graph, NodeId id);  // throws std::logic_error if it is not such a multiple

// Whether a node is the sine or cosine of an angle that the function computes, rather than of a multiple of an input.
bool is_of_computed_angle(const Graph& graph, NodeId id);
// By node: the number of sines of computed angles, each of an angle that depends on the one before, behind its value.
std::vector<int> rounds_of_sines(const Graph& graph);

// All operands of a node, whatever its op, for traversals.
std::vector<NodeId> operands_of(const Node& node);

// Which nodes `roots` reach: element `id` tells whether any of them uses node `id`.
std::vector<bool> reachable_from(const Graph& graph, const std::vector<NodeId>& roots);

// Whether a node depends on inputs by their sines, cosines, signs and tanh alone, so that large inputs do not make it
// large.
bool is_bounded(const Graph& graph, NodeId id);

}  // namespace flatdyn
