// SPDX-License-Identifier: GPL-2.0-or-later
// Momenta of composite bodies: in addition to mass, first moment and inertia, the quantities on which their
// velocity-dependent torques depend.
#pragma once

#include <vector>

#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

// The momenta of composite body i, in the axes of frame i; u is the velocity of a point relative to the origin of frame
// i, r its displacement from there. L includes spinning rotors.
struct Momenta {
  Vec3 P = zero_vector();   // Σ m u, kg m/s
  Vec3 L = zero_vector();   // Σ m r × u, kg m^2/s
  Mat3 dI = zero_matrix();  // d/dt Σ m (r·r 1 - r rᵀ), kg m^2/s
};

// The momenta of all composite bodies. `bodies`: composites(frames).
std::vector<Momenta> composite_momenta(Frames& frames, const Motion& motion, const std::vector<LinkMotion>& links,
                                       const std::vector<InertialParameters>& bodies);

// The velocity of the origin of frame i as joint i slides, relative to the parent's point that is there at q_i = 0.
// Zero for the motion of a floating base, whose frames all move together.
Vec3 slide_rate(Frames& frames, int i, const Motion& motion, const LinkMotion& link);

}  // namespace flatdyn
