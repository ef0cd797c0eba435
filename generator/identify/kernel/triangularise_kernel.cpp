// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled twice (CMakeLists.txt): FLATDYN_KERNEL is the name of the function. Eigen's namespace is renamed along, so
// that the linker does not mix up instructions of the two.
#define Eigen FLATDYN_KERNEL_EIGEN
#include <Eigen/QR>

namespace flatdyn {

void FLATDYN_KERNEL(double* matrix, int stride, int rows, int cols);

void FLATDYN_KERNEL(double* matrix, int stride, int rows, int cols) {
  using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  // HouseholderQR's own blocks have 32 columns, which of a few dozen leaves nearly all outside of matrix products.
  constexpr int kBlock = 8;
  Matrix a(matrix, rows, cols, Eigen::OuterStride<>(stride));
  Eigen::VectorXd coefficients(cols);
  Eigen::internal::householder_qr_inplace_blocked<Matrix, Eigen::VectorXd>::run(a, coefficients, kBlock);
  a.topRows(cols).triangularView<Eigen::StrictlyLower>().setZero();
}

}  // namespace flatdyn
