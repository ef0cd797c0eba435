// SPDX-License-Identifier: GPL-2.0-or-later
// The inertia matrix B(q), its Christoffel symbols and C(q, qd) as functions.
#pragma once

#include <optional>

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

Function derive_inertia_matrix(const Mechanism& mechanism, const Choices& choices);
Function derive_christoffel(const Mechanism& mechanism, const Choices& choices);
Function derive_coriolis_from_christoffel(const Mechanism& mechanism, const Choices& choices);
// nullopt for robots with closed loops.
std::optional<Function> derive_coriolis_from_momenta(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
