// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/square_matrices.hpp"

#include <utility>

namespace flatdyn {

SquareMatrices::Entries SquareMatrices::zero() const {
  return Entries(static_cast<std::size_t>(size_ * size_), graph_.constant(0));
}

SquareMatrices::Entries SquareMatrices::diagonal(NodeId x) const {
  Entries result = zero();
  for (int k = 0; k < size_; ++k) result[at(k, k)] = x;
  return result;
}

SquareMatrices::Entries SquareMatrices::scaled(NodeId factor, const Entries& a) const {
  Entries result;
  for (const NodeId entry : a) result.push_back(graph_.product({factor, entry}));
  return result;
}

SquareMatrices::Entries SquareMatrices::sum(const Entries& a, const Entries& b, int sign) const {
  Entries result;
  for (std::size_t k = 0; k < a.size(); ++k) result.push_back(graph_.sum({{1, a[k]}, {sign, b[k]}}));
  return result;
}

SquareMatrices::Entries SquareMatrices::product(const Entries& a, const Entries& b) const {
  Entries result = zero();
  for (int i = 0; i < size_; ++i) {
    for (int k = 0; k < size_; ++k) {
      std::vector<Term> terms;
      for (int j = 0; j < size_; ++j) terms.push_back({1, graph_.product({a[at(i, j)], b[at(j, k)]})});
      result[at(i, k)] = graph_.sum(std::move(terms));
    }
  }
  return result;
}

SquareMatrices::Solution SquareMatrices::solution(Entries A, Entries R, int columns) const {
  const auto less = [this](NodeId x, NodeId factor, NodeId y) {
    return graph_.sum({{1, x}, {-1, graph_.product({factor, y})}});
  };
  const auto right = [columns](int row, int column) { return static_cast<std::size_t>(row * columns + column); };
  Solution result;
  std::vector<NodeId> reciprocals;
  for (int k = 0; k < size_; ++k) {
    result.pivots.push_back(A[at(k, k)]);
    reciprocals.push_back(graph_.quotient(graph_.constant(1), A[at(k, k)]));
    for (int i = k + 1; i < size_; ++i) {
      const NodeId factor = graph_.product({A[at(i, k)], reciprocals.back()});
      for (int j = k + 1; j < size_; ++j) A[at(i, j)] = less(A[at(i, j)], factor, A[at(k, j)]);
      for (int j = 0; j < columns; ++j) R[right(i, j)] = less(R[right(i, j)], factor, R[right(k, j)]);
    }
  }
  for (int k = size_ - 1; k >= 0; --k) {
    for (int j = 0; j < columns; ++j) {
      for (int i = k + 1; i < size_; ++i) R[right(k, j)] = less(R[right(k, j)], A[at(k, i)], R[right(i, j)]);
      R[right(k, j)] = graph_.product({R[right(k, j)], reciprocals[static_cast<std::size_t>(k)]});
    }
  }
  result.x = std::move(R);
  return result;
}

}  // namespace flatdyn
