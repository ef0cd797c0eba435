// SPDX-License-Identifier: GPL-2.0-or-later
// Laws of friction beyond F_v q̇ + F_s sgn q̇, which π has. Their further parameters are identified with π_b and
// reported; a robot file has F_v and F_s alone.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace flatdyn {

enum class FrictionLaw : std::uint8_t {
  coulomb,     // F_v q̇ + F_s sgn q̇
  asymmetric,  // and F_a |sgn q̇|: F_s + F_a forwards, F_s - F_a backwards
  stribeck,    // and F_b exp(-(q̇/v)²) sgn q̇: F_s + F_b near rest
  smooth,      // F_v q̇ + F_s tanh(q̇/v)
  load,        // and c |τ_l| sgn q̇, where τ_l is the torque that the drive carries: τ without friction and rotors
};

// Whether the law has a speed v for each joint, in which it is not linear.
constexpr bool has_speed(FrictionLaw law) { return law == FrictionLaw::stribeck || law == FrictionLaw::smooth; }
// Whether torques are linear in all parameters of the law, so that the logs are read once.
constexpr bool is_linear(FrictionLaw law) { return !has_speed(law) && law != FrictionLaw::load; }

}  // namespace flatdyn
