// SPDX-License-Identifier: GPL-2.0-or-later
// Function → an order of statements: which nodes become variables, and when each value is computed.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// An entry of an output.
struct Target {
  int output = 0;
  int entry = 0;
};

// A statement that makes a variable of the node, or (if there are targets) stores it in all of them.
struct Statement {
  NodeId node = 0;
  std::vector<Target> targets;
};

struct Schedule {
  std::vector<Statement> statements;
  std::vector<bool> is_variable;  // by id; inputs that are read are variables, too, without a statement
};

// The variables are nodes with two uses, sines and cosines, named sums and quotients, and operands that would make a
// line too long. Sines and cosines come first (a library call spills every register), constants that are stored last.
// Between them the order is depth-first from the outputs, operands nearest to the inputs first, or one in which fewer
// values are live at once (statement_order.hpp). Ids break ties.
//
// `is_fused`: by node, which products are written in every sum that uses them (graph/passes/fuse_products.hpp), never
// as variables. Lives::fewest: for targets where values beyond the registers cost more than waiting for one another.
enum class Lives { short_ones, fewest };
Schedule make_schedule(const Function& function, const std::vector<bool>& is_fused, Lives lives = Lives::short_ones);

// The number of values that are live at once in the order of Lives::fewest, where most are: inputs, sines, variables.
long most_live_values(const Function& function);

}  // namespace flatdyn
