// SPDX-License-Identifier: GPL-2.0-or-later
// Sparse matrices as CasADi stores them: the entries that are not always zero, column by column.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// Which entries are stored. Column j has the rows row[column_begin[j]] to row[column_begin[j + 1] - 1], in order.
struct Sparsity {
  int rows = 0, cols = 0;
  std::vector<int> column_begin;  // cols + 1 numbers
  std::vector<int> row;

  int count() const { return static_cast<int>(row.size()); }
  // The array that stands for it in CasADi's interface: sizes, then column_begin and row; or sizes and 1 if all entries
  // are stored.
  std::vector<int> compressed() const;
};

Sparsity dense(int rows, int cols);
Sparsity without_entries(int rows, int cols);

// A matrix of nodes, column by column, all entries.
struct NodeMatrix {
  int rows = 0, cols = 0;
  std::vector<NodeId> entries;

  NodeMatrix(int row_count, int column_count);
  NodeId& at(int row, int col) { return entries[place(row, col)]; }
  NodeId at(int row, int col) const { return entries[place(row, col)]; }
  NodeMatrix transposed() const;

 private:
  std::size_t place(int row, int col) const { return static_cast<std::size_t>(col * rows + row); }
};

// The matrix of an output: a vector has one column.
NodeMatrix matrix_of(const Output& output);

// Where a matrix has entries that are not the constant 0.
Sparsity sparsity_of(const Graph& graph, const NodeMatrix& matrix);

// The entries that are stored, in order.
std::vector<NodeId> stored_entries(const NodeMatrix& matrix, const Sparsity& sparsity);

}  // namespace flatdyn
