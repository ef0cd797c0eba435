// SPDX-License-Identifier: GPL-2.0-or-later
// States of motion at which functions are compared.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The values of all inputs that a function may have, by kind.
template <class S>
struct StateOf {
  std::vector<S> q, qd, qdd, tau;
  std::vector<S> h_e = std::vector<S>(6, S(0));  // tip force, N, and moment, N m
  std::vector<S> parameters;                     // values of the free symbols
  std::vector<S> qd_r, qdd_r;                    // reference rates and accelerations
  std::vector<S> pi_b;                           // base parameters
  std::vector<S> g_b;                            // gravity in the axes of a floating base, m/s^2
  std::vector<S> weights, direction;             // of products with derivatives
  std::vector<S> h = {S(1) / S(128)};            // the length of a step, s,
  std::vector<S> qd_end;                         // and rates at its end

  const std::vector<S>& of(InputKind kind) const {
    // In the order of InputKind. The numbers of v, a, v_r and a_r are those of q̇, q̈, q̇_r and q̈_r.
    const std::vector<S>* const members[] = {&q,       &qd,        &qdd, &tau,    &h_e,   &parameters, &qd_r,
                                             &qdd_r,   &pi_b,      &g_b, &qd,     &qdd,   &qd_r,       &qdd_r,
                                             &weights, &direction, &h,   &qd_end, &qd_end};
    return *members[static_cast<std::size_t>(argument_row(kind).in_state)];
  }
  std::vector<S>& of(InputKind kind) { return const_cast<std::vector<S>&>(std::as_const(*this).of(kind)); }
};

// The kinds of arguments that are meant, in the order of their table; the free symbols' values are last.
template <class IsMeant>
constexpr auto argument_kinds(IsMeant) {
  constexpr auto is_listed = [](const ArgumentRow& row) {
    return row.kind != InputKind::parameter && row.kind != InputKind::stored && IsMeant()(row);
  };
  constexpr auto count = std::count_if(kArgumentRows.begin(), kArgumentRows.end(), is_listed);
  std::array<InputKind, static_cast<std::size_t>(count) + 1> kinds{};
  std::size_t place = 0;
  for (const ArgumentRow& row : kArgumentRows) {
    if (is_listed(row)) kinds[place++] = row.kind;
  }
  kinds[place] = InputKind::parameter;
  return kinds;
}

// All kinds of arguments, and those of the numbers in a state.
inline constexpr auto kArgumentKinds = argument_kinds([](const ArgumentRow&) { return true; });
inline constexpr auto kStateKinds = argument_kinds([](const ArgumentRow& row) { return row.in_state == row.kind; });
inline constexpr std::span kMotionKinds = std::span(kStateKinds).first<kStateKinds.size() - 1>();

// A state in doubles: the compiled code gets exactly the same numbers as the reference.
using State = StateOf<double>;

// The same state in another type; exactly the same if that type is wider.
template <class S>
StateOf<S> widened(const State& state) {
  const auto wide = [](const std::vector<double>& v) { return std::vector<S>(v.begin(), v.end()); };
  return {wide(state.q),          wide(state.qd),        wide(state.qdd),   wide(state.tau),   wide(state.h_e),
          wide(state.parameters), wide(state.qd_r),      wide(state.qdd_r), wide(state.pi_b),  wide(state.g_b),
          wide(state.weights),    wide(state.direction), wide(state.h),     wide(state.qd_end)};
}

// The same state with quaternions, from these entries of q on, that are unit ones to the last place of the type.
template <class S>
StateOf<S> with_unit_quaternions(const std::vector<int>& quaternions, StateOf<S> state) {
  using std::sqrt;
  for (const int position : quaternions) {
    const auto first = state.q.begin() + position;
    S square(0);
    for (auto entry = first; entry != first + 4; ++entry) square += *entry * *entry;
    const S length = sqrt(square);
    for (auto entry = first; entry != first + 4; ++entry) *entry /= length;
  }
  return state;
}

// Those of spherical joints.
template <class S>
StateOf<S> with_unit_quaternions(const Mechanism& mechanism, StateOf<S> state) {
  return with_unit_quaternions(mechanism.quaternions(), std::move(state));
}

// The state that a function in float is given: every number is rounded.
State in_float(State state);

// The motion of a joint within its limits: rad or m, and N m or N. Where the robot has no limit, or one of zero, which
// nobody filled in, these are assumed: ±π or ±1 m, 5 rad/s or 1 m/s, 20 rad/s² or 10 m/s², 100 N m or N.
struct MotionRange {
  double lower, upper;
  double speed, acceleration, effort;  // absolute values
};
MotionRange motion_range(const Body& body);

// The absolute value of the limit of entry k of q̇, q̈ or τ: of a joint, or of the components of a floating base's
// motion, in SI units. Throws Failure(unsupported) if nobody gave it; a limit of 0 means that.
double required_limit(const Mechanism& mechanism, int k, std::optional<Value> Limits::*limit);
// The largest distance from 0 of a joint's position, rad or m. Throws as above.
double required_reach(const Body& body);

// Random states, uniform within the ranges of joints. They are the same on every machine for the same seed. They have
// no base parameters.
std::vector<State> random_states(const Mechanism& mechanism, int count, unsigned seed);

// Sets the orientations of all spherical joints to a turn by an angle, rad, about a direction between the axes.
void turn_spherical_joints(const Mechanism& mechanism, double angle, State& state);

// A source of many random states: the mechanism's exact numbers are read once, and several threads may draw at once.
class StateSource {
 public:
  explicit StateSource(const Mechanism& mechanism);
  std::vector<State> draw(int count, unsigned seed) const;

 private:
  struct Joint {
    int position;  // entry of q; negative: none, the motion of a floating base
    MotionRange range;
  };
  std::vector<std::pair<double, double>> positions_;  // lower and upper bound, by entry of q
  std::vector<Joint> joints_;                         // by entry of q̇
  std::vector<int> dependent_;                        // entries of q
  std::vector<int> quaternions_;                      // the first entries of q of spherical joints
  double gravity_ = 0;                                // |g_0|, with a floating base
};

// The random changes of a child in a search: each coordinate is changed with a probability of 2^-a, with a drawn from 0
// to `rarest`, by 2^-b of the difference to another state's, with b drawn from `coarsest` to `finest`.
struct StateMutation {
  unsigned rarest = 5, coarsest = 0, finest = 44;  // down to the last places
};

// A child of `parent` for searches over errors without a gradient: some of its coordinates, few or many, move a part of
// the way to those of `other`. So it stays within limits that both respect.
State child(const State& parent, const State& other, std::mt19937_64& random, const StateMutation& mutation = {});

// Draws what only some functions have, for all of them: base parameters, weights and a direction, between -1 and 1.
void draw_own_arguments(std::vector<State>& states, std::span<const Function> functions, unsigned seed);

// The same states with these values of the robot's free symbols.
std::vector<State> with_parameters(std::vector<State> states, const std::vector<Number>& values);

// States with joint positions at 0, ±pi/2, ±pi and a thousand turns, speeds zero and large, accelerations zero.
std::vector<State> edge_states(const Mechanism& mechanism);

}  // namespace flatdyn
