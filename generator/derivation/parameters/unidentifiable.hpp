// SPDX-License-Identifier: GPL-2.0-or-later
// Parameters that no torque depends on, and the reasons.
#pragma once

#include <string>
#include <vector>

#include "derivation/parameters/file_parameters.hpp"

namespace flatdyn {

struct Unidentifiable {
  int index = 0;       // index in π, or in the file's parameters
  std::string reason;  // one clause of text
};

// The parameters of `set` that occur in no base parameter.
std::vector<Unidentifiable> unidentifiable(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set);

// The same of the file's parameters, by index in `parameters`.
std::vector<Unidentifiable> unidentifiable_in_file(const Mechanism& mechanism, const BaseParameters& base,
                                                   const std::vector<FileParameter>& parameters);

}  // namespace flatdyn
