// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/kinematics_references.hpp"

#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn::references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

template <class S>
std::vector<S> pose_entries(const ReferencePoint<S>& at) {
  const ref::Pose<S> pose = ref::tip_pose(at.robot, at.q);
  std::vector<S> entries = row_by_row(pose.R);
  entries.insert(entries.end(), pose.p.data(), pose.p.data() + 3);
  return entries;
}

template <class S>
std::vector<S> poses_of_links(const ReferencePoint<S>& at) {
  std::vector<S> rotations, positions;
  for (const ref::Pose<S>& pose : ref::link_poses(at.robot, at.q)) {
    const std::vector<S> rows = row_by_row(pose.R);
    rotations.insert(rotations.end(), rows.begin(), rows.end());
    positions.insert(positions.end(), pose.p.data(), pose.p.data() + 3);
  }
  rotations.insert(rotations.end(), positions.begin(), positions.end());
  return rotations;
}

std::vector<double> magnitude_of_poses(const At& at) {
  ref::Robot<double> robot = at.robot;
  robot.R_tip.setIdentity();
  robot.p_tip.setZero();
  std::vector<double> entries(9 * robot.links.size(), 1.0);
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    robot.tip = static_cast<int>(l);
    entries.insert(entries.end(), 3, ref::reach(robot, at.q));
  }
  return entries;
}

// Entries of rotations have magnitude 1; positions and moment arms have that of the path to the tip.
std::vector<double> pose_magnitude(const At& at) {
  std::vector<double> entries(9, 1.0);
  entries.insert(entries.end(), 3, ref::reach(at.robot, at.q));
  return entries;
}

std::vector<double> tip_acceleration(const At& at) {
  const Eigen::Vector2d m = ref::tip_acceleration_magnitude(at.robot, at.q, at.qd);
  return {m[0], m[0], m[0], m[1], m[1], m[1]};
}

std::vector<double> frame_acceleration_magnitude(const At& at) {
  const std::vector<double> carried = tip_acceleration(at);
  std::vector<double> entries =
      row_by_row(ref::VectorX<double>(ref::jacobian_magnitude(at.robot, at.q) * at.qdd.cwiseAbs()));
  for (std::size_t k = 0; k < entries.size(); ++k) entries[k] += carried[k];
  return entries;
}

template <class S>
ref::VectorX<S> wrench(const ReferencePoint<S>& at) {
  ref::VectorX<S> h(6);
  h << at.h_e.f_e, at.h_e.mu_e;
  return h;
}

template <class S>
std::vector<S> torques_of_wrench(const ReferencePoint<S>& at) {
  return row_by_row(ref::VectorX<S>(ref::jacobian(at.robot, at.q).transpose() * wrench(at)));
}

std::vector<double> wrench_magnitude(const At& at) {
  const ref::VectorX<double> h = wrench(at).cwiseAbs();
  return row_by_row(ref::VectorX<double>(ref::jacobian_magnitude(at.robot, at.q).transpose() * h));
}

}  // namespace

constinit const NumericReference forward_kinematics =
    computed_by([](const auto& at) { return pose_entries(at); }, [](const At& at) { return pose_magnitude(at); });

constinit const NumericReference link_poses =
    computed_by([](const auto& at) { return poses_of_links(at); }, [](const At& at) { return magnitude_of_poses(at); });

constinit const NumericReference jacobian =
    computed_by([](const auto& at) { return row_by_row(ref::jacobian(at.robot, at.q)); },
                [](const At& at) { return row_by_row(ref::jacobian_magnitude(at.robot, at.q)); });

constinit const NumericReference jacobian_dot_qd =
    computed_by([](const auto& at) { return row_by_row(ref::jacobian_dot_qd(at.robot, at.q, at.qd)); },
                [](const At& at) { return tip_acceleration(at); });

constinit const NumericReference frame_velocity =
    computed_by([](const auto& at) { return row_by_row((ref::jacobian(at.robot, at.q) * at.qd).eval()); },
                [](const At& at) {
                  return row_by_row(ref::VectorX<double>(ref::jacobian_magnitude(at.robot, at.q) * at.qd.cwiseAbs()));
                });

constinit const NumericReference frame_acceleration = computed_by(
    [](const auto& at) {
      return row_by_row((ref::jacobian(at.robot, at.q) * at.qdd + ref::jacobian_dot_qd(at.robot, at.q, at.qd)).eval());
    },
    [](const At& at) { return frame_acceleration_magnitude(at); });

constinit const NumericReference external_torque = computed_by([](const auto& at) { return torques_of_wrench(at); },
                                                               [](const At& at) { return wrench_magnitude(at); });

}  // namespace flatdyn::references
