// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/kinematics_functions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "derivation/dynamics/kinematics.hpp"

namespace flatdyn {

Function derive_forward_kinematics(const Mechanism& mechanism, const LinkFrame& link) {
  DerivationContext context(mechanism);
  const SymbolicPose result = pose(context.frames, link);
  std::vector<NodeId> R, p;
  for (const Vec3& row : result.R) {
    for (const Number& entry : row) R.push_back(context.node(entry));
  }
  for (const Number& entry : result.p) p.push_back(context.node(entry));
  return finished(context, {matrix_output("R", 3, 3, R, "rotation matrix of the frame in the base frame"),
                            vector_output("p", p, "position of the frame's origin in the base frame, m")});
}

Function derive_link_poses(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  std::vector<NodeId> R, p;
  for (const SymbolicPose& pose : link_poses(context.frames)) {
    for (const Vec3& row : pose.R) {
      for (const Number& entry : row) R.push_back(context.node(entry));
    }
    for (const Number& entry : pose.p) p.push_back(context.node(entry));
  }
  std::vector<std::string> names;
  for (const LinkFrame& link : mechanism.links) names.push_back(link.link);
  const std::string order = fmt::format("{}", fmt::join(names, ", "));
  const int rows = static_cast<int>(p.size());
  return finished(
      context,
      {matrix_output("R", rows, 3, R,
                     "rotation matrices of the links' frames in the base frame, three rows each: " + order),
       vector_output("p", p, "positions of their origins in the base frame, m, three entries each, in this order")});
}

Function derive_jacobian(const Mechanism& mechanism, const LinkFrame& link) {
  DerivationContext context(mechanism);
  const std::vector<JacobianColumn> columns =
      at_coordinates(mechanism, context.derivation, jacobian(context.frames, link));
  std::vector<NodeId> entries;
  for (std::size_t row = 0; row < 6; ++row) {
    for (const JacobianColumn& column : columns) {
      entries.push_back(context.node(row < 3 ? column.linear[row] : column.angular[row - 3]));
    }
  }
  return finished(context, {matrix_output("J", 6, mechanism.size(), entries,
                                          "geometric Jacobian in base axes: linear rows, then angular")});
}

namespace {

Function of_both_parts(DerivationContext& context, const char* name, const JacobianColumn& value,
                       const std::string& meaning) {
  std::vector<Number> entries(value.linear.begin(), value.linear.end());
  entries.insert(entries.end(), value.angular.begin(), value.angular.end());
  return finished(context, {vector_output(name, context.nodes(entries), meaning)});
}

}  // namespace

Function derive_jacobian_dot_qd(const Mechanism& mechanism, const LinkFrame& link) {
  DerivationContext context(mechanism);
  return of_both_parts(context, "a", jacobian_dot_qd(context.frames, link),
                       "(dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2");
}

Function derive_frame_velocity(const Mechanism& mechanism, const LinkFrame& link) {
  DerivationContext context(mechanism);
  return of_both_parts(context, "v_e", frame_velocity(context.frames, link),
                       "of the frame, in base axes: linear m/s, then angular rad/s");
}

Function derive_frame_acceleration(const Mechanism& mechanism, const LinkFrame& link) {
  DerivationContext context(mechanism);
  return of_both_parts(context, "a_e", frame_acceleration(context.frames, link),
                       "of the frame, in base axes: linear m/s^2, then angular rad/s^2");
}

}  // namespace flatdyn
