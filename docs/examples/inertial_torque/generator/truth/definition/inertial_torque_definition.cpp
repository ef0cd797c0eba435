// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/inertial_torque_definition.hpp"

#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {

constinit const Definition inertial_torque =
    defined_as([](auto& at, const Output&) { return times(at.lagrangian.inertia(), at.qdd()); });

}  // namespace flatdyn::definitions
