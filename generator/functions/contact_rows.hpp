// SPDX-License-Identifier: GPL-2.0-or-later
// The rows of functions about the scene's contacts.
#pragma once

#include <vector>

#include "functions/function_row.hpp"

namespace flatdyn {

// The rows of a table with these in front of those of regressors.
std::vector<FunctionRow> with_contacts(std::vector<FunctionRow> rows);

}  // namespace flatdyn
