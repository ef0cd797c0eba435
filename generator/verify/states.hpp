// SPDX-License-Identifier: GPL-2.0-or-later
// States of motion at which functions are compared.
#pragma once

#include <vector>

#include "graph/graph.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// All that any function may be given.
template <class S>
struct StateOf {
  std::vector<S> q, qd, qdd, tau;
  std::vector<S> h_e = std::vector<S>(6, S(0));  // tip force and moment
  std::vector<S> parameters;                     // values of the free symbols

  const std::vector<S>& of(InputKind kind) const {
    const std::vector<S>* const members[] = {&q, &qd, &qdd, &tau, &h_e, &parameters};  // in the order of InputKind
    return *members[static_cast<std::size_t>(kind)];
  }
};

// Doubles: what the compiled code gets is exactly what the reference gets.
using State = StateOf<double>;

// The same state, exactly, in a wider type.
template <class S>
StateOf<S> widened(const State& state) {
  const auto wide = [](const std::vector<double>& v) { return std::vector<S>(v.begin(), v.end()); };
  return {wide(state.q), wide(state.qd), wide(state.qdd), wide(state.tau), wide(state.h_e), wide(state.parameters)};
}

// Uniform within the limits; where there are none: a turn, 1 m, 5 rad/s, 1 m/s, 20 rad/s^2, 10 m/s^2. The same on every
// machine for the same seed.
std::vector<State> random_states(const Mechanism& mechanism, int count, unsigned seed);

// Joint positions at 0, ±pi/2, ±pi and a thousand turns, speeds zero and large, accelerations zero.
std::vector<State> edge_states(const Mechanism& mechanism);

}  // namespace flatdyn
