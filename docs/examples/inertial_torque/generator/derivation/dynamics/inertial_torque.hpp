// SPDX-License-Identifier: GPL-2.0-or-later
// The torques that accelerate the joints, as a function.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

Function derive_inertial_torque(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
