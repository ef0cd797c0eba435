// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace flatdyn {

// (Jᵀ h_e)_i in N m or N, from a Jacobian of 6 rows, stored row by row; 0 if h_e is empty.
double tip_torque(std::span<const double> J, std::span<const double> h_e, std::size_t joint);

}  // namespace flatdyn
