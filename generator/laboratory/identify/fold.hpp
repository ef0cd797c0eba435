// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn {

inline constexpr int kFoldedRows = 32;  // rows folded at a time

// One column of the rows that are folded at a time.
struct alignas(64) FoldedColumn {
  double entries[kFoldedRows];
};

// Replaces R by the upper triangular factor of R with kFoldedRows rows below it. R: cols × cols, row by row; what is
// below its diagonal is not read. rows: column by column, overwritten. Uses AVX2 where the machine has it.
void fold(double* R, FoldedColumn* rows, int cols);

}  // namespace flatdyn
