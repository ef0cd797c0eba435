// SPDX-License-Identifier: GPL-2.0-or-later
// Random functions that look like robot dynamics: sums of few products with rational coefficients, with much sharing.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

class RandomFunction {
 public:
  explicit RandomFunction(std::uint64_t seed) : random_(seed) {}

  // A function with about `operations` nodes over `joints` joints, and a few outputs.
  Function make(int operations, int joints) {
    function_ = Function{};
    function_.name = "random";
    function_.inputs = {InputKind::q, InputKind::qd};
    for (int k = 0; k < joints; ++k) {
      const NodeId q = graph().input({InputKind::q, k}), qd = graph().input({InputKind::qd, k});
      pool_.insert(pool_.end(), {qd, graph().sin(q), graph().cos(q)});
    }
    for (int k = 0; k < operations; ++k) add_operation(joints);
    std::vector<NodeId> entries;
    for (int k = 0; k < 6; ++k) entries.push_back(recent());
    function_.outputs.push_back({"y", Layout::matrix, 2, 3, entries, "anything"});
    return function_;
  }

 private:
  Graph& graph() { return function_.graph; }
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  NodeId any() { return pool_[static_cast<std::size_t>(below(static_cast<int>(pool_.size())))]; }

  NodeId simple() { return pool_[static_cast<std::size_t>(below(std::min(static_cast<int>(pool_.size()), 12)))]; }

  // A random node; recent ones are more likely, so that the graph is deep.
  NodeId recent() {
    const int size = static_cast<int>(pool_.size());
    return pool_[static_cast<std::size_t>(size - 1 - below(std::min(size, 24)))];
  }

  Rational number() {
    static const std::vector<Rational> common = {1, 1, 1, -1, -1, Rational(1, 2), 2, Rational(-7, 5), Rational(3, 8)};
    return common[static_cast<std::size_t>(below(static_cast<int>(common.size())))];
  }

  NodeId random_sum() {
    std::vector<Term> terms;
    const NodeId factor = recent();
    const bool has_factor = below(3) == 0;
    for (int k = 2 + below(4); k > 0; --k) {
      const NodeId a = below(2) == 0 ? any() : recent();
      terms.push_back({number(), has_factor ? graph().product({factor, simple()}) : below(2) == 0 ? a : product_of(a)});
    }
    return graph().sum(std::move(terms), below(6) == 0 ? number() : Rational(0));
  }

  // A product of at most four factors, most often of two.
  NodeId product_of(NodeId a) {
    const NodeId b = any();
    const auto degree = [this](NodeId id) { return graph()[id].op == Op::product ? graph()[id].operands.size() : 1; };
    return degree(a) + degree(b) > (below(4) == 0 ? 4 : 2) ? graph().sum({{1, a}, {number(), b}})
                                                           : graph().product({a, b});
  }

  NodeId rare(int joints) {
    const NodeId qd = graph().input({InputKind::qd, below(joints)});
    switch (below(3)) {
      case 0:
        return graph().sign(qd);
      case 1:  // zero only by chance: the denominator contains an input of its own
        return graph().quotient(recent(), graph().sum({{1, any()}, {3, qd}}, 7));
      default: {
        const NodeId angle = graph().sum({{1, graph().input({InputKind::q, below(joints)})},
                                          {below(2) == 0 ? 1 : -1, graph().input({InputKind::q, below(joints)})}});
        return below(2) == 0 ? graph().sin(angle) : graph().cos(angle);
      }
    }
  }

  void add_operation(int joints) {
    const int kind = below(20);
    const NodeId id = kind < 13 ? random_sum() : kind < 19 ? product_of(recent()) : rare(joints);
    if (graph().is_constant(id)) return;
    if (below(4) == 0) graph().set_name(id, "named_" + std::to_string(id));
    pool_.push_back(id);
  }

  std::mt19937_64 random_;
  Function function_;
  std::vector<NodeId> pool_;
};

}  // namespace flatdyn
