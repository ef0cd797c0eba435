// SPDX-License-Identifier: GPL-2.0-or-later
// What a header says of the base parameters π_b, where a function is linear in them.
#pragma once

#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// Whether a function takes π_b or gives the columns for it.
bool uses_base_parameters(const Function& function);

// The emitted constants, in this order.
inline constexpr const char* kBaseConstants[] = {"base_parameter_count", "base_parameter_names",
                                                 "base_parameter_values"};

struct BaseConstants {
  std::vector<std::string> comment;  // lines: each combination, "pi_b[0] = I1zz + …"
  int count = 0;
  std::vector<ConstantArray> arrays;  // values only for a robot without free symbols
};

// `names`: what kBaseConstants are called in this header.
BaseConstants base_constants(const Mechanism& mechanism, const std::vector<std::string>& names, const Dialect& dialect);

}  // namespace flatdyn
