// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The torque that holds the arm still, in float, as a small controller would compute it.
void holding_torque(const float* q, float* tau);
void planar_holding_torque(const float* q, float* tau);
