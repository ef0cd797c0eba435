// SPDX-License-Identifier: GPL-2.0-or-later
// The torque deviation of an abbreviated model at random states, and the proof that its functions are those of its own
// Lagrangian.
#pragma once

#include <string>
#include <vector>

#include "functions/exact_proof.hpp"
#include "functions/scene/abbreviate.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// The largest change of each joint's torque, N m or N, at random states within the limits; every other state is at the
// limits of velocity and acceleration.
struct TorqueDeviation {
  int states = 0;
  std::vector<double> largest;  // by joint

  bool is_within(const Abbreviation& abbreviation) const;
};

// `at_rest`: only states with q̇ = 0.
TorqueDeviation torque_deviation(const Mechanism& whole, const Mechanism& part, bool at_rest, int states = 2000);

struct AbbreviationReport {
  struct Entry {
    std::string function;
    ExactResult result;
  };
  std::vector<Entry> exactly;  // against the Lagrangian of the abbreviated model
  TorqueDeviation seen;
  bool passed = false;
};

// Verifies an abbreviated model. The reference knows only the whole model, so torques are the only numbers compared.
AbbreviationReport verify_abbreviated(const Mechanism& whole, const Abbreviation& abbreviation,
                                      const std::vector<Function>& functions, bool at_rest);

}  // namespace flatdyn
