// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/limb_plan.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

template <class List>
decltype(auto) element(List& list, int k) {
  return list[static_cast<std::size_t>(k)];
}

Rational sign_of(const Rational& number) { return number < 0 ? -1 : 1; }

class Planner {
 public:
  Planner(const Function& function, LimbClasses classes, Schedule& schedule)
      : function_(function),
        graph_(function.graph),
        schedule_(schedule),
        alive_(reachable_from(graph_, roots(function))),
        scalar_state_(alive_.size(), State::open),
        class_state_(classes.classes.size(), State::open),
        cyclic_(classes.classes.size(), false) {
    plan_.is_vector.assign(classes.classes.size(), false);
    plan_.is_read.assign(alive_.size(), false);
    plan_.classes = std::move(classes);
  }

  std::optional<LimbPlan> run() {
    choose_vectors();
    for (std::size_t k = 0; k < schedule_.statements.size(); ++k) {
      const Statement& statement = schedule_.statements[k];
      if (statement.targets.empty()) {
        if (!is_given(statement.node)) visit_any(statement.node);
      } else {
        need(statement.node, true);
        plan_.steps.push_back({LimbStep::Kind::stored, static_cast<int>(k)});
      }
    }
    for (const auto* list : {&function_.validity_conditions, &function_.pivot_scales}) {
      for (const NodeId id : *list) need(id, false);
    }
    if (has_cycles() || plan_.saved <= 0) return std::nullopt;
    return std::move(plan_);
  }

  bool has_cycles() const { return std::find(cyclic_.begin(), cyclic_.end(), true) != cyclic_.end(); }
  // By class: whether it needs a value that needs itself, so that its members cannot be computed at once.
  const std::vector<bool>& cyclic() const { return cyclic_; }

 private:
  enum class State { open, begun, done };
  using Kind = LimbStep::Kind;

  bool has_class(NodeId id) const { return plan_.classes.has(id); }
  bool is_given(NodeId id) const {
    const Op op = graph_[id].op;
    return op == Op::input || op == Op::sin || op == Op::cos;
  }
  bool is_variable(NodeId id) const { return element(schedule_.is_variable, id); }

