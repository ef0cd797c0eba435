// SPDX-License-Identifier: GPL-2.0-or-later
// Linear equations over a field, by elimination without pivoting. B is singular at few points of a field; there the
// division throws.
#pragma once

#include <vector>

#include "robot/model/field_mechanism.hpp"

namespace flatdyn {

// The solution x of A x = b.
template <class F>
std::vector<F> solution(Matrix<F> A, std::vector<F> b) {
  const int n = A.rows();
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  for (int k = 0; k < n; ++k) {
    const F reciprocal = F(1) / A(k, k);
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const F factor = A(i, k) * reciprocal;
      for (int j = k; j < n; ++j) A(i, j) += -(factor * A(k, j));
      b[at(i)] += -(factor * b[at(k)]);
    }
  }
  for (int k = 0; k < n; ++k) b[at(k)] = b[at(k)] * (F(1) / A(k, k));
  return b;
}

// The solution X of A X = B, column by column.
template <class F>
Matrix<F> solution(const Matrix<F>& A, const Matrix<F>& B) {
  Matrix<F> X(B.rows(), B.cols());
  for (int j = 0; j < B.cols(); ++j) {
    std::vector<F> column;
    for (int i = 0; i < B.rows(); ++i) column.push_back(B(i, j));
    column = solution(A, column);
    for (int i = 0; i < B.rows(); ++i) X(i, j) = column[static_cast<std::size_t>(i)];
  }
  return X;
}

}  // namespace flatdyn
