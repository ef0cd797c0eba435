// SPDX-License-Identifier: GPL-2.0-or-later
// Positions during a step, in the reference's types: derivation/dynamics/step_chart.hpp says the numbers of a change,
// one for each entry of q̇.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "truth/reference/reference_point.hpp"

namespace flatdyn::references {

template <class S>
using Quaternion = Eigen::Matrix<S, 4, 1>;  // (w, x, y, z)

template <class S>
Quaternion<S> product(const Quaternion<S>& a, const Quaternion<S>& b) {
  const reference::Vector3<S> r = a.template tail<3>(), s = b.template tail<3>();
  Quaternion<S> result;
  result << a[0] * b[0] - r.dot(s), a[0] * s + b[0] * r + r.cross(s);
  return result;
}

template <class S>
reference::Matrix3<S> rotation(const Quaternion<S>& E) {
  return reference::rotation_of_quaternion<S>(E[0], E.template tail<3>());
}

template <class S>
reference::Matrix3<S> cross_matrix(const reference::Vector3<S>& r) {
  reference::Matrix3<S> result;
  result << S(0), -r[2], r[1], r[2], S(0), -r[0], -r[1], r[0], S(0);
  return result;
}

// E(σ), and the matrices T of turns exp(S(T dσ)) by which E changes, and G of σ̇ = G ω.
template <class S>
Quaternion<S> turn_of(const reference::Vector3<S>& sigma) {
  const S square = sigma.squaredNorm();
  Quaternion<S> E;
  E << (S(1) - square), S(2) * sigma;
  return E / (S(1) + square);
}
template <class S>
reference::Matrix3<S> rates_of_parameters(const reference::Vector3<S>& sigma) {
  return ((S(1) - sigma.squaredNorm()) * reference::Matrix3<S>::Identity() + S(2) * cross_matrix<S>(sigma) +
          S(2) * sigma * sigma.transpose()) /
         S(4);
}
template <class S>
reference::Matrix3<S> turns_of_parameters(const reference::Vector3<S>& sigma) {
  const S length = S(1) + sigma.squaredNorm();
  return S(16) / (length * length) * rates_of_parameters<S>(sigma).transpose();
}

// The first entries in q̇ of the angular velocities of a floating base and of spherical joints.
template <class S>
std::vector<Eigen::Index> turning_entries(const reference::Robot<S>& robot) {
  std::vector<Eigen::Index> entries;
  if (robot.floating_base) entries.push_back(3);
  for (const reference::Joint<S>& joint : robot.joints) {
    if (joint.type == reference::JointType::spherical) entries.push_back(joint.index);
  }
  return entries;
}

// A change of positions.
template <class S>
struct Change {
  reference::VectorX<S> entries;  // of joints of one axis, and the base's displacement
  std::vector<Quaternion<S>> turns;
};

template <class S>
Change<S> change_in_chart(const reference::Robot<S>& robot, const reference::VectorX<S>& c) {
  Change<S> change{c, {}};
  for (const Eigen::Index k : turning_entries(robot)) {
    change.turns.push_back(turn_of<S>(c.template segment<3>(k)));
  }
  return change;
}

// For w = h (v, ω, ...), to the middle of the step, and to its end.
template <class S>
Change<S> change_to_the_middle(const reference::Robot<S>& robot, const reference::VectorX<S>& w) {
  return {w / S(2), change_in_chart<S>(robot, w / S(8)).turns};
}
template <class S>
Change<S> change_along(const reference::Robot<S>& robot, const reference::VectorX<S>& w) {
  Change<S> change{w, change_to_the_middle<S>(robot, w).turns};
  if (robot.floating_base) {
    change.entries.template head<3>() = rotation<S>(change.turns[0]) * w.template head<3>();
  }
  for (Quaternion<S>& E : change.turns) E = product<S>(E, E);
  return change;
}

// The rates of the numbers c of a chart.
template <class S>
reference::VectorX<S> rates_in_chart(const reference::Robot<S>& robot, const reference::VectorX<S>& c,
                                     reference::VectorX<S> v) {
  if (robot.floating_base) {
    v.template head<3>() =
        rotation<S>(turn_of<S>(c.template segment<3>(3))) * reference::Vector3<S>(v.template head<3>());
  }
  for (const Eigen::Index k : turning_entries(robot)) {
    const reference::Vector3<S> rates = rates_of_parameters<S>(c.template segment<3>(k)) * v.template segment<3>(k);
    v.template segment<3>(k) = rates;
  }
  return v;
}

// A point after a change of positions, with the robot as it is turned there.
template <class S>
struct PointAfter {
  PointAfter(const ReferencePoint<S>& from, const Change<S>& change)
      : robot(std::make_shared<reference::Robot<S>>(from.robot)), at(*robot, from) {
    std::size_t turn = 0;
    if (robot->floating_base) {
      robot->gravity = rotation<S>(change.turns[turn++]).transpose() * reference::Vector3<S>(robot->gravity);
    }
    at.q += change.entries.tail(at.q.size());
    for (reference::Joint<S>& joint : robot->joints) {
      if (joint.type != reference::JointType::spherical) continue;
      joint.orientation = reference::Matrix3<S>(joint.orientation) * rotation<S>(change.turns[turn++]);
      at.q.template segment<3>(joint.index - robot->base_size()).setZero();
    }
  }

