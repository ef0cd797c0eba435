// SPDX-License-Identifier: GPL-2.0-or-later
// The redundant part of a body's parameters, which its joint's motion does not affect: M_j of base_parameters.hpp.
#pragma once

#include <vector>

#include "derivation/parameters/parameters.hpp"

namespace flatdyn {

// The number of a joint's parameters that affect energies: ten of its body, and I_m.
inline constexpr int kEnergyParameters = 11;

// A vector φ of M_j with 1 at `lead` and 0 at the leads of the other vectors.
struct RedundantPart {
  Parameter lead;
  std::vector<Number> entries;  // kEnergyParameters numbers, in the order of Parameter
};

// A basis of M_j for every joint j. The leads are the parameters that come last in kPreference, as far as possible.
// A floating base keeps all of its own.
std::vector<std::vector<RedundantPart>> redundant_parts(const Mechanism& mechanism);

}  // namespace flatdyn
