// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "derivation/differentiation/differentiate.hpp"
#include "derivation/differentiation/modes.hpp"
#include "graph/count.hpp"

namespace flatdyn {
namespace {

// Unit vector number k of a space.
std::vector<std::optional<NodeId>> unit_direction(int k, const Tangents& tangents, Graph& graph) {
  std::vector<std::optional<NodeId>> direction(static_cast<std::size_t>(tangents.count()));
  direction[static_cast<std::size_t>(k)] = graph.constant(1);
  return direction;
}

// The derivatives of all entries, by direction.
using Columns = std::vector<std::vector<NodeId>>;

std::vector<NodeId> entries_of(const Function& function) {
  std::vector<NodeId> entries;
  for (const Output& output : function.outputs) {
    entries.insert(entries.end(), output.entries.begin(), output.entries.end());
  }
  return entries;
}

Columns columns_in_forward_mode(const Function& function, const Tangents& tangents, Graph& graph) {
  const std::vector<NodeId> entries = entries_of(function);
  const std::vector<bool> is_used = reachable_from(function.graph, entries);
  Columns columns;
  for (int k = 0; k < tangents.count(); ++k) {
    ForwardMode forward(is_used, tangents, unit_direction(k, tangents, graph), graph);
    columns.emplace_back();
    for (const NodeId entry : entries) columns.back().push_back(forward.rate(entry));
  }
  return columns;
}

Columns columns_in_reverse_mode(const Function& function, const Tangents& tangents, Graph& graph) {
  const auto nodes = static_cast<std::size_t>(function.graph.size());
  Columns columns(static_cast<std::size_t>(tangents.count()));
  for (const NodeId entry : entries_of(function)) {
    std::vector<std::vector<Term>> weights(nodes);
    weights[static_cast<std::size_t>(entry)].push_back({1, graph.constant(1)});
    const std::vector<NodeId> row = ReverseMode(tangents, graph, std::move(weights)).derivatives();
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row[k]);
  }
  return columns;
}

Function with_matrices(Function function, const Function& of, const Tangents& tangents, const Columns& columns) {
  function.outputs.clear();
  std::size_t first = 0;
  for (const Output& output : of.outputs) {
    const std::size_t rows = output.entries.size();
    for (const TangentBlock& block : tangents.blocks()) {
      std::vector<NodeId> entries;
      for (std::size_t row = first; row < first + rows; ++row) {
        for (int k = block.first; k < block.first + block.length; ++k) {
          entries.push_back(columns[static_cast<std::size_t>(k)][row]);
        }
      }
      const bool is_gradient = output.layout == Layout::scalar;
      const std::string by = name_of(block), entry = tangents.words_for_entry(block, "k");
      function.outputs.push_back(
          {.name = fmt::format("d{}_d{}", output.name, by),
           .layout = is_gradient ? Layout::vector : Layout::matrix,
           .rows = is_gradient ? block.length : static_cast<int>(rows),
           .cols = is_gradient ? 1 : block.length,
           .entries = std::move(entries),
           .meaning = is_gradient
                          ? fmt::format("entry k: derivative of {} by {}", output.name, entry)
                          : fmt::format("row i, column k: derivative of entry i of {} by {}", output.name, entry),
           .quantity = OutputQuantity::derivative});
    }
    first += rows;
  }
  return function;
}

// Which of two equal second derivatives is computed, where directions commute: that by the first argument along the
// second one or the other way round, and which half of a symmetric block.
struct HessianOrder {
  bool first_by_first = true, is_upper = true;

  // Whether the derivative by direction k along direction l is taken from the one by l along k.
  bool is_mirrored(int k, int l, bool are_of_one_argument) const {
    if (!are_of_one_argument) return !first_by_first;
    return is_upper ? k > l : k < l;
  }
};

// Entry (k, l) is the derivative by direction k of `a` along direction l of `b`; `columns`: those of wᵀ J.
std::vector<NodeId> second_derivatives(const TangentBlock& a, const TangentBlock& b, const Tangents& tangents,
                                       const HessianOrder& order, const Columns& columns) {
  const bool commute = tangents.commute(a.kind, b.kind);
  std::vector<NodeId> entries;
  for (int k = a.first; k < a.first + a.length; ++k) {
    for (int l = b.first; l < b.first + b.length; ++l) {
      const bool is_mirrored = commute && order.is_mirrored(k, l, a.first == b.first);
      const auto along = static_cast<std::size_t>(is_mirrored ? k : l),
                 by = static_cast<std::size_t>(is_mirrored ? l : k);
      entries.push_back(columns[along][by]);
    }
  }
  return entries;
}

// The matrices for all pairs of arguments, without those that are zero; the last one stays if it is the only one.
std::vector<Output> hessian_outputs(const Graph& graph, const Tangents& tangents, const HessianOrder& order,
                                    const Columns& columns) {
  const std::vector<TangentBlock>& blocks = tangents.blocks();
  std::vector<Output> outputs;
  for (auto a = blocks.begin(); a != blocks.end(); ++a) {
    for (auto b = a; b != blocks.end(); ++b) {
      std::vector<NodeId> entries = second_derivatives(*a, *b, tangents, order, columns);
      const bool is_only_one = std::next(a) == blocks.end() && outputs.empty();
      const bool is_zero = std::all_of(entries.begin(), entries.end(), [&](NodeId id) { return graph.is_zero(id); });
      if (is_zero && !is_only_one) continue;
      outputs.push_back({.name = name_of_second_derivatives(*a, *b),
                         .layout = Layout::matrix,
                         .rows = a->length,
                         .cols = b->length,
                         .entries = std::move(entries),
                         .meaning = fmt::format("row k: derivative of the weighted sum by {}; column l: of that by {}",
                                                tangents.words_for_entry(*a, "k"), tangents.words_for_entry(*b, "l")),
                         .quantity = OutputQuantity::derivative});
    }
  }
  return outputs;
}

Function cheaper(Function a, Function b) {
  return count_operations(b).arithmetic() < count_operations(a).arithmetic() ? std::move(b) : std::move(a);
}

}  // namespace

Function jacobian_matrices(const Function& function, const Tangents& tangents) {
  Function forward = function, reverse = function;
  const Columns of_forward = columns_in_forward_mode(function, tangents, forward.graph);
  const Columns of_reverse = columns_in_reverse_mode(function, tangents, reverse.graph);
  return cheaper(with_matrices(std::move(forward), function, tangents, of_forward),
                 with_matrices(std::move(reverse), function, tangents, of_reverse));
}

Function contracted_hessian(const Function& function, const Tangents& tangents) {
  const Function gradient = vector_times_jacobian(function, tangents);
  Function all = gradient;
  const Columns columns = columns_in_forward_mode(gradient, tangents, all.graph);
  std::optional<Function> best;
  for (const HessianOrder order :
       {HessianOrder{true, true}, HessianOrder{true, false}, HessianOrder{false, true}, HessianOrder{false, false}}) {
    all.outputs = hessian_outputs(all.graph, tangents, order, columns);
    best = best ? cheaper(std::move(*best), all) : all;
  }
  return *best;
}

}  // namespace flatdyn
