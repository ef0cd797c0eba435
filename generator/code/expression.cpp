// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/expression.hpp"

namespace flatdyn::code {

Addend without_sign(Expression expression) {
  const auto* sum = std::get_if<Sum>(&expression);
  if (sum == nullptr || sum->addends.size() != 1) return {false, std::move(expression)};
  return Addend(sum->addends.front());
}

bool is_atom(const Expression& expression) {
  return !std::holds_alternative<Sum>(expression) && !std::holds_alternative<Product>(expression) &&
         !std::holds_alternative<Quotient>(expression) && !std::holds_alternative<Negation>(expression);
}

}  // namespace flatdyn::code
