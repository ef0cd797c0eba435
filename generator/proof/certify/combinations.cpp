// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/combinations.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cstddef>

namespace flatdyn {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Combinations::Combinations(const std::vector<std::vector<F>>& D, const MatrixXd& in_double) {
  constexpr double kLeast = 1e-4, kLeastRatio = 1e-6;  // thresholds for singular values
  const int rank = eliminate(D);
  const Eigen::JacobiSVD<MatrixXd> svd(in_double, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorXd& sigma = svd.singularValues();
  if (rank == 0 || sigma(rank - 1) < std::max(kLeast, kLeastRatio * sigma(0))) return;
  size_of_inverse_ = 1 / sigma(rank - 1);
  inverse_ = svd.matrixV().leftCols(rank) * sigma.head(rank).cwiseInverse().asDiagonal() *
             svd.matrixU().leftCols(rank).transpose();
  columns_ = in_double;
}

// D c differs from y by the residual and by the sampling errors of y and of D. This difference, divided by the least
// singular value, bounds the distance of c from a combination that holds exactly.
std::optional<Combinations::Found> Combinations::of(const std::vector<F>& y, const VectorXd& in_double) const {
  if (columns_.size() == 0) return std::nullopt;
  for (const std::vector<F>& row : annihilators_) {
    F sum(0);
    for (std::size_t k = 0; k < y.size(); ++k) sum += row[k] * y[k];
    if (!(sum == F(0))) return std::nullopt;
  }
  constexpr double kFit = 1e-10;
  const VectorXd c = inverse_ * in_double;
  const double size = in_double.norm(), rest = (columns_ * c - in_double).norm();
  if (!(rest <= kFit * size)) return std::nullopt;
  return Found{c, size_of_inverse_ * (rest + 2 * kSamples * (size + columns_.norm() * c.norm()))};
}

// Eliminates in (D, 1); returns the rank. From this row on, the rows are (0, n).
int Combinations::eliminate(const std::vector<std::vector<F>>& D) {
  std::vector<std::vector<F>> rows = D;
  const std::size_t columns = D.front().size();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].resize(columns + D.size(), F(0));
    rows[k][columns + k] = F(1);
  }
  auto next = rows.begin();
  for (std::size_t column = 0; column < columns; ++column) {
    const auto pivot =
        std::find_if(next, rows.end(), [column](const std::vector<F>& row) { return !(row[column] == F(0)); });
    if (pivot == rows.end()) continue;
    std::iter_swap(next, pivot);
    for (auto row = next + 1; row != rows.end(); ++row) {
      const F factor = (*row)[column] / (*next)[column];
      for (std::size_t j = column; j < row->size(); ++j) (*row)[j] -= factor * (*next)[j];
    }
    ++next;
  }
  for (auto row = next; row != rows.end(); ++row) {
    annihilators_.emplace_back(row->begin() + static_cast<std::ptrdiff_t>(columns), row->end());
  }
  return static_cast<int>(next - rows.begin());
}

}  // namespace flatdyn
