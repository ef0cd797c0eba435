// SPDX-License-Identifier: GPL-2.0-or-later
// [A b] = Q R for any number of rows, folded into R a few at a time as they arrive (Householder; Golub and Van Loan,
// 5.2). |A x - b| = |R (x, -1)| for every x, and memory does not grow.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laboratory/identify/fold.hpp"

namespace flatdyn {

class TriangularFactor {
 public:
  // columns: the number of columns of A, without b.
  explicit TriangularFactor(int columns);

  int columns() const { return static_cast<int>(R_.cols()) - 1; }
  // The number of rows folded so far.
  long count() const { return count_; }

  // The next row, for the caller to fill in: `entries` has columns() + 1 places, for the row of A and the entry of b.
  auto next_row() {
    if (held_ == kFoldedRows) fold_held();
    ++count_;
    return held_rows_.row(held_++);
  }

  // R, (columns() + 1)², upper triangular; zero rows if there were fewer rows than columns.
  Eigen::MatrixXd factor();
  // Joins the factor of `count` other rows.
  void join(const Eigen::MatrixXd& factor, long count);

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void fold_held();

  Rows R_;
  Rows held_rows_;                     // rows that are not folded yet
  Eigen::Index held_ = 0;              // the number of held rows
  std::vector<FoldedColumn> columns_;  // the held rows, column by column
  long count_ = 0;
};

// The square factor R of tall = Q R; its last rows are zero if there are fewer rows than columns.
Eigen::MatrixXd triangular_factor_of(const Eigen::MatrixXd& tall);

}  // namespace flatdyn
