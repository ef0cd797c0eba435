// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace flatdyn {
namespace {

// The derivative of a node by one of its operands: coefficient · factor; no factor is 1.
struct Slope {
  NodeId operand;
  Rational coefficient = 1;
  std::optional<NodeId> factor{};
};

// The product of all factors but one.
std::optional<NodeId> others(const std::vector<NodeId>& factors, std::size_t left_out, Graph& graph) {
  std::vector<NodeId> rest;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    if (k != left_out) rest.push_back(factors[k]);
  }
  return rest.size() == 1 ? rest[0] : graph.product(std::move(rest));
}

// The derivatives of a node by its operands, one for each time that an operand is there. New nodes are added behind
// the old ones.
std::vector<Slope> slopes_of(NodeId id, Graph& graph) {
  const Node node = graph[id];
  const auto operand = [&node](std::size_t k) { return node.operands[k]; };
  std::vector<Slope> slopes;
  switch (node.op) {
    case Op::constant:
    case Op::input:
    case Op::sign:
      break;
    case Op::sum:
      for (const Term& term : node.terms) slopes.push_back({term.node, term.coefficient});
      break;
    case Op::product:
      for (std::size_t k = 0; k < node.operands.size(); ++k) {
        slopes.push_back({operand(k), 1, others(node.operands, k, graph)});
      }
      break;
    case Op::quotient: {
      const NodeId reciprocal = graph.quotient(graph.constant(1), operand(1));
      slopes.push_back({operand(0), 1, reciprocal});
      slopes.push_back({operand(1), -1, graph.product({id, reciprocal})});
      break;
    }
    case Op::sin:
      slopes.push_back({operand(0), 1, graph.cos(operand(0))});
      break;
    case Op::cos:
      slopes.push_back({operand(0), -1, graph.sin(operand(0))});
      break;
    case Op::sqrt:
      slopes.push_back({operand(0), Rational(1, 2), graph.quotient(graph.constant(1), id)});
      break;
    case Op::tanh:
      slopes.push_back({operand(0), 1, graph.sum({{-1, graph.product({id, id})}}, 1)});
      break;
  }
  return slopes;
}

NodeId times(const std::optional<NodeId>& factor, NodeId node, Graph& graph) {
  return factor ? graph.product({*factor, node}) : node;
}

// Names a node that belongs to another one, if that has a name.
void name_after(NodeId of, const std::string& pattern, NodeId node, Graph& graph) {
  if (const std::string* name = graph.name(of)) {
    const std::string own = fmt::format(fmt::runtime(pattern), *name);
    graph.set_name(node, own);
  }
}

}  // namespace

ForwardMode::ForwardMode(const std::vector<bool>& is_used, const Tangents& tangents,
                         std::vector<std::optional<NodeId>> direction, Graph& graph)
    : tangents_(tangents), graph_(graph), direction_(std::move(direction)), rates_(is_used.size()) {
  for (NodeId id = 0; id < static_cast<NodeId>(rates_.size()); ++id) {
    if (is_used[static_cast<std::size_t>(id)]) find_rate(id);
  }
}

NodeId ForwardMode::rate(NodeId id) {
  const std::optional<NodeId>& found = rates_[static_cast<std::size_t>(id)];
  return found ? *found : graph_.constant(0);
}

void ForwardMode::find_rate(NodeId id) {
  std::vector<Term> terms;
  if (graph_[id].op == Op::input) {
    for (const Tangents::Rate& rate : tangents_.rates_of(graph_[id].input, graph_)) {
      const std::optional<NodeId>& along = direction_[static_cast<std::size_t>(rate.direction)];
      if (along) terms.push_back({1, graph_.product({rate.factor, *along})});
    }
  } else if (is_moving(id)) {
    for (const Slope& slope : slopes_of(id, graph_)) {
      if (const auto& rate = rates_[static_cast<std::size_t>(slope.operand)]) {
        terms.push_back({slope.coefficient, times(slope.factor, *rate, graph_)});
      }
    }
  }
  if (terms.empty()) return;
  const NodeId rate = graph_.sum(std::move(terms));
  if (graph_.is_zero(rate)) return;
  name_after(id, "d_{}", rate, graph_);
  rates_[static_cast<std::size_t>(id)] = rate;
}

bool ForwardMode::is_moving(NodeId id) const {
  const std::vector<NodeId> operands = operands_of(graph_[id]);
  return std::any_of(operands.begin(), operands.end(),
                     [this](NodeId operand) { return rates_[static_cast<std::size_t>(operand)].has_value(); });
}

ReverseMode::ReverseMode(const Tangents& tangents, Graph& graph, std::vector<std::vector<Term>> weights)
    : graph_(graph), weights_(std::move(weights)), result_(static_cast<std::size_t>(tangents.count())) {
  for (auto id = static_cast<NodeId>(weights_.size()) - 1; id >= 0; --id) {
    std::vector<Term>& terms = weights_[static_cast<std::size_t>(id)];
    if (!terms.empty()) pass_on(id, graph_.sum(std::move(terms)), tangents);
  }
}

std::vector<NodeId> ReverseMode::derivatives() {
  std::vector<NodeId> nodes;
  for (std::vector<Term>& terms : result_) nodes.push_back(graph_.sum(std::move(terms)));
  return nodes;
}

void ReverseMode::pass_on(NodeId id, NodeId weight, const Tangents& tangents) {
  if (graph_.is_zero(weight)) return;
  name_after(id, "{}_bar", weight, graph_);
  if (graph_[id].op == Op::input) {
    for (const Tangents::Rate& rate : tangents.rates_of(graph_[id].input, graph_)) {
      result_[static_cast<std::size_t>(rate.direction)].push_back({1, graph_.product({rate.factor, weight})});
    }
  }
  for (const Slope& slope : slopes_of(id, graph_)) {
    weights_[static_cast<std::size_t>(slope.operand)].push_back(
        {slope.coefficient, times(slope.factor, weight, graph_)});
  }
}

}  // namespace flatdyn
