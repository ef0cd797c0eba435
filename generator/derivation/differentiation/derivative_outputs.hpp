// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives as the outputs of functions: names, shapes and words.
#pragma once

#include <string>
#include <vector>

#include "derivation/differentiation/tangents.hpp"

namespace flatdyn {

// The derivatives of all entries of a function's outputs, one after the other, by direction.
using JacobianColumns = std::vector<std::vector<NodeId>>;

// The function without its outputs, over a graph that derivatives are added to, with one more argument of its own.
Function without_outputs(const Function& function, InputKind own, int length, std::string meaning);

// "the entries of tau", "the entries of B, row by row", "the entries of qdd, then of f_c".
std::string words_for_entries(const Function& function);

// The gradient of a weighted sum, by direction, as a vector for each argument. `entries`: those summed, in words.
std::vector<Output> gradient_outputs(const std::vector<NodeId>& derivatives, const Tangents& tangents,
                                     const std::string& entries);

// J as a matrix for each output of a function and each argument; of a scalar output its gradient. `of`: these outputs,
// by name, layout and number of entries.
std::vector<Output> jacobian_outputs(const std::vector<Output>& of, const Tangents& tangents,
                                     const JacobianColumns& columns);

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

// Second derivatives as a matrix for each pair of arguments, without those that are zero; the last one stays if it is
// the only one. `columns`: the rates of the gradient's entries.
std::vector<Output> hessian_outputs(const Graph& graph, const Tangents& tangents, const HessianOrder& order,
                                    const JacobianColumns& columns);

}  // namespace flatdyn
