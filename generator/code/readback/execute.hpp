// SPDX-License-Identifier: GPL-2.0-or-later
// Execution of a straight line's operations over any scalar: float, double, many states at once, a prime field.
#pragma once

#include <vector>

#include "code/readback/straight_line.hpp"

namespace flatdyn {

// The result of an addition.
template <class Arithmetic>
typename Arithmetic::Scalar sum_of(const StraightLine& lines, const Operation& addition, Arithmetic& arithmetic,
                                   const std::vector<typename Arithmetic::Scalar>& values) {
  using Scalar = typename Arithmetic::Scalar;
  const auto value = [&values](int k) -> const Scalar& { return values[static_cast<std::size_t>(k)]; };
  if constexpr (requires(const Scalar& x) { arithmetic.fused(x, x, x); }) {
    const Operation& product = lines[addition.a];
    if (product.is_exact) return arithmetic.fused(value(product.a), value(product.b), value(addition.b));
  }
  return value(addition.a) + value(addition.b);
}

// Appends to `values` the results of the operations after those that it has, up to the one before `end`. An Arithmetic
// has:
//   using Scalar, with + - * and a sign
//   Scalar constant(double)
//   Scalar input(const Input&)
//   Scalar sine(const Input&), cosine(const Input&)     of a joint's position
//   Scalar sine(const Scalar&), cosine(const Scalar&)   of another angle
//   Scalar divide(const Scalar&, const Scalar&), sign(const Scalar&), sqrt(const Scalar&)
//   Scalar fused(const Scalar& a, const Scalar& b, const Scalar& c)   a b + c, rounded once, if it rounds at all
template <class Arithmetic>
void execute(const StraightLine& lines, int end, Arithmetic& arithmetic,
             std::vector<typename Arithmetic::Scalar>& values) {
  using Scalar = typename Arithmetic::Scalar;
  values.reserve(static_cast<std::size_t>(end));
  for (int k = static_cast<int>(values.size()); k < end; ++k) {
    const Operation& operation = lines[k];
    const auto a = [&]() -> const Scalar& { return values[static_cast<std::size_t>(operation.a)]; };
    const auto b = [&]() -> const Scalar& { return values[static_cast<std::size_t>(operation.b)]; };
    const bool is_of_joint = operation.a < 0;
    switch (operation.step) {
      case Step::constant:
        values.push_back(arithmetic.constant(operation.value));
        break;
      case Step::input:
        values.push_back(arithmetic.input(operation.input));
        break;
      case Step::sine:
        values.push_back(is_of_joint ? arithmetic.sine(operation.input) : arithmetic.sine(a()));
        break;
      case Step::cosine:
        values.push_back(is_of_joint ? arithmetic.cosine(operation.input) : arithmetic.cosine(a()));
        break;
      case Step::negate:
        values.push_back(-a());
        break;
      case Step::add:
        values.push_back(sum_of(lines, operation, arithmetic, values));
        break;
      case Step::subtract:
        values.push_back(a() - b());
        break;
      case Step::multiply:
        values.push_back(a() * b());
        break;
      case Step::divide:
        values.push_back(arithmetic.divide(a(), b()));
        break;
      case Step::sign:
        values.push_back(arithmetic.sign(a()));
        break;
      case Step::sqrt:
        values.push_back(arithmetic.sqrt(a()));
        break;
    }
  }
}

}  // namespace flatdyn
