// SPDX-License-Identifier: BSD-3-Clause
// A second translation unit with the same header.
#include "controller.hpp"

#include "panda.hpp"

void holding_torque(const float* q, float* tau) { panda::gravity(q, tau); }
