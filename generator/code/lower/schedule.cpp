// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/schedule.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "code/lower/each_operand.hpp"
#include "code/lower/statement_order.hpp"
#include "code/lower/statement_uses.hpp"

namespace flatdyn {

namespace {

constexpr int kLongestInline = 8;  // operands in one expression
constexpr int kAlwaysInline = 3;   // operands of an expression that is always inline

bool is_leaf(const Node& node) { return node.op == Op::constant || node.op == Op::input; }
bool is_trigonometric(const Node& node) { return node.op == Op::sin || node.op == Op::cos; }
bool is_worth_its_name(const Node& node) {
  return node.op == Op::quotient || (node.op == Op::sum && node.terms.size() + (node.value != 0 ? 1 : 0) > 1);
}

// The output entries by the node that they hold: equal entries (symmetric matrices) are stored together. Entries that
// are left out are not stored.
std::map<NodeId, std::vector<Target>> stores_of(const Function& function) {
  std::map<NodeId, std::vector<Target>> stores;
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const std::vector<NodeId>& entries = function.outputs[k].entries;
    for (std::size_t e = 0; e < entries.size(); ++e) {
      if (!function.outputs[k].leaves_out(e)) stores[entries[e]].push_back({static_cast<int>(k), static_cast<int>(e)});
    }
  }
  return stores;
}

class Scheduler {
 public:
  Scheduler(const Function& function, const std::vector<bool>& is_fused, Lives lives)
      : function_(function),
        graph_(function.graph),
        is_fused_(is_fused),
        reads_stored_in_place_(lives == Lives::fewest),
        alive_(reachable_from(graph_, roots(function))),
        stores_(stores_of(function)),
        uses_(alive_.size(), 0),
        operand_count_(alive_.size(), 1),
        height_(alive_.size(), 0),
        done_(alive_.size(), false) {
    schedule_.is_variable.assign(alive_.size(), false);
  }

  Schedule run() {
    count_uses();
    choose_variables();
    order_trigonometry();
    order_outputs();
    for (NodeId id : function_.validity_conditions) visit(id);
    for (NodeId id : function_.pivot_scales) visit(id);
    return std::move(schedule_);
  }

 private:
  template <class T>
  static auto at(std::vector<T>& values, NodeId id) -> decltype(values[0]) {
    return values[static_cast<std::size_t>(id)];
  }

  // Whether the node is written wherever it is used, so that its uses count as uses of its operands.
  bool is_written_in_place(NodeId id) const {
    return is_negation(graph_[id]) || is_fused_[static_cast<std::size_t>(id)];
  }

  // Whether a stored value is no variable, but read wherever it is used: it would be live for long.
  bool is_read_in_place(const Node& input) const {
    return reads_stored_in_place_ && input.input.kind == InputKind::stored;
  }

  void count_uses() {
    for (const auto& [id, targets] : stores_) ++at(uses_, id);
    for (NodeId id : function_.validity_conditions) ++at(uses_, id);
    // The diagonal entry is written twice, and its pivot within a sum, so both become variables.
    for (std::size_t k = 0; k < function_.pivot_scales.size(); ++k) {
      at(uses_, function_.pivot_scales[k]) += 2;
      ++at(uses_, function_.validity_conditions[k]);
    }
    for (NodeId id = graph_.size() - 1; id >= 0; --id) {
      if (!at(alive_, id)) continue;
      if (is_of_computed_angle(graph_, id)) at(uses_, graph_[id].operands[0]) += 2;  // the angle becomes a variable
      if (is_trigonometric(graph_[id])) continue;  // its angle is written where the sine is computed
      const int uses = is_written_in_place(id) ? at(uses_, id) : 1;
      for_each_operand(graph_[id], [this, uses](NodeId operand) { at(uses_, operand) += uses; });
    }
  }

  void choose_variables() {
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (!at(alive_, id)) continue;
      const Node& node = graph_[id];
      if (node.op == Op::input) at(schedule_.is_variable, id) = !is_read_in_place(node);
      if (is_leaf(node)) continue;
      int& height = at(height_, id);
      for_each_operand(node, [this, &height](NodeId operand) { height = std::max(height, at(height_, operand) + 1); });
      shorten(id);
      const bool named = graph_.name(id) != nullptr && is_worth_its_name(node) && stores_.count(id) == 0;
      const bool variable = is_trigonometric(node) || named || at(uses_, id) > 1;
      at(schedule_.is_variable, id) = variable && !is_written_in_place(id);
    }
  }

  // The number of operands in the node's expression with the variables chosen so far.
  int inline_operands(NodeId id) {
    const Node& node = graph_[id];
    int count = node.op == Op::sum && !node.value.is_zero() ? 1 : 0;
    for (const Term& term : node.terms) count += term.coefficient == 1 || term.coefficient == -1 ? 0 : 1;
    for_each_operand_to_write(id, [this, &count](NodeId operand) {
      count += at(schedule_.is_variable, operand) ? 1 : at(operand_count_, operand);
    });
    return count;
  }

  // The operands of a node's expression, those of fused products in place of the products.
  template <class Use>
  void for_each_operand_to_write(NodeId id, const Use& use) const {
    for_each_operand(graph_[id], [this, &use](NodeId operand) {
      if (is_fused_[static_cast<std::size_t>(operand)]) {
        for_each_operand(graph_[operand], use);
      } else {
        use(operand);
      }
    });
  }

