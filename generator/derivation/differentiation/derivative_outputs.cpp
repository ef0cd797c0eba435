// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/derivative_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace flatdyn {
namespace {

// Entry (k, l) is the derivative by direction k of `a` along direction l of `b`; `columns`: those of wᵀ J.
std::vector<NodeId> second_derivatives(const TangentBlock& a, const TangentBlock& b, const Tangents& tangents,
                                       const HessianOrder& order, const JacobianColumns& columns) {
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

}  // namespace

Function without_outputs(const Function& function, InputKind own, int length, std::string meaning) {
  Function result = function;
  result.outputs.clear();
  result.inputs.push_back(own);
  result.own = {length, std::move(meaning)};
  return result;
}

std::string words_for_entries(const Function& function) {
  std::string text = "the entries of ";
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const Output& output = function.outputs[k];
    text += (k > 0 ? ", then of " : "") + output.name;
    if (output.layout == Layout::matrix) text += ", row by row";
  }
  return text;
}

std::vector<Output> gradient_outputs(const std::vector<NodeId>& derivatives, const Tangents& tangents,
                                     const std::string& entries) {
  std::vector<Output> outputs;
  for (const TangentBlock& block : tangents.blocks()) {
    const auto first = derivatives.begin() + block.first;
    outputs.push_back({.name = name_of(block) + "_bar",
                       .layout = Layout::vector,
                       .rows = block.length,
                       .cols = 1,
                       .entries = {first, first + block.length},
                       .meaning = fmt::format("derivatives by {} of the weighted sum of {}", words_for(block), entries),
                       .quantity = OutputQuantity::derivative});
  }
  return outputs;
}

std::vector<Output> jacobian_outputs(const std::vector<Output>& of, const Tangents& tangents,
                                     const JacobianColumns& columns) {
  std::vector<Output> outputs;
  std::size_t first = 0;
  for (const Output& output : of) {
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
      outputs.push_back({.name = fmt::format("d{}_d{}", output.name, by),
                         .layout = is_gradient ? Layout::vector : Layout::matrix,
                         .rows = is_gradient ? block.length : static_cast<int>(rows),
                         .cols = is_gradient ? 1 : block.length,
                         .entries = std::move(entries),
                         .meaning = is_gradient ? fmt::format("entry k: derivative of {} by {}", output.name, entry)
                                                : fmt::format("row i, column k: derivative of entry i of {} by {}",
                                                              output.name, entry),
                         .quantity = OutputQuantity::derivative});
    }
    first += rows;
  }
  return outputs;
}

std::vector<Output> hessian_outputs(const Graph& graph, const Tangents& tangents, const HessianOrder& order,
                                    const JacobianColumns& columns) {
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

}  // namespace flatdyn
