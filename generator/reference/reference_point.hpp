// SPDX-License-Identifier: GPL-2.0-or-later
// References written once for all scalars, as generic functions of a robot at a state.
#pragma once

#include "reference/numeric_reference.hpp"

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
        tau(vector_of<S>(state.tau)) {
    const reference::VectorX<S> h = vector_of<S>(state.h_e);
    h_e.f_e = h.template head<3>();
    h_e.mu_e = h.template tail<3>();
  }

  const reference::Robot<S>& robot;
  const Task& task;
  reference::VectorX<S> q, qd, qdd, tau;
  reference::Environment<S> h_e;
};

// Whether the gravity that acts on a robot is that of the state, in axes of its floating base.
template <class S>
bool has_base_gravity(const reference::Robot<S>& robot) {
  return robot.floating_base && !robot.gravity.isZero(S(0));
}

template <class S>
reference::Robot<S> with_base_gravity(reference::Robot<S> robot, const StateOf<S>& state) {
  robot.gravity = vector_of<S>(state.g_b);
  return robot;
}

// The state whose q lacks the orientations of spherical joints, which become the robot's.
template <class S>
StateOf<S> without_quaternions(reference::Robot<S>& robot, StateOf<S> state) {
  reference::VectorX<S> q = vector_of(state.q);
  reference::take_orientations(robot, q);
  state.q.assign(q.data(), q.data() + q.size());
  return state;
}

// `Generic`: the type of a function object without state that takes a ReferencePoint<S> and returns the entries.
template <class Generic, class S>
ReferenceFunction<S> prepared(const ReferenceModel<S>& model, const Function& function) {
  return [robot = model.robot, &function](const StateOf<S>& state) -> std::vector<S> {
    if (reference::has_spherical_joints(robot)) {
      reference::Robot<S> turned = has_base_gravity(robot) ? with_base_gravity(robot, state) : robot;
      const StateOf<S> rest = without_quaternions(turned, state);
      return Generic{}(ReferencePoint<S>(turned, function, rest));
    }
    if (!has_base_gravity(robot)) return Generic{}(ReferencePoint<S>(robot, function, state));
    return Generic{}(ReferencePoint<S>(with_base_gravity(robot, state), function, state));
  };
}

// `value`: as above. `magnitude`: the same for double.
template <class Value, class Magnitude>
constexpr NumericReference computed_by(Value, Magnitude, bool needs_many_recursions = false) {
  return {prepared<Value, float>, prepared<Value, double>, prepared<Value, Real50>, prepared<Magnitude, double>,
          needs_many_recursions};
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
