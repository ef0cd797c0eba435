// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// Makes the pair of factors that most products have in common a node, repeatedly: x·y of x·y·z + … and x·y·w + …. The
// coefficient of a product is a factor like any other, so k·x is shared as well; signs are left out.
Function share_products(const Function& function);

// The same pass after multiplying out all products, whatever it costs; for passes that change sums.
Function with_shared_products(const Function& function);

}  // namespace flatdyn
