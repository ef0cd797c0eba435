// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters for people and for programs: each combination, its value, and the parameters that cannot be
// identified.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "derivation/parameters/file_parameters.hpp"

namespace flatdyn {

// Their names refer to parameters in `frames`, whose values stand before them.
std::string describe_base(const Mechanism& mechanism, ParameterSet set, ParameterFrames frames);
// Canonical frames always; those of the file as well if `frames` says so.
nlohmann::ordered_json base_json(const Mechanism& mechanism, ParameterSet set, ParameterFrames frames);

// The number of parameters in the set.
std::size_t parameter_count(const Mechanism& mechanism, ParameterSet set, ParameterFrames frames);

// The names of parameters that cannot be identified, separated by commas, with the reason that they share.
std::vector<std::pair<std::string, std::string>> unidentifiable_names(const Mechanism& mechanism,
                                                                      const BaseParameters& base, ParameterSet set,
                                                                      ParameterFrames frames);

}  // namespace flatdyn
