// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled twice (CMakeLists.txt): FLATDYN_KERNEL is the name of the function. Eigen's namespace is renamed along, so
// that the linker does not mix up instructions of the two.
#define Eigen FLATDYN_KERNEL_EIGEN
#include <Eigen/QR>

namespace flatdyn {

void FLATDYN_KERNEL(double* matrix, int stride, int rows, int cols);

void FLATDYN_KERNEL(double* matrix, int stride, int rows, int cols) {
  Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> a(matrix, rows, cols, Eigen::OuterStride<>(stride));
  Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> in_place(a);
  a.topRows(cols).triangularView<Eigen::StrictlyLower>().setZero();
}

}  // namespace flatdyn
