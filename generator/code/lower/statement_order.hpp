// SPDX-License-Identifier: GPL-2.0-or-later
// The order of statements. Values that are live at once beyond a processor's registers are put aside on the stack, so
// an order in which lives are short saves instructions and time.
#pragma once

#include <vector>

#include "code/lower/statement_uses.hpp"

namespace flatdyn {

// The statements' numbers, each after those that it needs. They stay in their order where few values are live at once:
// short lives leave a processor less to do side by side.
std::vector<int> order_of_short_lives(const StatementUses& uses);

// The order among some, that given included, in which fewest values are live at once where most are.
std::vector<int> order_of_fewest_values(const StatementUses& uses);

// The number of values that are live at once, where most are, if the statements stay in their order.
long most_live(const StatementUses& uses);

}  // namespace flatdyn
