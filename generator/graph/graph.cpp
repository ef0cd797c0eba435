// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/graph.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace flatdyn {
namespace {

std::size_t mixed(std::size_t seed, std::size_t value) {
  return seed ^ (value + 0x9e3779b97f4a7c15ULL + (seed << 12) + (seed >> 4));
}

std::size_t hash_of(const Node& node) {
  std::size_t hash = mixed(static_cast<std::size_t>(node.op), node.value.hash());
  hash = mixed(hash, static_cast<std::size_t>(node.input.kind));
  hash = mixed(hash, static_cast<std::size_t>(node.input.index));
  for (const Term& term : node.terms) {
    hash = mixed(mixed(hash, term.coefficient.hash()), static_cast<std::size_t>(term.node));
  }
  for (const NodeId operand : node.operands) hash = mixed(hash, static_cast<std::size_t>(operand));
  return hash;
}

// Sorts terms by node, adds up the coefficients of each node and drops terms that cancel.
void collect(std::vector<Term>& terms) {
  std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.node < b.node; });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < terms.size();) {
    Term total = std::move(terms[k]);
    for (++k; k < terms.size() && terms[k].node == total.node; ++k) total.coefficient += terms[k].coefficient;
    if (!total.coefficient.is_zero()) terms[kept++] = std::move(total);
  }
  terms.resize(kept);
}

// The positive number by which to divide a sum of several terms so that its coefficients are whole and without a common
// divisor; 1 for other nodes.
Rational common_divisor(const Node& node) {
  if (node.op != Op::sum || node.terms.size() < 2) return 1;
  auto divisor = numerator(node.terms.front().coefficient), multiple = denominator(node.terms.front().coefficient);
  for (const Term& term : node.terms) {
    divisor = gcd(divisor, numerator(term.coefficient));
    multiple = lcm(multiple, denominator(term.coefficient));
  }
  return Rational(divisor, multiple);
}

}  // namespace

// Enters the nodes that are not in the index yet.
void Graph::index_all() {
  for (; indexed_ < size(); ++indexed_) {
    index_.find_or_add(mixed_bits(hash_of((*this)[indexed_])), indexed_, [](NodeId) { return false; });
  }
}

NodeId Graph::intern(Node node) {
  if (indexed_ < size()) index_all();
  const NodeId next = size();
  const NodeId found =
      index_.find_or_add(mixed_bits(hash_of(node)), next, [&](NodeId id) { return (*this)[id] == node; });
  if (found == next) {
    nodes_.push_back(std::move(node));
    ++indexed_;
  }
  return found;
}

NodeId Graph::constant(const Rational& value) {
  Node node;
  node.op = Op::constant;
  node.value = value;
  return intern(std::move(node));
}

NodeId Graph::input(Input input) {
  Node node;
  node.op = Op::input;
  node.input = input;
  return intern(std::move(node));
}

NodeId Graph::sum(std::vector<Term> terms, const Rational& constant) {
  for (Term& term : terms) {
    // A scaled node may be an operand of another one only if a pass kept it there.
    while (is_scaled(term.node)) {
      const Term& dot = (*this)[term.node].terms.front();
      term.coefficient *= dot.coefficient;
      term.node = dot.node;
    }
  }
  return make_sum(std::move(terms), constant);
}

NodeId Graph::sum_without_folding(std::vector<Term> terms, const Rational& constant) {
  const bool alone = terms.size() == 1 && constant.is_zero();
  for (Term& term : terms) {
    while (is_scaled(term.node)) {
      const Term& dot = (*this)[term.node].terms.front();
      if (!alone && abs(term.coefficient) == 1 && abs(dot.coefficient) != 1) break;
      term.coefficient *= dot.coefficient;
      term.node = dot.node;
    }
  }
  return make_sum(std::move(terms), constant);
}

