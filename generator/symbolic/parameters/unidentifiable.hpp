// SPDX-License-Identifier: GPL-2.0-or-later
// Parameters that no torque depends on, and the reasons.
#pragma once

#include <string>
#include <vector>

#include "symbolic/parameters/base_parameters.hpp"

namespace flatdyn {

struct Unidentifiable {
  int index = 0;       // index in π
  std::string reason;  // one clause of text
};

// The parameters of `set` that occur in no base parameter.
std::vector<Unidentifiable> unidentifiable(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set);

}  // namespace flatdyn
