// SPDX-License-Identifier: GPL-2.0-or-later
// This file is compiled twice (CMakeLists.txt), with FLATDYN_KERNEL the name of the function. Eigen's namespace is
// renamed too, so that the linker does not mix up the instructions of the two.
#define Eigen FLATDYN_KERNEL_EIGEN
#include <Eigen/Core>
#include <cmath>

#include "laboratory/identify/fold.hpp"

namespace flatdyn {

void FLATDYN_KERNEL(double* R, FoldedColumn* rows, int cols);

// Householder reflections (Golub and Van Loan, 5.1). R has only its diagonal entry in column j, so reflection j
// involves one row of R and these rows, which is short enough to stay in registers.
void FLATDYN_KERNEL(double* R, FoldedColumn* rows, int cols) {
  using Column = Eigen::Map<Eigen::Matrix<double, kFoldedRows, 1>, Eigen::Aligned64>;
  for (int j = 0; j < cols; ++j) {
    Column v(rows[j].entries);
    const double below = v.squaredNorm();
    if (below == 0) continue;
    double* const r = R + j * cols;
    const double length = std::sqrt(r[j] * r[j] + below), beta = r[j] > 0 ? -length : length;
    const double tau = (beta - r[j]) / beta;
    const Eigen::Matrix<double, kFoldedRows, 1> u = v / (r[j] - beta);
    r[j] = beta;
    for (int k = j + 1; k < cols; ++k) {
      Column a(rows[k].entries);
      const double w = tau * (r[k] + u.dot(a));
      r[k] -= w;
      a -= w * u;
    }
  }
}

}  // namespace flatdyn
