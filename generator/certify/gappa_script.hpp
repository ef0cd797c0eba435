// SPDX-License-Identifier: GPL-2.0-or-later
// What Gappa is asked: one formula per script, which it proves, or refuses.
#pragma once

#include <string>
#include <vector>

#include "certify/error_terms.hpp"

namespace flatdyn {

struct GappaScript {
  std::string name;  // of its file: "inverse_dynamics.tau_1.g"
  std::string text;
};

// That every operation of the text makes no larger error than was assumed, where it is before rounding no larger than
// `analysis` says: some hundred operations in each script.
std::vector<GappaScript> rounding_scripts(const std::string& function, ErrorAnalysis& analysis,
                                          const RoundingFormat& format);

// That these errors, times the sensitivities, add up to no more than the bound. `output`: "tau[0]".
GappaScript sum_script(const std::string& function, const std::string& output, const std::string& unit,
                       const OutputError& error);

}  // namespace flatdyn
