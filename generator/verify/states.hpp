// SPDX-License-Identifier: GPL-2.0-or-later
// States of motion at which functions are compared.
#pragma once

#include <vector>

#include "graph/graph.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// All that any function may be given. Doubles: what the compiled code gets is exactly what the reference gets.
struct State {
  std::vector<double> q, qd, qdd, tau;
  std::vector<double> h_e = std::vector<double>(6, 0.0);  // tip force and moment
  std::vector<double> parameters;                         // values of the free symbols

  const std::vector<double>& of(InputKind kind) const;
};

// Uniform within the limits; where there are none: a turn, 1 m, 5 rad/s, 1 m/s, 20 rad/s^2, 10 m/s^2. The same on every
// machine for the same seed.
std::vector<State> random_states(const Mechanism& mechanism, int count, unsigned seed);

// Joint positions at 0, ±pi/2, ±pi and a thousand turns, speeds zero and large, accelerations zero.
std::vector<State> edge_states(const Mechanism& mechanism);

}  // namespace flatdyn
