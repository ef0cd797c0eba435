// SPDX-License-Identifier: GPL-2.0-or-later
// The closed form's derivatives, and the terms in products of velocities where these are not the rates of coordinates:
// with a floating base or spherical joints.
#pragma once

#include "derivation/closed_form/closed_form.hpp"

namespace flatdyn {

// The rate of a function of the position while entry k of q̇ (or v) is 1 and all others are 0. It is ∂/∂q_k for a
// joint of one axis; 0 for a floating base, on whose pose nothing depends; with q̇ = ½ q (0, ω) for an entry of the
// angular velocity of a spherical joint.
Number rate_along(const Number& function, int k, const Mechanism& mechanism, const ClosedForm& form);

// The terms of h_k(q, v) of every equation, from B by the equations of Poincaré, Hamel and Boltzmann:
//     Σ_j b_kj v̇_j + Σ_ij (X_i b_kj - ½ X_k b_ij) v_i v_j + s_k(v, B v) + g_k = τ_k.
// X_i is rate_along() entry i. With p = B v, s is what axes that turn and move add: ω × f and ω × n + v × f for the
// base's p = (f, n), and ω × n for the p = n of a spherical joint.
std::vector<VelocityProducts> velocity_terms(const Mechanism& mechanism, const ClosedForm& form);

}  // namespace flatdyn
