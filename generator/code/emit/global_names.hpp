// SPDX-License-Identifier: GPL-2.0-or-later
// The names of everything that a header defines at namespace scope. They are determined before any function is written,
// as the variables of functions must differ from them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "code/emit/dialect.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct GlobalNames {
  std::vector<std::string> functions;
  std::vector<std::string> sin_cos_variants;      // of the variants that take sines and cosines, if there are any
  std::vector<std::vector<std::string>> nonzero;  // names of a matrix's structural zeros, by function and output
  std::vector<std::string> base;                  // names of kBaseConstants; empty if no function needs them
  std::set<std::string> taken;                    // all of these, the names of constants, and the language's own
};

GlobalNames global_names(const Mechanism& mechanism, const std::vector<Function>& functions, const Dialect& dialect);

}  // namespace flatdyn
