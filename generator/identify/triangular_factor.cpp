// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/triangular_factor.hpp"

#include "identify/triangularise.hpp"

namespace flatdyn {
namespace {

// Of rows between two folds: R itself is folded again each time, which costs little when it is this much shorter.
constexpr Eigen::Index kFewestRows = 256;
constexpr Eigen::Index kRowsPerColumn = 24;

}  // namespace

TriangularFactor::TriangularFactor(int columns)
    : rows_(columns + 1 + std::max(kFewestRows, kRowsPerColumn * (columns + 1)), columns + 1), held_(columns + 1) {
  rows_.topRows(held_).setZero();
}

void TriangularFactor::fold() {
  const Eigen::Index size = rows_.cols();
  if (held_ == size) return;
  triangularise(rows_.data(), static_cast<int>(rows_.rows()), static_cast<int>(held_), static_cast<int>(size));
  held_ = size;
}

Eigen::MatrixXd TriangularFactor::factor() {
  fold();
  return rows_.topRows(rows_.cols());
}

void TriangularFactor::join(const Eigen::MatrixXd& factor, long count) {
  for (Eigen::Index k = 0; k < factor.rows(); ++k) next_row() = factor.row(k);
  count_ += count - factor.rows();
}

}  // namespace flatdyn
