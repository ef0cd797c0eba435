// SPDX-License-Identifier: GPL-2.0-or-later
// Questions about code that are answered by going through it.
#pragma once

#include <string>
#include <vector>

#include "code/statement.hpp"

namespace flatdyn::code {

// Whether the operation is anywhere in the statements.
bool uses(const Statements& statements, Operation operation);

// Whether zeros are stored together anywhere in the statements.
bool stores_zeros(const Statements& statements);

// The names that a statement reads or stores: of variables; and of arrays, numbers, structures, and `kParameters` for
// the values of free symbols. In the order of the text, repeated where they are.
struct Names {
  std::vector<std::string> variables, others;
};
Names names_in(const Statement& statement);

// Marks the arguments of calls that are arrays of the same statements.
void mark_local_arguments(Statements& statements);

}  // namespace flatdyn::code
