// SPDX-License-Identifier: GPL-2.0-or-later
// References written once for all scalars, as generic functions of a robot at a state.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn {

// A robot and a state in the reference's types.
template <class S>
struct ReferencePoint {
  ReferencePoint(const reference::Robot<S>& robot_in, const Function& function, const StateOf<S>& state)
      : robot(robot_in),
        task(function.task),
        q(vector_of<S>(state.q)),
        qd(vector_of<S>(state.qd)),
        qdd(vector_of<S>(state.qdd)),
        tau(vector_of<S>(state.tau)),
        step(state.h.at(0)),
        qd_end(vector_of<S>(state.qd_end)),
        given_q(q) {
    const reference::VectorX<S> h = vector_of<S>(state.h_e);
    h_e.f_e = h.template head<3>();
    h_e.mu_e = h.template tail<3>();
  }
  // The same with another robot, which must outlive this object.
  ReferencePoint(const reference::Robot<S>& robot_in, const ReferencePoint& at)
      : robot(robot_in),
        task(at.task),
        q(at.q),
        qd(at.qd),
        qdd(at.qdd),
        tau(at.tau),
        h_e(at.h_e),
        step(at.step),
        qd_end(at.qd_end),
        given_q(at.given_q) {}
  ReferencePoint(const ReferencePoint&) = default;

  const reference::Robot<S>& robot;
  const Task& task;
  reference::VectorX<S> q, qd, qdd, tau;
  reference::Environment<S> h_e;
  S step;                         // the length of a step, s,
  reference::VectorX<S> qd_end;   // and rates at its end
  reference::VectorX<S> given_q;  // q with the quaternions of spherical joints
};

// Whether the gravity that acts on a robot is that of the state, in axes of its floating base.
template <class S>
bool has_base_gravity(const reference::Robot<S>& robot) {
  return robot.floating_base && !robot.gravity.isZero(S(0));
}

template <class S>
reference::Robot<S> with_base_gravity(reference::Robot<S> robot, const StateOf<S>& state);

// The state whose q lacks the orientations of spherical joints, which become the robot's.
template <class S>
StateOf<S> without_quaternions(reference::Robot<S>& robot, StateOf<S> state);

// The entries of a function's outputs at a point.
template <class S>
using EntriesAt = std::vector<S> (*)(const ReferencePoint<S>&);

// The reference of a function for one robot: `entries` of the point at each state.
template <class S>
ReferenceFunction<S> reference_of(EntriesAt<S> entries, const ReferenceModel<S>& model, const Function& function);

// Functions over S; `extern` declares that they are instantiated elsewhere, empty instantiates them.
#define FLATDYN_REFERENCE_POINTS_OVER(S, EXTERN)                                                 \
  EXTERN template reference::Robot<S> with_base_gravity(reference::Robot<S>, const StateOf<S>&); \
  EXTERN template StateOf<S> without_quaternions(reference::Robot<S>&, StateOf<S>);              \
  EXTERN template ReferenceFunction<S> reference_of(EntriesAt<S>, const ReferenceModel<S>&, const Function&);

FLATDYN_REFERENCE_POINTS_OVER(double, extern)
FLATDYN_REFERENCE_POINTS_OVER(Real50, extern)

// `Generic`: the type of a function object without state that takes a ReferencePoint<S> and returns the entries.
template <class Generic, class S>
ReferenceFunction<S> prepared(const ReferenceModel<S>& model, const Function& function) {
  return reference_of<S>([](const ReferencePoint<S>& at) -> std::vector<S> { return Generic{}(at); }, model, function);
}

// `value`: as above. `magnitude`: the same for double.
template <class Value, class Magnitude>
constexpr NumericReference computed_by(Value, Magnitude, bool needs_many_recursions = false) {
  return {prepared<Value, double>, prepared<Value, Real50>, prepared<Magnitude, double>, needs_many_recursions};
}

// The entries of several matrices.
template <class S>
std::vector<S> one_after_the_other(const std::vector<reference::MatrixX<S>>& matrices) {
  std::vector<S> entries;
  for (const reference::MatrixX<S>& m : matrices) {
    const std::vector<S> more = row_by_row(m);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  return entries;
}

}  // namespace flatdyn
