// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/fold.hpp"

namespace flatdyn {

// The two builds of fold_kernel.cpp: for any machine of this architecture, and for those with AVX2 and FMA.
void fold_anywhere(double* R, FoldedColumn* rows, int cols);
#ifdef FLATDYN_AVX2_KERNEL
void fold_avx2(double* R, FoldedColumn* rows, int cols);
#endif

void fold(double* R, FoldedColumn* rows, int cols) {
#ifdef FLATDYN_AVX2_KERNEL
  static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (has_avx2) return fold_avx2(R, rows, cols);
#endif
  fold_anywhere(R, rows, cols);
}

}  // namespace flatdyn
