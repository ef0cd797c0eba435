// SPDX-License-Identifier: GPL-2.0-or-later
// An abbreviated model: inertial parameters whose contribution to the torques is too small to matter are left out, with
// a proven bound of the change. (After Armstrong, Khatib and Burdick, "The explicit dynamic model and inertial
// parameters of the PUMA 560 arm", 1986, who abbreviated by hand.)
//
// Torques are linear in the parameters (7.81), so leaving some out changes a torque by no more than the sum of their
// largest contributions. These follow from norms, which rotations keep. Let W, D, A be the largest |ω|, |ω̇| and |p̈ -
// g_0| of a body within the limits of velocity and acceleration. Then a unit of
//     mass                       needs a force up to A;
//     a first moment             needs a force up to D + W² and a moment up to A;
//     a moment of inertia        needs a moment up to D + W²/2, a product of inertia up to D + W².
// The moment arm of a force at joint i is at most the distance between the two origins. A floating base counts as six
// joints, with the force and the moment on it; a spherical joint as three, each with a component of its moment, whose
// rates are those of one vector.
#pragma once

#include <string>
#include <vector>

#include "robot/model/mechanism.hpp"
#include "robot/model/scene.hpp"

namespace flatdyn {

struct DroppedParameter {
  int body = 0;
  std::string name;           // "I3xy": a base parameter, named after the one that represents its group
  double value = 0;           // SI
  std::vector<double> bound;  // by joint: the largest change of its torque, N m or N
};

struct Abbreviation {
  Mechanism mechanism;
  std::vector<DroppedParameter> dropped;  // in the order in which they were dropped
  std::vector<double> budget, bound;      // by joint, N m or N; bound <= budget
};

std::vector<std::string> names_of_dropped(const Abbreviation& abbreviation);

// The torques that are needed: only those for q̇ = 0, or only gravity torques, which moments of inertia do not affect.
struct TorqueScope {
  bool at_rest = false, only_gravity = false;
};

// The mechanism without the parameters that fit into the budget; those that save the most per fraction of it are
// dropped first. Parameters that B needs to stay positive definite are kept: B is tested at 200 random positions, as
// bounds of torques do not ensure it. Throws Failure(unsupported) if limits are missing, the robot has free symbols, or
// joints are coupled.
Abbreviation abbreviated(const Mechanism& mechanism, const ErrorBudget& budget, const TorqueScope& scope = {});

}  // namespace flatdyn
