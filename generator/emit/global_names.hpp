// SPDX-License-Identifier: GPL-2.0-or-later
// What all that a header defines at namespace scope is called. It is known before any function is written, as the
// variables of functions must differ from it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

struct GlobalNames {
  std::vector<std::string> functions;
  std::vector<std::string> given;                 // in C, of the functions that take sines and cosines
  std::vector<std::vector<std::string>> nonzero;  // by function and output: of a matrix's structural zeros
  std::vector<std::string> base;                  // of kBaseConstants; empty where no function needs them
  std::set<std::string> taken;                    // all of them, those of constants, and the language's own
};

GlobalNames global_names(const Mechanism& mechanism, const std::vector<Function>& functions, const Dialect& dialect);

}  // namespace flatdyn
