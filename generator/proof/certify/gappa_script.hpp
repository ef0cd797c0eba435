// SPDX-License-Identifier: GPL-2.0-or-later
// Scripts for Gappa, each with one formula, which it proves or refuses.
#pragma once

#include <string>
#include <vector>

#include "proof/certify/error_terms.hpp"

namespace flatdyn {

struct GappaScript {
  std::string name;  // name of its file: "inverse_dynamics.tau_1.g"
  std::string text;
};

// The name of the result of operation k in the scripts: "x5", "s_2", "qd_1", or an expression of such.
std::string name_in_scripts(ErrorAnalysis& analysis, int k);

// Scripts that prove that no operation of the text makes a larger error than assumed if its result before rounding is
// within the bound of `analysis`; each covers some hundred operations.
std::vector<GappaScript> rounding_scripts(const std::string& function, ErrorAnalysis& analysis,
                                          const RoundingFormat& format);

// A script that proves that these errors, times the sensitivities, add up to no more than the bound. `output`:
// "tau[0]".
GappaScript sum_script(const std::string& function, const std::string& output, const std::string& unit,
                       const OutputError& error);

}  // namespace flatdyn