  // Makes variables of the node's largest operands until its expression is short enough.
  void shorten(NodeId id) {
    at(operand_count_, id) = inline_operands(id);
    if (at(operand_count_, id) <= kLongestInline) return;
    std::vector<NodeId> parts;
    for_each_operand_to_write(id, [&parts](NodeId operand) { parts.push_back(operand); });
    std::stable_sort(parts.begin(), parts.end(),
                     [this](NodeId a, NodeId b) { return at(operand_count_, a) > at(operand_count_, b); });
    for (NodeId part : parts) {
      if (inline_operands(id) <= kLongestInline || at(operand_count_, part) <= kAlwaysInline) break;
      if (!is_negation(graph_[part])) at(schedule_.is_variable, part) = true;
    }
    at(operand_count_, id) = inline_operands(id);
  }

  void order_trigonometry() {
    std::map<std::tuple<NodeId, int>, NodeId> by_angle;  // puts sine and cosine of one angle side by side
    for (NodeId id = 0; id < graph_.size(); ++id) {
      const Node& node = graph_[id];
      const bool is_given = is_trigonometric(node) && !is_of_computed_angle(graph_, id);
      if (at(alive_, id) && is_given) by_angle[{node.operands[0], node.op == Op::sin ? 0 : 1}] = id;
    }
    for (const auto& [angle, id] : by_angle) visit(id);
  }

  void order_outputs() {
    std::vector<NodeId> order;
    for (const auto& [id, targets] : stores_) order.push_back(id);
    std::sort(order.begin(), order.end(), [this](NodeId a, NodeId b) {
      return std::tuple(graph_.is_constant(a), at(height_, a), a) <
             std::tuple(graph_.is_constant(b), at(height_, b), b);
    });
    for (NodeId id : order) {
      visit(id);
      schedule_.statements.push_back({id, stores_.at(id)});
    }
  }

  // Emits everything that the node needs, then its own variable if it has one.
  void visit(NodeId id) {
    const Node& node = graph_[id];
    if (is_leaf(node) || at(done_, id)) return;
    at(done_, id) = true;
    std::vector<NodeId> parts = operands_of(node);
    std::sort(parts.begin(), parts.end(),
              [this](NodeId a, NodeId b) { return std::tuple(-at(height_, a), a) < std::tuple(-at(height_, b), b); });
    for (NodeId part : parts) visit(part);
    if (at(schedule_.is_variable, id)) schedule_.statements.push_back({id, {}});
  }

  const Function& function_;
  const Graph& graph_;
  const std::vector<bool>& is_fused_;
  bool reads_stored_in_place_;
  std::vector<bool> alive_;
  std::map<NodeId, std::vector<Target>> stores_;
  std::vector<int> uses_;
  std::vector<int> operand_count_;
  std::vector<int> height_;  // longest path to an input
  std::vector<bool> done_;
  Schedule schedule_;
};

// Orders the statements after the sines and cosines so that values live shortly. Constants are stored last.
void reorder(const Function& function, Lives lives, Schedule& schedule) {
  std::vector<Statement>& all = schedule.statements;
  const auto is_sine = [&function](const Statement& statement) {
    return statement.targets.empty() && is_trigonometric(function.graph[statement.node]) &&
           !is_of_computed_angle(function.graph, statement.node);
  };
  const auto is_computed = [&function](const Statement& statement) {
    return statement.targets.empty() || !function.graph.is_constant(statement.node);
  };
  const auto begin = std::find_if(all.rbegin(), all.rend(), is_sine).base();
  const auto end = std::stable_partition(begin, all.end(), is_computed);
  std::vector<NodeId> read_at_the_end = function.validity_conditions;
  read_at_the_end.insert(read_at_the_end.end(), function.pivot_scales.begin(), function.pivot_scales.end());
  const std::vector<Statement> statements(begin, end);
  auto place = begin;
  const StatementUses uses = uses_of(function, schedule, statements, read_at_the_end);
  for (const int k : lives == Lives::fewest ? order_of_fewest_values(uses) : order_of_short_lives(uses)) {
    *place++ = statements[static_cast<std::size_t>(k)];
  }
}

// Puts all sines of computed angles that can be evaluated together side by side, sines and cosines of an angle in turn:
// a round of them follows all that does not need it.
void order_rounds(const Graph& graph, Schedule& schedule) {
  const std::vector<int> rounds = rounds_of_sines(graph);
  if (std::all_of(rounds.begin(), rounds.end(), [](int round) { return round == 0; })) return;
  const auto key = [&](const Statement& statement) {
    const NodeId id = statement.node;
    const int round = rounds[static_cast<std::size_t>(id)];
    if (!statement.targets.empty() || !is_of_computed_angle(graph, id))
      return std::tuple(round, true, NodeId(0), false);
    return std::tuple(round, false, graph[id].operands[0], graph[id].op == Op::cos);
  };
  std::stable_sort(schedule.statements.begin(), schedule.statements.end(),
                   [&key](const Statement& a, const Statement& b) { return key(a) < key(b); });
}

}  // namespace

Schedule make_schedule(const Function& function, const std::vector<bool>& is_fused, Lives lives) {
  Schedule schedule = Scheduler(function, is_fused, lives).run();
  reorder(function, lives, schedule);
  order_rounds(function.graph, schedule);
  return schedule;
}

long most_live_values(const Function& function) {
  const std::vector<bool> none(static_cast<std::size_t>(function.graph.size()), false);
  const Schedule schedule = make_schedule(function, none, Lives::fewest);
  std::vector<NodeId> read_at_the_end = function.validity_conditions;
  read_at_the_end.insert(read_at_the_end.end(), function.pivot_scales.begin(), function.pivot_scales.end());
  return most_live(uses_of(function, schedule, schedule.statements, read_at_the_end));
}

}  // namespace flatdyn
