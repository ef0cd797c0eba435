// SPDX-License-Identifier: GPL-2.0-or-later
// The text about the base parameters π_b in a header whose functions are linear in them.
#pragma once

#include <string>
#include <vector>

#include "code/table.hpp"
#include "derivation/parameters/parameter_frames.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Whether a function takes π_b or returns the columns that multiply it.
bool uses_base_parameters(const Function& function);

// The emitted constants, in this order.
inline constexpr const char* kBaseConstants[] = {"base_parameter_count", "base_parameter_names",
                                                 "base_parameter_values"};

struct BaseConstants {
  std::vector<std::string> comment;  // lines with each combination, "pi_b[0] = I1zz + …"
  int count = 0;
  std::vector<code::Table> tables;  // values only for a robot without free symbols
};

// `names`: the names of kBaseConstants in this header; `frames`: those to which names of parameters refer.
BaseConstants base_constants(const Mechanism& mechanism, const std::vector<std::string>& names, ParameterFrames frames);

}  // namespace flatdyn
