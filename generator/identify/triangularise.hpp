// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn {

// The upper triangular factor of a rows × cols matrix, column by column with `stride`, in place: zeros below the
// diagonal of its first cols rows; what is below those is of no meaning. Uses AVX2 where the machine has it.
void triangularise(double* matrix, int stride, int rows, int cols);

}  // namespace flatdyn
