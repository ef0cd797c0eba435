// SPDX-License-Identifier: GPL-2.0-or-later
// Residuals that repeat: with the turns of a joint, as the ripple of gears and motors does, or with time, as a
// resonance does. Ripple of the torques that is faster than the filter's band. And friction that changes during the
// logs, as it does while a robot warms up.
#pragma once

#include <optional>
#include <vector>

#include "laboratory/identify/observations.hpp"

namespace flatdyn {

// A sine in an equation's residuals.
struct ResidualLine {
  bool is_of_turns = false;  // of the joint's position; else of time
  double rate = 0;           // periods in a turn (in a metre where the joint slides), or Hz
  double amplitude = 0;      // N m or N
  double share = 0;          // of the residuals' squares
};

// The line that makes up most of the residuals of an equation, more than chance does; nullopt if none does. `residual`:
// by instant, NaN where the equation is not used. `position`: the entry of q of the equation's joint. Turns count from
// 8 periods on, as fewer may be errors of masses. `bands`: of the filter by log, Hz; only what is slower is looked for.
std::optional<ResidualLine> residual_line(const Observations& observations, const Eigen::VectorXd& residual,
                                          Eigen::Index position, bool slides, const std::vector<double>& bands);

// Ripple that is faster than the filter's band: a sine of the joint's position in what the filter takes from its
// torques, `share` of the squares of that; nullopt if there is none, or chance explains it. Up to 1,500 periods in a
// turn are looked for. `sampled`: samples a second by log.
std::optional<ResidualLine> fast_ripple(const Observations& observations, Eigen::Index equation, Eigen::Index position,
                                        bool slides, const std::vector<double>& bands,
                                        const std::vector<double>& sampled);

// Friction of an equation's joint in the second half of each log, less that in the first half.
struct FrictionChange {
  double viscous = 0, coulomb = 0;
  double share = 0;  // of the joint's torque of friction, with its sign: rms
};

// nullopt if chance explains the change, if it is less than a twentieth or more than all of the friction, if it is not
// like the friction, or if the friction is less than `least`, N m or N (rms). `rate`: the entry of q̇ of the joint.
// `viscous` and `coulomb`: the estimates for the whole logs. `correlation`: NoiseShape::correlation().
std::optional<FrictionChange> friction_change(const Observations& observations, const Eigen::VectorXd& residual,
                                              Eigen::Index rate, double viscous, double coulomb, double least,
                                              double correlation);

}  // namespace flatdyn
