// SPDX-License-Identifier: GPL-2.0-or-later
// [A b] = Q R, of any number of rows, folded into R block by block as rows come (Householder; Golub and Van Loan, 5.2):
// |A x - b| = |R (x, -1)| for every x, and memory does not grow.
#pragma once

#include <Eigen/Core>

namespace flatdyn {

class TriangularFactor {
 public:
  // columns: of A, without b.
  explicit TriangularFactor(int columns);

  int columns() const { return static_cast<int>(rows_.cols()) - 1; }
  // Rows folded so far.
  long count() const { return count_; }

  // A row of A to be filled in by the caller, and the entry of b: `entries` has columns() + 1 places.
  auto next_row() {
    if (held_ == rows_.rows()) fold();
    ++count_;
    return rows_.row(held_++);
  }

  // R, (columns() + 1)², upper triangular; zero rows where there were fewer rows than columns.
  Eigen::MatrixXd factor();
  // Joins another's R, of `count` rows.
  void join(const Eigen::MatrixXd& factor, long count);

 private:
  void fold();

  Eigen::MatrixXd rows_;  // R on top, then rows not yet folded
  Eigen::Index held_;
  long count_ = 0;
};

}  // namespace flatdyn
