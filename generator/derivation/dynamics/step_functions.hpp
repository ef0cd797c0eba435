// SPDX-License-Identifier: GPL-2.0-or-later
// Steps in time of length h (s) as functions: positions and velocities after the step. τ is constant over the step, in
// the axes of a floating base, too. There are no closed loops, whose dependent joints a step would open.
//
// Quaternions of spherical joints become those after the step. A floating base has no position among the arguments: its
// displacement, in base axes before the step, and its turn are outputs.
#pragma once

#include <optional>

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// Semi-implicit Euler: q̇' = q̇ + h q̈(q, q̇, τ), then q' = q + h q̇'. In the formulations of forward dynamics. A floating
// base and spherical joints turn twice by E(h ω'/8) (step_chart.hpp), which is exp(S(h ω')) but for h³ |ω'|³ / 192; the
// base is displaced by h v' in its axes in the middle.
Function derive_semi_implicit_step(const Mechanism& mechanism, const Choices& choices);
std::optional<Function> derive_semi_implicit_step_by_articulated_bodies(const Mechanism& mechanism,
                                                                        const Choices& choices);
std::optional<Function> derive_semi_implicit_step_by_composite_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices);

// The classical Runge-Kutta method of fourth order, likewise, in the changes of positions of step_chart.hpp.
Function derive_runge_kutta_step(const Mechanism& mechanism, const Choices& choices);
std::optional<Function> derive_runge_kutta_step_by_articulated_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices);
std::optional<Function> derive_runge_kutta_step_by_composite_bodies(const Mechanism& mechanism, const Choices& choices);

// One Newton iteration of the implicit midpoint rule (midpoint.hpp) from q̇' = qd_end, and the residual of its torques
// before that.
Function derive_midpoint_step(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn
