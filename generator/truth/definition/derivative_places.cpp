// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/derivative_places.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

void add_places(std::size_t first_row, std::size_t rows, const TangentBlock& columns,
                std::vector<DerivativePlace>& places) {
  for (std::size_t row = first_row; row < first_row + rows; ++row) {
    for (int k = 0; k < columns.length; ++k) places.push_back({row, static_cast<std::size_t>(columns.first + k)});
  }
}

// Each output of the function has a matrix for each argument.
DerivativePlaces places_of_jacobian(const Function& derivatives, const std::vector<TangentBlock>& blocks) {
  DerivativePlaces places;
  const auto longest =
      std::max_element(blocks.begin(), blocks.end(), [](const auto& a, const auto& b) { return a.length < b.length; });
  if (longest == blocks.end() || longest->length == 0) return places;
  const auto at_longest = static_cast<std::size_t>(longest - blocks.begin());
  std::size_t row = 0;
  for (std::size_t output = 0; output < derivatives.outputs.size(); output += blocks.size()) {
    const std::size_t entries = derivatives.outputs[output + at_longest].entries.size();
    const std::size_t rows = entries / static_cast<std::size_t>(longest->length);
    for (const TangentBlock& block : blocks) add_places(row, rows, block, places.entries);
    row += rows;
  }
  return places;
}

DerivativePlaces places_of_hessian(const Function& derivatives, const std::vector<TangentBlock>& blocks) {
  DerivativePlaces places;
  std::size_t output = 0;
  for (auto a = blocks.begin(); a != blocks.end(); ++a) {
    for (auto b = a; b != blocks.end(); ++b) {
      const bool is_there =
          output < derivatives.outputs.size() && derivatives.outputs[output].name == name_of_second_derivatives(*a, *b);
      add_places(static_cast<std::size_t>(a->first), static_cast<std::size_t>(a->length), *b,
                 is_there ? places.entries : places.left_out);
      if (is_there) ++output;
    }
  }
  return places;
}

}  // namespace

DerivativePlaces derivative_places(const Function& derivatives, Derivative derivative, const Tangents& tangents) {
  if (derivative == Derivative::jacobian) return places_of_jacobian(derivatives, tangents.blocks());
  if (derivative == Derivative::contracted_hessian) return places_of_hessian(derivatives, tangents.blocks());
  return {};
}

}  // namespace flatdyn
