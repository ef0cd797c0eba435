// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/kinematics_definitions.hpp"

#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {
namespace {

template <class F>
std::vector<F> position(const Pose3<F>& pose) {
  return {pose.p.begin(), pose.p.end()};
}

template <class F>
std::vector<F> rotation(const Pose3<F>& pose) {
  std::vector<F> result;
  for (const Vector3<F>& row : pose.R) result.insert(result.end(), row.begin(), row.end());
  return result;
}

}  // namespace

constinit const Definition forward_kinematics = defined_as([](auto& at, const Output& output) {
  const auto pose = at.lagrangian.pose(at.frame());
  return output.name == "p" ? position(pose) : rotation(pose);
});

constinit const Definition link_poses = defined_as([](auto& at, const Output& output) {
  decltype(position(at.lagrangian.pose(at.frame()))) entries;
  for (const auto& frame : at.lagrangian.mechanism().links) {
    const auto pose = at.lagrangian.pose(frame);
    const auto more = output.name == "p" ? position(pose) : rotation(pose);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  return entries;
});

constinit const Definition jacobian =
    defined_as([](auto& at, const Output&) { return at.lagrangian.jacobian(at.frame()).entries(); });

constinit const Definition jacobian_dot_qd =
    defined_as([](auto& at, const Output&) { return at.jacobian_dot_qd(at.frame()); });

constinit const Definition frame_velocity =
    defined_as([](auto& at, const Output&) { return times(at.lagrangian.jacobian(at.frame()), at.qd()); });

constinit const Definition frame_acceleration = defined_as([](auto& at, const Output&) {
  auto result = times(at.lagrangian.jacobian(at.frame()), at.qdd());
  const auto more = at.jacobian_dot_qd(at.frame());
  for (std::size_t k = 0; k < result.size(); ++k) result[k] += more[k];
  return result;
});

constinit const Definition external_torque = defined_as(
    [](auto& at, const Output&) { return at.lagrangian.torques_at(at.frame(), at.drawn(InputKind::h_e, 6)); });

}  // namespace flatdyn::definitions