  // A class becomes a vector if one of its members would become a variable, or is needed outside the limb.
  void choose_vectors() {
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (!element(alive_, id) || is_given(id)) continue;
      if (has_class(id)) {
        if (is_variable(id)) element(plan_.is_vector, plan_.classes.of(id)) = true;
      } else {
        for (const NodeId operand : operands_of(graph_[id])) note_needed(operand);
      }
    }
    for (const Statement& statement : schedule_.statements) {
      if (!statement.targets.empty()) note_needed(statement.node);
    }
    for (const auto* list : {&function_.validity_conditions, &function_.pivot_scales}) {
      for (const NodeId id : *list) note_needed(id);
    }
    for (std::size_t k = 0; k < plan_.is_vector.size(); ++k) {
      const LimbClass& each = plan_.classes.classes[k];
      if (each.is_given() || !plan_.is_vector[k]) continue;
      for (const NodeId member : each.members) {
        if (is_variable(member)) continue;
        element(schedule_.is_variable, member) = true;
        schedule_.statements.push_back({member, {}});
      }
    }
  }

  void note_needed(NodeId id) {
    const NodeId node = without_negations(graph_, id).node;
    if (has_class(node)) element(plan_.is_vector, plan_.classes.of(node)) = true;
  }

  void visit_any(NodeId id) {
    if (!has_class(id)) {
      need(id, false);
    } else if (element(plan_.is_vector, plan_.classes.of(id))) {
      visit_class(plan_.classes.of(id));
    }
  }

  // Makes sure that a scalar is there. `by_storing`: a statement takes it out of its vector.
  void need(NodeId id, bool by_storing) {
    const NodeId node = without_negations(graph_, id).node;
    if (graph_.is_constant(node)) return;
    if (is_given(node)) {
      element(plan_.is_read, node) = true;
    } else if (has_class(node)) {
      visit_class(plan_.classes.of(node));
      if (!by_storing && element(scalar_state_, node) == State::open) {
        element(scalar_state_, node) = State::done;
        plan_.steps.push_back({Kind::taken, node});
        --plan_.saved;
      }
    } else {
      visit_scalar(node);
    }
  }

  void visit_scalar(NodeId id) {
    if (!enter(element(scalar_state_, id))) return;
    for (const NodeId operand : operands_of(graph_[id])) need(operand, false);
    element(scalar_state_, id) = State::done;
    if (is_variable(id)) plan_.steps.push_back({Kind::scalar, id});
  }

  bool enter(State& state) {
    if (state == State::begun) element(cyclic_, open_classes_.back()) = true;
    if (state != State::open) return false;
    state = State::begun;
    return true;
  }

  void visit_class(int of) {
    if (!enter(element(class_state_, of))) return;
    open_classes_.push_back(of);
    const LimbClass& made = element(plan_.classes.classes, of);
    const auto limbs = static_cast<long>(made.members.size());
    if (made.is_given()) {
      plan_.given.push_back(of);
      plan_.saved -= limbs;
    } else {
      for (std::size_t k = 0; k < made.operands.front().size(); ++k) operand(made, k);
      const long operations =
          graph_[made.members.front()].op == Op::sum ? static_cast<long>(made.operands.front().size()) - 1 : 1;
      plan_.saved += (limbs - 1) * operations;
    }
    element(class_state_, of) = State::done;
    open_classes_.pop_back();
    if (!made.is_given() && element(plan_.is_vector, of)) plan_.steps.push_back({Kind::limbs, of});
  }

  void operand(const LimbClass& made, std::size_t k) {
    const Term& first = made.operands.front()[k];
    const NodeId user = made.members.front();
    Gathered coefficient{made.set, {}}, numbers{made.set, {}};
    bool is_same = true;
    for (std::size_t limb = 0; limb < made.members.size(); ++limb) {
      const Term& mine = made.operands[limb][k];
      const bool has_own = mine.node >= 0 && has_class(mine.node);
      const int inner = has_own ? element(plan_.classes.classes, plan_.classes.of(mine.node)).signs[limb] : 1;
      const bool is_sum = graph_[user].op == Op::sum;
      const Rational relative =
          is_sum ? Rational(mine.coefficient * (made.signs[limb] * inner) * sign_of(first.coefficient)) : Rational(1);
      coefficient.numbers.push_back({relative, -1});
      numbers.numbers.push_back({1, mine.node});
      is_same = is_same && mine.node == first.node;
    }
    const bool has_class_operand = first.node >= 0 && has_class(first.node);
    const bool is_gathered = !has_class_operand && !is_same;
    if (is_gathered) move_signs(coefficient, numbers);
    if (!all_equal(coefficient)) plan_.coefficients[{user, first.node}] = gather(coefficient);
    if (has_class_operand) {
      visit_class(plan_.classes.of(first.node));
    } else if (is_gathered) {
      for (const Term& each : numbers.numbers) need(each.node, false);
      plan_.operands[{user, first.node}] = gather(numbers);
    } else if (first.node >= 0) {
      need(first.node, false);
    }
  }

  static bool all_equal(const Gathered& vector) {
    return std::all_of(vector.numbers.begin(), vector.numbers.end(),
                       [&](const Term& each) { return each == vector.numbers.front(); });
  }

  // Moves the signs of coefficients to the numbers that they multiply.
  static void move_signs(Gathered& coefficients, Gathered& numbers) {
    for (std::size_t limb = 0; limb < numbers.numbers.size(); ++limb) {
      Rational& coefficient = coefficients.numbers[limb].coefficient;
      numbers.numbers[limb].coefficient = sign_of(coefficient);
      coefficient = abs(coefficient);
    }
  }

  int gather(const Gathered& vector) {
    const auto found = std::find(plan_.gathered.begin(), plan_.gathered.end(), vector);
    if (found != plan_.gathered.end()) return static_cast<int>(found - plan_.gathered.begin());
    const int index = static_cast<int>(plan_.gathered.size());
    if (vector.numbers.front().node >= 0) plan_.saved -= static_cast<long>(vector.numbers.size());
    plan_.gathered.push_back(vector);
    plan_.steps.push_back({Kind::gathered, index});
    return index;
  }

  const Function& function_;
  const Graph& graph_;
  Schedule& schedule_;
  std::vector<bool> alive_;
  std::vector<State> scalar_state_;  // by node
  std::vector<State> class_state_;
  std::vector<int> open_classes_;  // classes that are begun, each needed by the one before
  std::vector<bool> cyclic_;
  LimbPlan plan_;
};

}  // namespace

Term without_negations(const Graph& graph, NodeId id) {
  Term result{1, id};
  while (is_negation(graph[result.node])) result = {-result.coefficient, graph[result.node].terms[0].node};
  return result;
}

std::optional<LimbPlan> limb_plan(const Function& function, const std::vector<Limbs>& sets, Schedule& schedule) {
  if (sets.empty()) return std::nullopt;
  for (LimbClasses classes = limb_classes(function, sets); !classes.classes.empty();) {
    choose_signs(function.graph, classes);
    Schedule completed = schedule;
    Planner planner(function, classes, completed);
    std::optional<LimbPlan> plan = planner.run();
    if (plan) schedule = std::move(completed);
    if (!planner.has_cycles()) return plan;
    classes = without(classes, planner.cyclic());
  }
  return std::nullopt;
}

}  // namespace flatdyn
