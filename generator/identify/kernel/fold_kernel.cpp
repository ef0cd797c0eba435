// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled twice (CMakeLists.txt): FLATDYN_KERNEL is the name of the function. Eigen's namespace is renamed along, so
// that the linker does not mix up instructions of the two.
#define Eigen FLATDYN_KERNEL_EIGEN
#include <Eigen/Core>
#include <cmath>

#include "identify/fold.hpp"

namespace flatdyn {

void FLATDYN_KERNEL(double* R, FoldedColumn* rows, int cols);

// Householder's reflections (Golub and Van Loan, 5.1). Above the rows, R has only its diagonal entry in column j, so
// that reflection j is of one row of R and these rows: short enough to stay in registers.
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
