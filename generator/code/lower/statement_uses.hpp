// SPDX-License-Identifier: GPL-2.0-or-later
// Which statement reads which values.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

struct Schedule;
struct Statement;

// A value has the number of the statement that makes it. Those that no statement makes (inputs, sines and cosines,
// which come before) have numbers from statements() on.
struct StatementUses {
  std::vector<std::vector<int>> needs;  // by statement: values, each once
  std::vector<std::vector<int>> users;  // by value: statements
  std::vector<bool> makes;              // by statement: whether it makes a value
  std::vector<int> read_at_the_end;     // values that are read after all statements

  int statements() const { return static_cast<int>(needs.size()); }
};

// The uses of these statements of the schedule; `at_the_end` are nodes that are read after them.
StatementUses uses_of(const Function& function, const Schedule& schedule, const std::vector<Statement>& statements,
                      const std::vector<NodeId>& at_the_end);

}  // namespace flatdyn
