// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/casadi/sparsity.hpp"

namespace flatdyn {
namespace {

bool is_matrix(Layout layout) { return layout == Layout::matrix || layout == Layout::christoffel; }

template <class IsStored>
Sparsity sparsity_where(int rows, int cols, IsStored is_stored) {
  Sparsity sparsity{rows, cols, {0}, {}};
  for (int j = 0; j < cols; ++j) {
    for (int i = 0; i < rows; ++i) {
      if (is_stored(i, j)) sparsity.row.push_back(i);
    }
    sparsity.column_begin.push_back(sparsity.count());
  }
  return sparsity;
}

}  // namespace

std::vector<int> Sparsity::compressed() const {
  std::vector<int> numbers = {rows, cols};
  if (count() == rows * cols && count() > 0) {
    numbers.push_back(1);
    return numbers;
  }
  numbers.insert(numbers.end(), column_begin.begin(), column_begin.end());
  numbers.insert(numbers.end(), row.begin(), row.end());
  return numbers;
}

Sparsity dense(int rows, int cols) {
  return sparsity_where(rows, cols, [](int, int) { return true; });
}

Sparsity without_entries(int rows, int cols) {
  return sparsity_where(rows, cols, [](int, int) { return false; });
}

NodeMatrix::NodeMatrix(int row_count, int column_count)
    : rows(row_count), cols(column_count), entries(static_cast<std::size_t>(row_count * column_count)) {}

NodeMatrix NodeMatrix::transposed() const {
  NodeMatrix result(cols, rows);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) result.at(j, i) = at(i, j);
  }
  return result;
}

NodeMatrix matrix_of(const Output& output) {
  const int cols = is_matrix(output.layout) ? output.cols : 1, rows = static_cast<int>(output.entries.size()) / cols;
  NodeMatrix matrix(rows, cols);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) matrix.at(i, j) = output.entries[static_cast<std::size_t>(i * cols + j)];
  }
  return matrix;
}

Sparsity sparsity_of(const Graph& graph, const NodeMatrix& matrix) {
  return sparsity_where(matrix.rows, matrix.cols, [&](int i, int j) { return !graph.is_zero(matrix.at(i, j)); });
}

std::vector<NodeId> stored_entries(const NodeMatrix& matrix, const Sparsity& sparsity) {
  std::vector<NodeId> entries;
  for (int j = 0; j < sparsity.cols; ++j) {
    const auto at = static_cast<std::size_t>(j);
    for (int k = sparsity.column_begin[at]; k < sparsity.column_begin[at + 1]; ++k) {
      entries.push_back(matrix.at(sparsity.row[static_cast<std::size_t>(k)], j));
    }
  }
  return entries;
}

}  // namespace flatdyn
