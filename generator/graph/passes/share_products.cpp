// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/share_products.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

#include "graph/hash_index.hpp"
#include "graph/passes/draft.hpp"

namespace flatdyn {
namespace {

// A factor: a node (>= 0), or -1 - k for constant number k.
using NodeFactor = std::int32_t;
using NodeFactors = std::vector<NodeFactor>;  // sorted, repeated for powers

// A product in use, with the absolute value of its coefficient among the factors.
struct UsedProduct {
  NodeFactors factors;
  int uses = 0;
};

// Greedy extraction of common pairs of factors.
class ProductSharing {
 public:
  explicit ProductSharing(const Function& flat) : draft_(flat) {}

  Function run() {
    collect();
    for (int m = 0; m < static_cast<int>(monomials_.size()); ++m) {
      if (monomials_[at(m)].factors.size() <= kLongest) index_pairs(m);
    }
    for (std::size_t k = 0; k < pairs_.size(); ++k) push(static_cast<int>(k));
    while (!queue_.empty()) extract_next();
    write_back();
    return draft_.finish();
  }

 private:
  static constexpr std::size_t kLongest = 64;  // a longer product is skipped: it would have too many pairs
  struct Pair {
    NodeFactor a, b;         // a <= b
    std::vector<int> where;  // the monomials that had the pair when they were examined
    NodeId node = -1;        // the node of the product, once it exists
  };
  struct Use {  // a sum's term, or, with term = -1, a node that is the product itself
    NodeId node;
    int term;
    int monomial;
    bool negative;
  };
  struct Candidate {
    int savings, pair;
    bool operator<(const Candidate& other) const {
      return std::tie(savings, other.pair) < std::tie(other.savings, pair);
    }
  };

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  NodeFactor constant_factor(const Rational& value) {
    const auto next = static_cast<NodeFactor>(constants_.size());
    const NodeFactor found =
        constant_index_.find_or_add(mixed_bits(value.hash()), next, [&](int k) { return constants_[at(k)] == value; });
    if (found == next) constants_.push_back(value);
    return -1 - found;
  }

  int monomial_of(const Rational& coefficient, NodeId node) {
    NodeFactors factors;
    if (draft_.at(node).op == Op::product) {
      factors = draft_.at(node).operands;
    } else {
      factors = {node};
    }
    const Rational size = abs(coefficient);
    if (size != 1) factors.push_back(constant_factor(size));
    std::sort(factors.begin(), factors.end());
    std::uint64_t hash = 0;
    for (const NodeFactor factor : factors) hash = mixed_bits(hash ^ static_cast<std::uint64_t>(factor));
    const int next = static_cast<int>(monomials_.size());
    const int found =
        monomial_index_.find_or_add(hash, next, [&](int k) { return monomials_[at(k)].factors == factors; });
    if (found == next) monomials_.push_back({std::move(factors), 0});
    ++monomials_[at(found)].uses;
    return found;
  }

  // Products that are terms become monomials; products with other users (roots, quotients …) are rewritten in place.
  void collect() {
    const NodeId count = static_cast<NodeId>(draft_.nodes.size());
    std::vector<bool> elsewhere(draft_.nodes.size(), false);
    for (const NodeId root : roots(draft_.source)) elsewhere[at(root)] = true;
    for (NodeId id = 0; id < count; ++id) {
      for (const NodeId operand : draft_.at(id).operands) elsewhere[at(operand)] = true;
    }
    for (NodeId id = 0; id < count; ++id) {
      const Node& node = draft_.at(id);
      if (node.op == Op::product && elsewhere[at(id)]) uses_.push_back({id, -1, monomial_of(1, id), false});
      for (std::size_t k = 0; k < node.terms.size(); ++k) {
        const Term& term = node.terms[k];
        uses_.push_back({id, static_cast<int>(k), monomial_of(term.coefficient, term.node), term.coefficient < 0});
      }
    }
  }

  void add_occurrence(NodeFactor a, NodeFactor b, int monomial) {
    if (a > b) std::swap(a, b);
    const int next = static_cast<int>(pairs_.size());
    const int found = pair_index_.find_or_add(mixed_bits(pair_key(a, b)), next,
                                              [&](int k) { return pairs_[at(k)].a == a && pairs_[at(k)].b == b; });
    if (found == next) pairs_.push_back({a, b, {}, -1});
    pairs_[at(found)].where.push_back(monomial);
    touched_.push_back(found);
  }

  void index_pairs(int m) {
    const NodeFactors factors = monomials_[at(m)].factors;
    for (std::size_t j = 1; j < factors.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) add_occurrence(factors[i], factors[j], m);
    }
  }

