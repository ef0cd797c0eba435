// SPDX-License-Identifier: GPL-2.0-or-later
// Gappa, the prover of bounds: Debian's package gappa.
#pragma once

#include <vector>

#include "proof/certify/gappa_script.hpp"

namespace flatdyn {

// Whether Gappa is installed.
bool has_gappa();

enum class Verdict { proven, refused, out_of_time };

// The verdict on each script. As many scripts run at a time as there are cores; each may take `seconds`. Throws
// Failure(io).
std::vector<Verdict> run_gappa(const std::vector<GappaScript>& scripts, double seconds);

}  // namespace flatdyn
