// SPDX-License-Identifier: GPL-2.0-or-later
// [A b] = Q R, of any number of rows, folded into R a few at a time as they come (Householder; Golub and Van
// Loan, 5.2): |A x - b| = |R (x, -1)| for every x, and memory does not grow.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/fold.hpp"

namespace flatdyn {

class TriangularFactor {
 public:
  // columns: of A, without b.
  explicit TriangularFactor(int columns);

  int columns() const { return static_cast<int>(R_.cols()) - 1; }
  // Rows folded so far.
  long count() const { return count_; }

  // A row of A to be filled in by the caller, and the entry of b: `entries` has columns() + 1 places.
  auto next_row() {
    if (held_ == kFoldedRows) fold_held();
    ++count_;
    return held_rows_.row(held_++);
  }

  // R, (columns() + 1)², upper triangular; zero rows where there were fewer rows than columns.
  Eigen::MatrixXd factor();
  // Joins another's R, of `count` rows.
  void join(const Eigen::MatrixXd& factor, long count);

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void fold_held();

  Rows R_;
  Rows held_rows_;                     // not yet folded
  Eigen::Index held_ = 0;              // of them
  std::vector<FoldedColumn> columns_;  // the same, column by column
  long count_ = 0;
};

// R of tall = Q R, square; zero rows at its end if there are fewer rows than columns.
Eigen::MatrixXd triangular_factor_of(const Eigen::MatrixXd& tall);

}  // namespace flatdyn
