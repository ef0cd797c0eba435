// SPDX-License-Identifier: GPL-2.0-or-later
// The energies of a robot as functions.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

Function derive_kinetic_energy(const Mechanism& mechanism, const Choices& choices);
Function derive_potential_energy(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
