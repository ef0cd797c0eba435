// SPDX-License-Identifier: GPL-2.0-or-later
// Steps in time of length h (s) as functions: positions and rates after the step. τ is constant over the step. Rates
// have to be the derivatives of positions, and there are no closed loops, whose dependent joints a step would open.
#pragma once

#include <optional>

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// Semi-implicit Euler: q̇' = q̇ + h q̈(q, q̇, τ), then q' = q + h q̇'. In the formulations of forward dynamics.
Function derive_semi_implicit_step(const Mechanism& mechanism, const Choices& choices);
std::optional<Function> derive_semi_implicit_step_by_articulated_bodies(const Mechanism& mechanism,
                                                                        const Choices& choices);
std::optional<Function> derive_semi_implicit_step_by_composite_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices);

// The classical Runge-Kutta method of fourth order, likewise.
Function derive_runge_kutta_step(const Mechanism& mechanism, const Choices& choices);
std::optional<Function> derive_runge_kutta_step_by_articulated_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices);
std::optional<Function> derive_runge_kutta_step_by_composite_bodies(const Mechanism& mechanism, const Choices& choices);

// One Newton iteration of the implicit midpoint rule (midpoint.hpp) from q̇' = qd_end, and the residual of its torques
// before that.
Function derive_midpoint_step(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
