// SPDX-License-Identifier: GPL-2.0-or-later
// Friction of drives, such as gears, that grows with the torque that they pass on: a joint that gets τ takes
//   τ_d = τ + c |τ| s(q̇)
// from its drive, with s as in the joint's own friction (dry_friction.hpp), which is part of τ. For 0 <= c < 1 this can
// be solved for τ = (τ_d - c s |τ_d|)/(1 - c² s²). B q̈ + n = τ holds at the joint, so that no other function has it.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// Both throw Failure(unsupported) where coordinates and joints are not the same.
Function derive_drive_torque(const Mechanism& mechanism, const Choices& choices);       // τ_d from τ
Function derive_torque_from_drive(const Mechanism& mechanism, const Choices& choices);  // τ from τ_d

}  // namespace flatdyn
