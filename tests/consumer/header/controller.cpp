// SPDX-License-Identifier: BSD-3-Clause
// A second translation unit with the same headers.
#include "controller.hpp"

#include "example_7_2_pair.hpp"
#include "panda.hpp"

void holding_torque(const float* q, float* tau) { panda::gravity(q, tau); }

void planar_holding_torque(const float* q, float* tau) { example_7_2_pair::at(q).gravity(tau); }
