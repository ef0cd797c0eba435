// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/reference_point.hpp"

namespace flatdyn {
namespace {

// q with quaternions that are unit ones to the last place.
template <class S>
reference::VectorX<S> with_unit_quaternions(const reference::Robot<S>& robot, reference::VectorX<S> q) {
  Eigen::Index entry = 0;
  for (const reference::Joint<S>& joint : robot.joints) {
    if (joint.index < 0) continue;
    const bool is_spherical = joint.type == reference::JointType::spherical;
    if (is_spherical) q.template segment<4>(entry).normalize();
    entry += is_spherical ? 4 : 1;
  }
  return q;
}

}  // namespace

template <class S>
reference::Robot<S> with_base_gravity(reference::Robot<S> robot, const StateOf<S>& state) {
  robot.gravity = vector_of<S>(state.g_b);
  return robot;
}

template <class S>
StateOf<S> without_quaternions(reference::Robot<S>& robot, StateOf<S> state) {
  reference::VectorX<S> q = vector_of(state.q);
  reference::take_orientations(robot, q);
  state.q.assign(q.data(), q.data() + q.size());
  return state;
}

template <class S>
ReferenceFunction<S> reference_of(EntriesAt<S> entries, const ReferenceModel<S>& model, const Function& function) {
  return [entries, robot = model.robot, &function](const StateOf<S>& state) {
    if (reference::has_spherical_joints(robot)) {
      reference::Robot<S> turned = has_base_gravity(robot) ? with_base_gravity(robot, state) : robot;
      const StateOf<S> rest = without_quaternions(turned, state);
      ReferencePoint<S> point(turned, function, rest);
      point.given_q = with_unit_quaternions(robot, vector_of<S>(state.q));
      return entries(point);
    }
    if (!has_base_gravity(robot)) return entries(ReferencePoint<S>(robot, function, state));
    return entries(ReferencePoint<S>(with_base_gravity(robot, state), function, state));
  };
}

FLATDYN_REFERENCE_POINTS_OVER(double, )
FLATDYN_REFERENCE_POINTS_OVER(Real50, )

}  // namespace flatdyn
