// SPDX-License-Identifier: GPL-2.0-or-later
// The choice of fused multiply-adds, fma(a, b, c) = a b + c, rounded once.
//
// A sum of n summands of which p are products takes n - 1 instructions if one summand is no product, or a product that
// is computed anyway: the sum starts with it, and the products are multiplied and added at once. Otherwise it starts
// with a product, and takes one more. The graph stays as it is: values are the same, only rounding differs.
#pragma once

#include <vector>

#include "graph/count.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// By node: whether it is a product that all sums which use it multiply and add at once, so that it is not computed by
// itself. A product of two factors may be multiplied in several sums; one of more factors is fused only into one. A
// product that several sums can start with is computed.
std::vector<bool> products_to_fuse(const Function& function);

// The operations of one evaluation; if the text `fuses`, with these products fused, and additions and multiplications
// are those that remain.
OperationCount operations_as_written(const Function& function, bool fuses);

}  // namespace flatdyn
