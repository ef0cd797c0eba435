// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/tape.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "graph/arithmetic.hpp"

namespace flatdyn {

// Writes the instructions of each node after those of its operands. A sum starts with a term that needs no
// multiplication, if it has one, and takes one instruction per further term.
template <class S>
class TapeWriter {
 public:
  TapeWriter(const Function& function, TapeOf<S>& tape) : graph_(function.graph), tape_(tape) {
    const std::vector<NodeId> wanted = roots(function);
    const std::vector<bool> alive = reachable_from(graph_, wanted);
    cells_of_.resize(static_cast<std::size_t>(graph_.size()));
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (alive[static_cast<std::size_t>(id)]) cells_of_[static_cast<std::size_t>(id)] = written(graph_[id]);
    }
    for (const Output& output : function.outputs) {
      for (const NodeId entry : output.entries) tape_.results_.push_back(cell_of(entry));
    }
    for (std::size_t k = 0; k < function.validity_conditions.size(); ++k)
      tape_.positive_.push_back(condition(function, k));
  }

 private:
  using Code = typename TapeOf<S>::Code;

  std::uint32_t cell_of(NodeId id) const { return cells_of_[static_cast<std::size_t>(id)]; }

  std::uint32_t new_cell(S value = 0) {
    tape_.cells_.push_back(value);
    return static_cast<std::uint32_t>(tape_.cells_.size() - 1);
  }

  std::uint32_t constant(const Rational& value) {
    const auto [at, is_new] = constants_.try_emplace(value, 0);
    if (is_new) at->second = new_cell(to_real<S>(value));
    return at->second;
  }

  std::uint32_t add(Code code, std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
    const std::uint32_t to = new_cell();
    tape_.code_.push_back({code, to, a, b, c});
    return to;
  }

  std::uint32_t written(const Node& node) {
    switch (node.op) {
      case Op::constant:
        return constant(node.value);
      case Op::input:
        tape_.loads_.push_back({node.input, new_cell()});
        return tape_.loads_.back().to;
      case Op::sum:
        return sum(node);
      case Op::product:
        return product(node);
      case Op::quotient:
        return add(Code::divide, cell_of(node.operands[0]), cell_of(node.operands[1]));
      case Op::sin:
        return add(Code::sin, cell_of(node.operands[0]));
      case Op::cos:
        return add(Code::cos, cell_of(node.operands[0]));
      case Op::sign:
        return add(Code::sign, cell_of(node.operands[0]));
      case Op::sqrt:
        return add(Code::sqrt, cell_of(node.operands[0]));
      case Op::tanh:
        return add(Code::tanh, cell_of(node.operands[0]));
    }
    return 0;  // there is no other op
  }

  // The cell of condition k: (scale + kPivotSignificance · pivot) - scale for a pivot, else the value itself.
  std::uint32_t condition(const Function& function, std::size_t k) {
    const std::uint32_t value = cell_of(function.validity_conditions[k]);
    if (k >= function.pivot_scales.size()) return value;
    const std::uint32_t scale = cell_of(function.pivot_scales[k]);
    return add(Code::subtract, add(Code::add_multiple, scale, constant(kPivotSignificance), value), scale);
  }

  std::uint32_t sum(const Node& node) {
    std::vector<Term> terms = node.terms;
    const auto plain = std::find_if(terms.begin(), terms.end(), [](const Term& t) { return t.coefficient == 1; });
    std::uint32_t total = 0;
    if (node.value != 0) {
      total = constant(node.value);
    } else if (plain != terms.end()) {
      total = cell_of(plain->node);
      terms.erase(plain);
    } else {
      total = add(Code::multiply, constant(terms[0].coefficient), cell_of(terms[0].node));
      terms.erase(terms.begin());
    }
    for (const Term& term : terms) total = with_term(total, term);
    return total;
  }

  std::uint32_t with_term(std::uint32_t total, const Term& term) {
    if (term.coefficient == 1) return add(Code::add, total, cell_of(term.node));
    if (term.coefficient == -1) return add(Code::subtract, total, cell_of(term.node));
    return add(Code::add_multiple, total, constant(term.coefficient), cell_of(term.node));
  }

  std::uint32_t product(const Node& node) {
    std::uint32_t total = cell_of(node.operands[0]);
    for (std::size_t k = 1; k < node.operands.size(); ++k)
      total = add(Code::multiply, total, cell_of(node.operands[k]));
    return total;
  }

  const Graph& graph_;
  TapeOf<S>& tape_;
  std::vector<std::uint32_t> cells_of_;          // the cell of each node
  std::map<Rational, std::uint32_t> constants_;  // the cell of each constant
};

template <class S>
TapeOf<S>::TapeOf(const Function& function) {
  TapeWriter<S>(function, *this);
}

template <class S>
bool TapeOf<S>::run(const TapeInputsOf<S>& given, std::span<S> results) {
  for (const Load& load : loads_) cells_[load.to] = given[load.from.kind][static_cast<std::size_t>(load.from.index)];
  S* const x = cells_.data();
  for (const auto& [code, to, a, b, c] : code_) {
    switch (code) {
      case Code::add:
        x[to] = x[a] + x[b];
        break;
      case Code::subtract:
        x[to] = x[a] - x[b];
        break;
      case Code::multiply:
        x[to] = x[a] * x[b];
        break;
      case Code::add_multiple:
        x[to] = x[a] + x[b] * x[c];
        break;
      case Code::divide:
        x[to] = x[a] / x[b];
        break;
      case Code::sin:
        x[to] = std::sin(x[a]);
        break;
      case Code::cos:
        x[to] = std::cos(x[a]);
        break;
      case Code::sign:
        x[to] = static_cast<S>((x[a] > 0) - (x[a] < 0));
        break;
      case Code::sqrt:
        x[to] = std::sqrt(x[a]);
        break;
      case Code::tanh:
        x[to] = std::tanh(x[a]);
        break;
    }
  }
  for (std::size_t k = 0; k < results_.size(); ++k) results[k] = x[results_[k]];
  for (const std::uint32_t pivot : positive_) {
    if (!(x[pivot] > 0)) return false;
  }
  return true;
}

template class TapeOf<double>;
template class TapeOf<long double>;

}  // namespace flatdyn
