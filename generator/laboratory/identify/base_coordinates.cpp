// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/base_coordinates.hpp"

#include <cmath>

namespace flatdyn {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d BaseState::specific_force(const Vector3d& gravity) const {
  const Vector3d v = twist.head<3>(), turns = twist.tail<3>();
  return twist_rates.head<3>() + turns.cross(v) - turn.conjugate() * gravity;
}

// ω = E(roll, pitch) (rates of roll, pitch and yaw).
TurnState turn_state(const double* angles, const double* rates, const double* accelerations) {
  using Three = Eigen::Map<const Vector3d>;
  const double roll = angles[0], pitch = angles[1], yaw = angles[2], roll_rate = rates[0], pitch_rate = rates[1];
  const double sr = std::sin(roll), cr = std::cos(roll), sp = std::sin(pitch), cp = std::cos(pitch);
  Matrix3d E, E_rate;
  E << 1, 0, -sp, 0, cr, sr * cp, 0, -sr, cr * cp;
  E_rate << 0, 0, -cp * pitch_rate, 0, -sr * roll_rate, cr * cp * roll_rate - sr * sp * pitch_rate, 0, -cr * roll_rate,
      -sr * cp * roll_rate - cr * sp * pitch_rate;
  return {
      AngleAxisd(yaw, Vector3d::UnitZ()) * AngleAxisd(pitch, Vector3d::UnitY()) * AngleAxisd(roll, Vector3d::UnitX()),
      E * Three(rates), E * Three(accelerations) + E_rate * Three(rates)};
}

BaseState base_state(const double* coordinates, const double* rates, const double* accelerations) {
  using Three = Eigen::Map<const Vector3d>;
  const TurnState turned = turn_state(coordinates + 3, rates + 3, accelerations + 3);
  const Eigen::Quaterniond back = turned.turn.conjugate();
  const Vector3d v = back * Three(rates);
  BaseState state;
  state.place = Three(coordinates);
  state.turn = turned.turn;
  state.twist << v, turned.velocity;
  state.twist_rates << back * Three(accelerations) - turned.velocity.cross(v), turned.acceleration;
  return state;
}

}  // namespace flatdyn
