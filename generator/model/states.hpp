// SPDX-License-Identifier: GPL-2.0-or-later
// States of motion at which functions are compared.
#pragma once

#include <random>
#include <span>
#include <utility>
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
  std::vector<S> qd_r, qdd_r;                    // reference rates and accelerations
  std::vector<S> pi_b;                           // base parameters

  const std::vector<S>& of(InputKind kind) const {
    const std::vector<S>* const members[] = {&q,          &qd,   &qdd,   &tau, &h_e,
                                             &parameters, &qd_r, &qdd_r, &pi_b};  // in the order of InputKind
    return *members[static_cast<std::size_t>(kind)];
  }
  std::vector<S>& of(InputKind kind) { return const_cast<std::vector<S>&>(std::as_const(*this).of(kind)); }
};

// All kinds of numbers in a state; those that a motion may have, without the robot's free symbols.
inline constexpr InputKind kStateKinds[] = {InputKind::q,     InputKind::qd,   InputKind::qdd,
                                            InputKind::tau,   InputKind::h_e,  InputKind::qd_r,
                                            InputKind::qdd_r, InputKind::pi_b, InputKind::parameter};
inline constexpr std::span kMotionKinds = std::span(kStateKinds).first<std::size(kStateKinds) - 1>();

// Doubles: what the compiled code gets is exactly what the reference gets.
using State = StateOf<double>;

// The same state in another type: exactly, if that is wider.
template <class S>
StateOf<S> widened(const State& state) {
  const auto wide = [](const std::vector<double>& v) { return std::vector<S>(v.begin(), v.end()); };
  return {wide(state.q),          wide(state.qd),   wide(state.qdd),   wide(state.tau), wide(state.h_e),
          wide(state.parameters), wide(state.qd_r), wide(state.qdd_r), wide(state.pi_b)};
}

// The state that a function in float is given: every number rounded.
State in_float(State state);

// Uniform within the limits; where there are none: a turn, 1 m, 5 rad/s, 1 m/s, 20 rad/s^2, 10 m/s^2. The same on every
// machine for the same seed. Base parameters are none.
std::vector<State> random_states(const Mechanism& mechanism, int count, unsigned seed);

// The same for many draws: the mechanism's exact numbers are read once, and draws may go on at the same time.
class StateSource {
 public:
  explicit StateSource(const Mechanism& mechanism);
  std::vector<State> draw(int count, unsigned seed) const;

 private:
  struct Joint {
    int position;  // entry of q
    double velocity, acceleration, effort;
  };
  std::vector<std::pair<double, double>> positions_;  // by entry of q: from, to
  std::vector<Joint> joints_;                         // by entry of q̇
  std::vector<int> dependent_;                        // entries of q
};

// Which children searches have: each coordinate is changed with a probability of 2^-a, a drawn from 0 to `rarest`, by
// 2^-b of the way to another state's, b drawn from `coarsest` to `finest`.
struct Mutation {
  unsigned rarest = 5, coarsest = 0, finest = 44;  // down to the last places
};

// A child of `parent` for searches in which errors have no slope to follow: some of its coordinates, few or many, are a
// part of the way to the other's. So it stays within limits that both keep.
State child(const State& parent, const State& other, std::mt19937_64& random, const Mutation& mutation = {});

// As many base parameters, between -1 and 1, in each of the states.
void draw_base_parameters(std::vector<State>& states, int count, unsigned seed);

// The same states, with the values of the robot's free symbols.
std::vector<State> with_parameters(std::vector<State> states, const std::vector<Number>& values);

// Joint positions at 0, ±pi/2, ±pi and a thousand turns, speeds zero and large, accelerations zero.
std::vector<State> edge_states(const Mechanism& mechanism);

}  // namespace flatdyn
