// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters for people and for programs: each combination, its value, and the parameters that cannot be
// identified.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "symbolic/parameters/base_parameters.hpp"

namespace flatdyn {

std::string describe_base(const Mechanism& mechanism, ParameterSet set);
// The parameters that cannot be identified, each with its reason.
nlohmann::ordered_json unidentifiable_json(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set);
nlohmann::ordered_json base_json(const Mechanism& mechanism, ParameterSet set);

}  // namespace flatdyn