  std::shared_ptr<reference::Robot<S>> robot;
  ReferencePoint<S> at;
};

// The entries of q after a change.
template <class S>
reference::VectorX<S> positions_after(const ReferencePoint<S>& from, const Change<S>& change) {
  const Eigen::Index base = from.robot.base_size();
  if (!reference::has_spherical_joints(from.robot)) return from.q + change.entries.tail(from.q.size());
  reference::VectorX<S> result = from.given_q;
  Eigen::Index entry = 0;
  std::size_t turn = base > 0 ? 1 : 0;
  for (const reference::Joint<S>& joint : from.robot.joints) {
    if (joint.index < 0) continue;
    if (joint.type == reference::JointType::spherical) {
      const Quaternion<S> before = from.given_q.template segment<4>(entry);
      result.template segment<4>(entry) = product<S>(before, change.turns[turn++]);
      entry += 4;
    } else {
      result[entry++] += change.entries[joint.index];
    }
  }
  return result;
}

// The outputs of a step: q', q̇', and of a floating base its displacement and turn.
template <class S>
std::vector<S> after_step(const ReferencePoint<S>& from, const Change<S>& change, const reference::VectorX<S>& qd) {
  std::vector<reference::MatrixX<S>> outputs = {positions_after<S>(from, change), qd};
  if (from.robot.floating_base) {
    outputs.emplace_back(change.entries.template head<3>());
    outputs.emplace_back(change.turns[0]);
  }
  return one_after_the_other<S>(outputs);
}

// How positions after a change depend on those before and on its numbers, in tangent spaces.
template <class S>
struct Tangents {
  reference::MatrixX<S> by_position, by_change;
};

template <class S>
Tangents<S> no_turns(Eigen::Index n, const S& by_change = S(1)) {
  const reference::MatrixX<S> one = reference::MatrixX<S>::Identity(n, n);
  return {one, by_change * one};
}

template <class S>
Tangents<S> tangents_in_chart(const reference::Robot<S>& robot, const reference::VectorX<S>& c) {
  Tangents<S> result = no_turns<S>(c.size());
  for (const Eigen::Index k : turning_entries(robot)) {
    const reference::Vector3<S> sigma = c.template segment<3>(k);
    result.by_position.template block<3, 3>(k, k) = rotation<S>(turn_of<S>(sigma)).transpose();
    result.by_change.template block<3, 3>(k, k) = turns_of_parameters<S>(sigma);
  }
  if (!robot.floating_base) return result;
  const reference::Matrix3<S> back = rotation<S>(turn_of<S>(c.template segment<3>(3))).transpose();
  result.by_position.template topLeftCorner<3, 3>() = back;
  result.by_change.template topLeftCorner<3, 3>() = back;
  result.by_position.template block<3, 3>(0, 3) = -back * cross_matrix<S>(c.template head<3>());
  return result;
}

template <class S>
Tangents<S> tangents_to_the_middle(const reference::Robot<S>& robot, const reference::VectorX<S>& w) {
  Tangents<S> result = no_turns<S>(w.size(), S(1) / S(2));
  for (const Eigen::Index k : turning_entries(robot)) {
    const reference::Vector3<S> sigma = w.template segment<3>(k) / S(8);
    result.by_position.template block<3, 3>(k, k) = rotation<S>(turn_of<S>(sigma)).transpose();
    result.by_change.template block<3, 3>(k, k) = turns_of_parameters<S>(sigma) / S(8);
  }
  return result;
}

template <class S>
Tangents<S> tangents_along(const reference::Robot<S>& robot, const reference::VectorX<S>& w) {
  Tangents<S> result = no_turns<S>(w.size());
  for (const Eigen::Index k : turning_entries(robot)) {
    const reference::Vector3<S> sigma = w.template segment<3>(k) / S(8);
    const reference::Matrix3<S> back = rotation<S>(turn_of<S>(sigma)).transpose(),
                                turn = turns_of_parameters<S>(sigma) / S(8);
    result.by_position.template block<3, 3>(k, k) = back * back;
    result.by_change.template block<3, 3>(k, k) = back * turn + turn;
    if (k != 3 || !robot.floating_base) continue;
    const reference::Vector3<S> along = w.template head<3>();
    result.by_position.template topLeftCorner<3, 3>() = back * back;
    result.by_change.template topLeftCorner<3, 3>() = back;
    result.by_position.template block<3, 3>(0, 3) = -back * back * cross_matrix<S>(back.transpose() * along);
    result.by_change.template block<3, 3>(0, 3) = -back * cross_matrix<S>(along) * turn;
  }
  return result;
}

// How rates in a chart depend on its numbers and on velocities.
template <class S>
struct RateTangents {
  reference::MatrixX<S> by_change, by_velocity;
};

template <class S>
RateTangents<S> tangents_of_rates(const reference::Robot<S>& robot, const reference::VectorX<S>& c,
                                  const reference::VectorX<S>& v) {
  RateTangents<S> result{reference::MatrixX<S>::Zero(c.size(), c.size()),
                         reference::MatrixX<S>::Identity(c.size(), c.size())};
  for (const Eigen::Index k : turning_entries(robot)) {
    const reference::Vector3<S> sigma = c.template segment<3>(k), omega = v.template segment<3>(k);
    result.by_change.template block<3, 3>(k, k) =
        (sigma * omega.transpose() - omega * sigma.transpose() - cross_matrix<S>(omega) +
         sigma.dot(omega) * reference::Matrix3<S>::Identity()) /
        S(2);
    result.by_velocity.template block<3, 3>(k, k) = rates_of_parameters<S>(sigma);
  }
  if (!robot.floating_base) return result;
  const reference::Vector3<S> sigma = c.template segment<3>(3);
  const reference::Matrix3<S> E = rotation<S>(turn_of<S>(sigma));
  result.by_change.template block<3, 3>(0, 3) =
      -E * cross_matrix<S>(v.template head<3>()) * turns_of_parameters<S>(sigma);
  result.by_velocity.template topLeftCorner<3, 3>() = E;
  return result;
}

// The sizes of the terms of tangents for sizes of changes and velocities: of those in a chart, along w = h (v, ω, ...),
// to the middle of a step, and of rates.
Tangents<double> size_of_tangents_in_chart(const reference::Robot<double>& robot, const reference::VectorX<double>& c);
Tangents<double> size_of_tangents_along(const reference::Robot<double>& robot, const reference::VectorX<double>& w);
Tangents<double> size_of_tangents_to_the_middle(const reference::Robot<double>& robot,
                                                const reference::VectorX<double>& w);
RateTangents<double> size_of_tangents_of_rates(const reference::Robot<double>& robot,
                                               const reference::VectorX<double>& c,
                                               const reference::VectorX<double>& v);

// The sizes of the terms of after_step() for sizes of changes, and of q̇'. A turn and a quaternion have entries up to 1,
// and change by half of an angle.
std::vector<double> step_magnitude(const ReferencePoint<double>& from, const reference::VectorX<double>& change,
                                   const reference::VectorX<double>& qd);

// The sizes of positions in tangent spaces, where an angle has that of an axis.
reference::VectorX<double> position_magnitude(const ReferencePoint<double>& from);

// A and B from derivatives of positions and rates by q, q̇ and τ.
template <class S>
std::vector<S> state_derivatives(const reference::MatrixX<S>& positions, const reference::MatrixX<S>& rates) {
  const Eigen::Index n = rates.rows();
  reference::MatrixX<S> A(2 * n, 2 * n), B(2 * n, n);
  A << positions.leftCols(2 * n), rates.leftCols(2 * n);
  B << positions.rightCols(n), rates.rightCols(n);
  return one_after_the_other<S>({A, B});
}

// The n × 3n derivatives that are the identity by q, q̇ or τ, the part of this number.
template <class S>
reference::MatrixX<S> unit_part(Eigen::Index n, Eigen::Index part) {
  reference::MatrixX<S> result = reference::MatrixX<S>::Zero(n, 3 * n);
  result.middleCols(part * n, n).setIdentity();
  return result;
}

// The derivatives of positions after a change whose numbers have these derivatives.
template <class S>
reference::MatrixX<S> derivatives_after(const Tangents<S>& tangents, const reference::MatrixX<S>& of_change) {
  return tangents.by_position * unit_part<S>(of_change.rows(), 0) + tangents.by_change * of_change;
}

}  // namespace flatdyn::references
