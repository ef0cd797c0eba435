// SPDX-License-Identifier: GPL-2.0-or-later
// Twice the kinetic energy of a rigid body as a quadratic form of the velocity of a point and the angular velocity.
#pragma once

#include <array>

#include "robot/model/body_poses.hpp"

namespace flatdyn {

// The entries of the symmetric matrix of the form: three velocities, then three angular ones.
template <class F>
using QuadraticForm = std::array<std::array<F, 6>, 6>;

// A rigid body as it is written: its centre of mass at `centre`, and its tensor about the origin of `frame` along its
// axes.
template <class F>
struct WrittenBody {
  Pose3<F> frame;
  F mass;
  Vector3<F> centre;
  Matrix3<F> tensor;
};

// Adds the form of a body. It is evaluated at pairs of unit velocities of the point at the origin and of unit angular
// velocities: m u·u' + m u·(ω'×r) + m u'·(ω×r) + ω·I ω', where u is the velocity of the frame's origin and r leads from
// there to the centre of mass.
template <class F>
void add_body(const WrittenBody<F>& body, QuadraticForm<F>& form) {
  struct Motion {
    Vector3<F> u, omega_x_r, omega, I_omega;  // the last two along the frame's axes
  };
  std::array<Motion, 6> motions;
  const Vector3<F> r = times(body.frame.R, body.centre), none = {F(0), F(0), F(0)};
  for (std::size_t k = 0; k < 6; ++k) {
    Vector3<F> unit = none;
    unit[k % 3] = F(1);
    const Vector3<F> omega = k < 3 ? none : unit, local = times(transposed(body.frame.R), omega);
    motions[k] = {k < 3 ? unit : cross(omega, body.frame.p), cross(omega, r), local, times(body.tensor, local)};
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const Motion &a = motions[i], &b = motions[j];
      const F moved = dot(a.u, b.u) + dot(a.u, b.omega_x_r) + dot(b.u, a.omega_x_r);
      form[i][j] += body.mass * moved + dot(a.omega, b.I_omega);
    }
  }
}

}  // namespace flatdyn
