// SPDX-License-Identifier: GPL-2.0-or-later
// An abbreviated model: inertial parameters whose part in the torques is too small to matter are left out, with a
// proven bound of what that changes. (After Armstrong, Khatib and Burdick, "The explicit dynamic model and inertial
// parameters of the PUMA 560 arm", 1986, who abbreviated by hand.)
//
// Torques are linear in the parameters (7.81), so leaving some out changes a torque by no more than the sum of the
// largest parts that each of them can have. These follow from norms, which rotations keep: with W, D, A the largest
// |ω|, |ω̇| and |p̈ - g_0| of a body within the limits of velocity and acceleration, a unit of
//     mass                       pulls with A;
//     a first moment             pulls with D + W² and turns with A;
//     a moment of inertia        turns with D + W²/2, a product of inertia with D + W²;
// a pull acts on joint i with the distance between the two origins at most.
#pragma once

#include <string>
#include <vector>

#include "model/mechanism.hpp"
#include "model/scene.hpp"

namespace flatdyn {

struct DroppedParameter {
  int body = 0;
  std::string name;           // "I3xy": a base parameter, named after the one that stands for its group
  double value = 0;           // SI
  std::vector<double> bound;  // by joint: the largest change of its torque, N m or N
};

struct Abbreviation {
  Mechanism mechanism;
  std::vector<DroppedParameter> dropped;  // in the order in which they were given up
  std::vector<double> budget, bound;      // by joint, N m or N; bound <= budget
};

// What of the torques is asked for: with q̇ = 0; or only what depends on q alone, gravity, where moments of inertia have
// no part.
struct Needs {
  bool at_rest = false, only_gravity = false;
};

// The mechanism without what fits into the budget, the largest saving for its part of the budget first. What B needs to
// stay positive definite stays: tried at 200 random positions, as bounds of torques say nothing of it. Throws
// Failure(unsupported) where limits are missing, or numbers are not known.
Abbreviation abbreviated(const Mechanism& mechanism, const ErrorBudget& budget, const Needs& needs = {});

}  // namespace flatdyn