// Folds constants, collects like terms and makes the sign canonical. Nodes of terms are not expanded.
NodeId Graph::make_sum(std::vector<Term> terms, Rational constant) {
  for (Term& term : terms) {
    if (!is_constant(term.node)) continue;
    constant += term.coefficient * (*this)[term.node].value;
    term.coefficient = 0;
  }
  collect(terms);
  if (terms.empty()) return this->constant(constant);
  if (terms.size() == 1 && constant.is_zero()) {
    if (terms[0].coefficient == 1) return terms[0].node;
    // Collecting like terms has left a single unfolded term.
    if (is_scaled(terms[0].node)) return sum(std::move(terms));
  } else if (terms[0].coefficient < 0) {
    for (Term& term : terms) term.coefficient = -term.coefficient;
    return scaled(-1, make_sum(std::move(terms), -constant));
  }
  Node node;
  node.op = Op::sum;
  node.value = std::move(constant);
  node.terms = std::move(terms);
  return intern(std::move(node));
}

NodeId Graph::scaled(const Rational& coefficient, NodeId node) {
  return coefficient == 1 && !is_scaled(node) ? node : sum({{coefficient, node}});
}

NodeId Graph::product(std::vector<NodeId> factors) {
  Rational coefficient = 1;
  std::vector<NodeId> flat;
  flat.reserve(factors.size());
  while (!factors.empty()) {
    const Node& node = (*this)[factors.back()];
    const NodeId id = factors.back();
    factors.pop_back();
    if (node.op == Op::constant) {
      coefficient *= node.value;
    } else if (flatdyn::is_scaled(node)) {
      coefficient *= node.terms.front().coefficient;
      factors.push_back(node.terms.front().node);
    } else if (node.op == Op::product) {
      factors.insert(factors.end(), node.operands.begin(), node.operands.end());
    } else {
      flat.push_back(id);
    }
  }
  return make_product(coefficient, std::move(flat));
}

NodeId Graph::product_without_folding(const std::vector<NodeId>& factors) {
  Rational coefficient = 1;
  std::vector<NodeId> flat;
  flat.reserve(factors.size());
  for (const NodeId id : factors) {
    const Node& node = (*this)[id];
    if (node.op == Op::constant) {
      coefficient *= node.value;
    } else if (flatdyn::is_scaled(node) && node.terms.front().coefficient == -1) {
      coefficient = -coefficient;
      flat.push_back(node.terms.front().node);
    } else {
      flat.push_back(id);
    }
  }
  return make_product(coefficient, std::move(flat));
}

NodeId Graph::make_product(const Rational& coefficient, std::vector<NodeId> factors) {
  if (coefficient.is_zero() || factors.empty()) return constant(coefficient);
  if (factors.size() == 1) return scaled(coefficient, factors[0]);
  std::sort(factors.begin(), factors.end());
  Node node;
  node.op = Op::product;
  node.operands = std::move(factors);
  return scaled(coefficient, intern(std::move(node)));
}

NodeId Graph::quotient(NodeId numerator, NodeId denominator) {
  Rational coefficient = 1;
  const auto strip = [this](NodeId& id, Rational& factor) {
    while (is_scaled(id)) {
      const Term& dot = (*this)[id].terms.front();
      factor *= dot.coefficient;
      id = dot.node;
    }
  };
  Rational divisor = 1;
  strip(numerator, coefficient);
  strip(denominator, divisor);
  if (is_zero(denominator)) throw std::domain_error("graph: division by the constant 0");
  coefficient /= divisor;
  if (is_constant(denominator)) return scaled(coefficient / (*this)[denominator].value, numerator);
  if (is_zero(numerator)) return numerator;
  if (numerator == denominator) return constant(coefficient);
  bool negative = false;
  if (is_constant(numerator)) {  // k / x is one operation: k stays in it
    coefficient *= (*this)[numerator].value;
    negative = coefficient < 0;
    numerator = constant(abs(coefficient));
    coefficient = negative ? -1 : 1;
  }
  Node node;
  node.op = Op::quotient;
  node.operands = {numerator, denominator};
  return scaled(coefficient, intern(std::move(node)));
}

NodeId Graph::sin(NodeId angle) {
  if (is_zero(angle)) return angle;
  if (is_scaled(angle) && (*this)[angle].terms.front().coefficient < 0) return scaled(-1, sin(scaled(-1, angle)));
  Node node;
  node.op = Op::sin;
  node.operands = {angle};
  return intern(std::move(node));
}

