// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/triangularise.hpp"

namespace flatdyn {

// triangularise_kernel.cpp, compiled for any machine of this architecture, and for those with AVX2 and FMA.
void triangularise_anywhere(double* matrix, int stride, int rows, int cols);
#ifdef FLATDYN_AVX2_KERNEL
void triangularise_avx2(double* matrix, int stride, int rows, int cols);
#endif

void triangularise(double* matrix, int stride, int rows, int cols) {
#ifdef FLATDYN_AVX2_KERNEL
  static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (has_avx2) return triangularise_avx2(matrix, stride, rows, cols);
#endif
  triangularise_anywhere(matrix, stride, rows, cols);
}

}  // namespace flatdyn
