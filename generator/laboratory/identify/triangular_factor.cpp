// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {

TriangularFactor::TriangularFactor(int columns)
    : R_(Rows::Zero(columns + 1, columns + 1)),
      held_rows_(kFoldedRows, columns + 1),
      columns_(static_cast<std::size_t>(columns) + 1) {}

void TriangularFactor::fold_held() {
  held_rows_.bottomRows(kFoldedRows - held_).setZero();
  Eigen::Map<Eigen::MatrixXd>(columns_.front().entries, kFoldedRows, R_.cols()) = held_rows_;
  fold(R_.data(), columns_.data(), static_cast<int>(R_.cols()));
  held_ = 0;
}

Eigen::MatrixXd TriangularFactor::factor() {
  fold_held();
  return R_;
}

void TriangularFactor::join(const Eigen::MatrixXd& factor, long count) {
  for (Eigen::Index k = 0; k < factor.rows(); ++k) next_row() = factor.row(k);
  count_ += count - factor.rows();
}

Eigen::MatrixXd triangular_factor_of(const Eigen::MatrixXd& tall) {
  TriangularFactor factor(static_cast<int>(tall.cols()) - 1);
  for (Eigen::Index k = 0; k < tall.rows(); ++k) factor.next_row() = tall.row(k);
  return factor.factor();
}

}  // namespace flatdyn
