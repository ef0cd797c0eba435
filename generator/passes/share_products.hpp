// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "graph/function.hpp"

namespace flatdyn {

// x·y·z + … and x·y·w + …: the pair of factors that most products have in common becomes a node of its own, and so on.
// The coefficient of a product is a factor like any other, so k·x is shared as well; signs are left out.
Function share_products(const Function& function);

// The same, the products being multiplied out first, whatever it costs: for passes that change sums.
Function with_shared_products(const Function& function);

}  // namespace flatdyn