NodeId Graph::cos(NodeId angle) {
  if (is_zero(angle)) return constant(1);
  if (is_scaled(angle) && (*this)[angle].terms.front().coefficient < 0) angle = scaled(-1, angle);
  Node node;
  node.op = Op::cos;
  node.operands = {angle};
  return intern(std::move(node));
}

NodeId Graph::sign(NodeId argument) {
  if (is_constant(argument)) return constant((*this)[argument].value.sign());
  if (is_scaled(argument)) {
    const Term& dot = (*this)[argument].terms.front();
    const int factor = dot.coefficient.sign();
    return scaled(factor, sign(dot.node));
  }
  if ((*this)[argument].op == Op::sign) return argument;
  // A sum of inputs, or of sums, and its multiples have the same sign. The multiple with whole coefficients and no
  // common divisor represents them all. Other sums stay as they are: proofs know them by their values.
  const std::vector<Term>& parts = (*this)[argument].terms;
  const bool is_plain = std::all_of(parts.begin(), parts.end(), [this](const Term& term) {
    const Op op = (*this)[term.node].op;
    return op == Op::input || op == Op::sum;
  });
  const Rational divisor = is_plain ? common_divisor((*this)[argument]) : Rational(1);
  if (divisor != 1) {
    std::vector<Term> terms = (*this)[argument].terms;
    for (Term& term : terms) term.coefficient /= divisor;
    return sign(sum(std::move(terms), (*this)[argument].value / divisor));
  }
  Node node;
  node.op = Op::sign;
  node.operands = {argument};
  return intern(std::move(node));
}

// Among constants only 0 and 1 are folded: their roots are the same in every field.
NodeId Graph::sqrt(NodeId argument) {
  if (is_constant(argument) && ((*this)[argument].value == 0 || (*this)[argument].value == 1)) return argument;
  Node node;
  node.op = Op::sqrt;
  node.operands = {argument};
  return intern(std::move(node));
}

NodeId Graph::tanh(NodeId argument) {
  if (is_zero(argument)) return argument;
  if (is_scaled(argument) && (*this)[argument].terms.front().coefficient < 0) {
    return scaled(-1, tanh(scaled(-1, argument)));
  }
  Node node;
  node.op = Op::tanh;
  node.operands = {argument};
  return intern(std::move(node));
}

NodeId Graph::copy(const Node& node, const std::vector<NodeId>& image) {
  const auto at = [&image](NodeId id) { return image[static_cast<std::size_t>(id)]; };
  switch (node.op) {
    case Op::constant:
      return constant(node.value);
    case Op::input:
      return input(node.input);
    case Op::sum: {
      std::vector<Term> terms = node.terms;
      for (Term& term : terms) term.node = at(term.node);
      return sum_without_folding(std::move(terms), node.value);
    }
    case Op::product: {
      std::vector<NodeId> factors = node.operands;
      for (NodeId& factor : factors) factor = at(factor);
      return product_without_folding(factors);
    }
    case Op::quotient:
      return quotient(at(node.operands[0]), at(node.operands[1]));
    case Op::sin:
      return sin(at(node.operands[0]));
    case Op::cos:
      return cos(at(node.operands[0]));
    case Op::sign:
      return sign(at(node.operands[0]));
    case Op::sqrt:
      return sqrt(at(node.operands[0]));
    case Op::tanh:
      return tanh(at(node.operands[0]));
  }
  throw std::logic_error("graph: a node of no known kind");
}

void Graph::set_name(NodeId id, std::string name) {
  if (can_be_named(id)) name_place(id) = std::make_shared<const std::string>(std::move(name));
}

void Graph::take_name(const Graph& from, NodeId id, NodeId image) {
  const auto k = static_cast<std::size_t>(id);
  if (k < from.names_.size() && from.names_[k] != nullptr && can_be_named(image)) name_place(image) = from.names_[k];
}