  // The number of times that a product contains the pair: x²y² contains (x, y) twice.
  static int multiplicity(const NodeFactors& factors, const Pair& pair) {
    const auto count = [&factors](NodeFactor factor) {
      const auto range = std::equal_range(factors.begin(), factors.end(), factor);
      return static_cast<int>(range.second - range.first);
    };
    return pair.a == pair.b ? count(pair.a) / 2 : std::min(count(pair.a), count(pair.b));
  }

  // The multiplications saved by making the pair a node: one for each time that a product contains it, less the node's
  // own.
  int savings(Pair& pair) {
    auto& where = pair.where;
    std::sort(where.begin(), where.end());
    where.erase(std::unique(where.begin(), where.end()), where.end());
    int saved = pair.node < 0 ? -1 : 0;
    std::erase_if(where, [&](int m) {
      const int times = multiplicity(monomials_[at(m)].factors, pair);
      saved += times;
      return times == 0;
    });
    return saved;
  }

  void push(int pair) {
    const int gain = savings(pairs_[at(pair)]);
    if (gain > 0) queue_.push({gain, pair});
  }

  void extract_next() {
    const Candidate best = queue_.top();
    queue_.pop();
    const int gain = savings(pairs_[at(best.pair)]);
    if (gain < best.savings) {
      if (gain > 0) queue_.push({gain, best.pair});
      return;
    }
    extract(best.pair);
  }

  void extract(int index) {
    if (pairs_[at(index)].node < 0) pairs_[at(index)].node = make_pair_node(pairs_[at(index)].a, pairs_[at(index)].b);
    const Pair pair = pairs_[at(index)];
    const NodeId shared = pair.node;
    touched_.clear();
    for (const int m : pair.where) {
      NodeFactors& factors = monomials_[at(m)].factors;
      for (int times = multiplicity(factors, pair); times > 0; --times) {
        factors.erase(std::find(factors.begin(), factors.end(), pair.a));
        factors.erase(std::find(factors.begin(), factors.end(), pair.b));
        factors.push_back(shared);
      }
      std::sort(factors.begin(), factors.end());
      const NodeFactors now = factors;
      for (const NodeFactor factor : now) {
        if (factor != shared) add_occurrence(factor, shared, m);
      }
      if (std::count(now.begin(), now.end(), shared) > 1) add_occurrence(shared, shared, m);
    }
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const int touched : touched_) push(touched);
  }

  NodeId make_pair_node(NodeFactor a, NodeFactor b) {
    if (a < 0) return draft_.add_sum({{constants_[at(-1 - a)], b}}, 0);
    return draft_.add_product({a, b});
  }

  // The constant factor of a monomial (1 if it has none) and the node of its other factors.
  std::pair<Rational, NodeId> build(const UsedProduct& monomial) {
    NodeFactors nodes = monomial.factors;
    Rational coefficient = 1;
    if (nodes.front() < 0) {
      coefficient = constants_[at(-1 - nodes.front())];
      nodes.erase(nodes.begin());
    }
    return {coefficient, nodes.size() == 1 ? nodes[0] : draft_.add_product(nodes)};
  }

  void write_back() {
    std::vector<std::pair<Rational, NodeId>> built;
    for (const UsedProduct& monomial : monomials_) {
      built.push_back(build(monomial));
      auto& [coefficient, node] = built.back();
      if (monomial.uses > 1 && coefficient != 1) {
        node = draft_.add_sum({{coefficient, node}}, 0);
        coefficient = 1;
      }
    }
    for (const Use& use : uses_) {
      const auto& [coefficient, node] = built[at(use.monomial)];
      const Term term = {use.negative ? Rational(-coefficient) : coefficient, node};
      if (use.term >= 0) {
        draft_.at(use.node).terms[at(use.term)] = term;
      } else {
        draft_.at(use.node) = Node{Op::sum, 0, {}, {term}, {}};
      }
    }
  }

  Draft draft_;
  std::vector<Rational> constants_;
  HashIndex constant_index_;
  std::vector<UsedProduct> monomials_;
  HashIndex monomial_index_;  // of the factors as collected
  std::vector<Use> uses_;
  std::vector<Pair> pairs_;
  HashIndex pair_index_;
  std::vector<int> touched_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

Function with_shared_products(const Function& function) {
  const Function flat = unfolded(function);
  return ProductSharing(flat).run();
}

Function share_products(const Function& function) { return cheaper(function, with_shared_products(function)); }

}  // namespace flatdyn
