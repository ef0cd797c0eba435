// SPDX-License-Identifier: GPL-2.0-or-later
// The proof that the emitted code's own sines and cosines are right to a unit in the last place of 1.
#pragma once

#include <string>
#include <vector>

#include "proof/certify/gappa_script.hpp"

namespace flatdyn {

// Scripts for Gappa, the same for every robot: how far the reduced angle is off, and how far the polynomials' values
// are off a sine and a cosine. What they take for granted of polynomials in exact arithmetic, scripts/check-certificate
// proves. `scalar`: "double" or "float".
std::vector<GappaScript> scripts_of_sines(const std::string& scalar);

}  // namespace flatdyn
