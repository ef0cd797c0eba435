// SPDX-License-Identifier: GPL-2.0-or-later
// Kinetic and potential energy of the robot as read over a prime field: the sums over its written links and rotors,
// each a body of its own. Velocities are derivatives of poses, as dual numbers. The poses of links are those that the
// mechanism gives them.
#pragma once

#include <utility>
#include <vector>

#include "truth/definition/written_numbers.hpp"

namespace flatdyn {

template <class F>
struct Energies {
  F kinetic = F(0), potential = F(0);
};

template <class Arithmetic>
class WrittenEnergies {
 public:
  using F = typename Arithmetic::Scalar;
  using D = Dual<F>;

  // `mechanism`: without loops. `q`, `rates`: of every body's joint. `offsets`: the constant parts of their positions;
  // empty: all zero.
  WrittenEnergies(const Robot& robot, const MechanismOver<F>& mechanism, Arithmetic& arithmetic,
                  const std::vector<JointPoint<F>>& q, const std::vector<F>& rates, const std::vector<Number>& offsets)
      : robot_(robot),
        numbers_(robot, arithmetic),
        gravity_(vector_over(numbers_, robot.gravity)),
        q_(q),
        rates_(rates),
        offsets_(offsets) {
    const std::vector<Pose3<D>> bodies = body_poses(mechanism, moving(q, rates));
    for (const FieldFrame<F>& link : mechanism.links) {
      const Pose3<D> body = link.body < 0 ? identity_pose<D>() : bodies[static_cast<std::size_t>(link.body)];
      links_.push_back(composed(body, Pose3<F>{link.R, link.p}));
    }
  }

  Energies<F> sum() {
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      for (const Inertial& inertial : robot_.links[l].inertials) add_inertial(inertial, links_[l]);
    }
    if (robot_.floating_base) add_armature_of_base();
    const std::vector<int> joints = moving_joints(robot_);
    std::size_t body = rates_.size();  // before those of the joints: the motion of a floating base
    for (const int j : joints) body -= bodies_of(robot_.joints[static_cast<std::size_t>(j)]);
    for (const int j : joints) {
      const Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
      const std::size_t i = body;
      body += bodies_of(joint);
      if (joint.type == JointType::spherical) continue;  // it has neither motor nor spring
      const F& rate = rates_[i];
      sum_.kinetic += half_ * numbers_.number(joint.armature.number) * rate * rate;
      if (!vanishes(joint.stiffness.number)) add_spring(joint, i);
      if (joint.motor) add_rotor(*joint.motor, rate, links_[static_cast<std::size_t>(carrier_of(joint))]);
    }
    return sum_;
  }

 private:
  // ½ (v·v + ω·ω) times it, with the first six rates.
  void add_armature_of_base() {
    const F armature = numbers_.number(robot_.base_joint.armature.number);
    for (std::size_t k = 0; k < 6; ++k) sum_.kinetic += half_ * armature * rates_[k] * rates_[k];
  }

  // The spring of body i's joint: ½ k (q - q_0)².
  void add_spring(const Joint& joint, std::size_t i) {
    F stretch = q_[i].d + -numbers_.number(joint.spring_reference.number);
    if (!offsets_.empty()) stretch += numbers_.number(offsets_[i]);
    sum_.potential += half_ * numbers_.number(joint.stiffness.number) * stretch * stretch;
  }

  // The mass of a body whose centre is at `centre` in the frame of `pose`.
  void add_mass(const F& mass, const Pose3<D>& pose, const Vector3<F>& centre) {
    const Vector3<D> at = plus(pose.p, times(pose.R, centre));
    F square = F(0), height = F(0);
    for (std::size_t k = 0; k < 3; ++k) {
      square += at[k].derivative * at[k].derivative;
      height += gravity_[k] * at[k].value;
    }
    sum_.kinetic += half_ * mass * square;
    sum_.potential += -(mass * height);
  }

  // ½ ∫ |Ṙ x|² dm is ½ tr(Ṙ Σ Ṙᵀ), where Σ = ∫ x xᵀ dm = ½ tr(I) 1 - I about the centre of mass.
  void add_inertial(const Inertial& inertial, const Pose3<D>& link) {
    const Pose3<D> frame = composed(link, pose_over(numbers_, inertial.frame));
    const F m = numbers_.number(inertial.mass.number);
    const Vector3<F> r = vector_over(numbers_, inertial.centre_of_mass);
    Matrix3<F> I = matrix_over(numbers_, inertial.tensor);
    if (inertial.about == Inertial::About::frame_origin) {
      for (std::size_t i = 0; i < 3; ++i) {
        I[i][i] += -(m * dot(r, r));
        for (std::size_t j = 0; j < 3; ++j) I[i][j] += m * r[i] * r[j];
      }
    }
    add_mass(m, frame, r);
    Matrix3<F> second = I;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) second[i][j] = -I[i][j];
      second[i][i] += half_ * (I[0][0] + I[1][1] + I[2][2]);
    }
    const Matrix3<F> turning = derivative_of(frame.R), weighted = times(turning, second);
    for (std::size_t i = 0; i < 3; ++i) sum_.kinetic += half_ * dot(turning[i], weighted[i]);
  }

  // About its axis z a rotor turns at z·ω + k_r q̇, across it like the link that carries it.
  void add_rotor(const Motor& motor, const F& rate, const Pose3<D>& link) {
    add_mass(numbers_.number(motor.mass.number), link, vector_over(numbers_, motor.position));
    const Vector3<F> omega = angular_velocity(link.R), z = times(value_of(link.R), numbers_.unit(motor.axis));
    const F along = dot(z, omega), spin = along + numbers_.number(motor.gear_ratio.number) * rate;
    sum_.kinetic += half_ * numbers_.number(motor.inertia_axial.number) * spin * spin;
    sum_.kinetic += half_ * numbers_.number(motor.inertia_transverse.number) * (dot(omega, omega) - along * along);
  }

  static Matrix3<F> derivative_of(const Matrix3<D>& R) {
    Matrix3<F> result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) result[i][j] = R[i][j].derivative;
    }
    return result;
  }
  static Matrix3<F> value_of(const Matrix3<D>& R) {
    Matrix3<F> result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) result[i][j] = R[i][j].value;
    }
    return result;
  }

  // S(ω) = Ṙ Rᵀ.
  static Vector3<F> angular_velocity(const Matrix3<D>& R) {
    const Matrix3<F> S = times(derivative_of(R), transposed(value_of(R)));
    return {S[2][1], S[0][2], S[1][0]};
  }

  const Robot& robot_;
  RationalNumbers<Arithmetic> numbers_;
  Vector3<F> gravity_;
  const std::vector<JointPoint<F>>& q_;
  const std::vector<F>& rates_;
  const std::vector<Number>& offsets_;
  std::vector<Pose3<D>> links_;
  F half_ = F(1) / (F(1) + F(1));
  Energies<F> sum_;
};

}  // namespace flatdyn