// Whether the node may have a name and has none yet.
bool Graph::can_be_named(NodeId id) const {
  const Op op = (*this)[id].op;
  return op != Op::constant && op != Op::input && name(id) == nullptr;
}

std::shared_ptr<const std::string>& Graph::name_place(NodeId id) {
  if (names_.size() <= static_cast<std::size_t>(id)) names_.resize(static_cast<std::size_t>(id) + 1);
  return names_[static_cast<std::size_t>(id)];
}

const std::string* Graph::name(NodeId id) const {
  return static_cast<std::size_t>(id) < names_.size() ? names_[static_cast<std::size_t>(id)].get() : nullptr;
}

// Ids keep their order, so the nodes stay in normal form.
std::vector<NodeId> Graph::remove_all_but(const std::vector<bool>& kept) {
  std::vector<NodeId> image(nodes_.size(), -1);
  const auto replace = [&image](NodeId& id) { id = image[static_cast<std::size_t>(id)]; };
  std::size_t count = 0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (!kept[k]) continue;
    image[k] = static_cast<NodeId>(count);
    for (Term& term : nodes_[k].terms) replace(term.node);
    for (NodeId& operand : nodes_[k].operands) replace(operand);
    if (count < k) {
      if (count < names_.size()) names_[count] = k < names_.size() ? std::move(names_[k]) : nullptr;
      nodes_[count] = std::move(nodes_[k]);
    }
    ++count;
  }
  nodes_.resize(count);
  names_.resize(std::min(names_.size(), count));
  index_ = {};
  indexed_ = 0;
  return image;
}

Term angle_of(const Graph& graph, NodeId id) {
  const NodeId angle = graph[id].operands.front();
  const Term term = graph.is_scaled(angle) ? graph[angle].terms.front() : Term{1, angle};
  if (graph[term.node].op != Op::input) throw std::logic_error("sine or cosine of what is no multiple of an input");
  return term;
}

bool is_of_computed_angle(const Graph& graph, NodeId id) {
  if (graph[id].op != Op::sin && graph[id].op != Op::cos) return false;
  const NodeId angle = graph[id].operands.front();
  return graph[graph.is_scaled(angle) ? graph[angle].terms.front().node : angle].op != Op::input;
}

std::vector<int> rounds_of_sines(const Graph& graph) {
  std::vector<int> rounds;
  for (NodeId id = 0; id < graph.size(); ++id) {
    int round = 0;
    for (const NodeId operand : operands_of(graph[id])) {
      round = std::max(round, rounds[static_cast<std::size_t>(operand)]);
    }
    rounds.push_back(round + (is_of_computed_angle(graph, id) ? 1 : 0));
  }
  return rounds;
}

std::vector<NodeId> operands_of(const Node& node) {
  std::vector<NodeId> operands = node.operands;
  for (const Term& term : node.terms) operands.push_back(term.node);
  return operands;
}

std::vector<bool> reachable_from(const Graph& graph, const std::vector<NodeId>& roots) {
  std::vector<bool> reachable(static_cast<std::size_t>(graph.size()), false);
  for (const NodeId root : roots) reachable[static_cast<std::size_t>(root)] = true;
  for (NodeId id = graph.size() - 1; id >= 0; --id) {
    if (!reachable[static_cast<std::size_t>(id)]) continue;
    for (const NodeId operand : graph[id].operands) reachable[static_cast<std::size_t>(operand)] = true;
    for (const Term& term : graph[id].terms) reachable[static_cast<std::size_t>(term.node)] = true;
  }
  return reachable;
}

bool is_bounded(const Graph& graph, NodeId id) {
  std::vector<bool> used(static_cast<std::size_t>(id) + 1, false);
  used.back() = true;
  for (; id >= 0; --id) {
    const Node& node = graph[id];
    if (!used[static_cast<std::size_t>(id)]) continue;
    if (node.op == Op::sin || node.op == Op::cos || node.op == Op::sign || node.op == Op::tanh) continue;
    if (node.op == Op::input) return false;
    for (const NodeId operand : operands_of(node)) used[static_cast<std::size_t>(operand)] = true;
  }
  return true;
}

}  // namespace flatdyn
