// SPDX-License-Identifier: GPL-2.0-or-later
// Pinocchio's algorithms of a mechanism, for numbers and for scalars that record operations. Include the header of the
// scalar before this one.
//
// Inputs are those of flatdyn's functions one after the other: q, then qd, then qdd or tau, then g_b of a floating
// base, where the function takes them. Outputs are flatdyn's, too, but for symmetric matrices: only the upper half is
// written, row by row, which is what Pinocchio computes.
#pragma once

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <vector>

#include "mechanism.hpp"

namespace pinocchio_peer {

template <class Scalar>
class Algorithms {
 public:
  using Model = pinocchio::ModelTpl<Scalar>;
  using Data = pinocchio::DataTpl<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  explicit Algorithms(const Mechanism& mechanism)
      : is_floating_(mechanism.base_bodies > 0),
        turns_gravity_(is_floating_ && mechanism.gravity != std::array<double, 3>()),
        model_(model_of(mechanism)),
        data_(model_),
        q_(neutral()) {
    velocities_ = model_.nv;
    positions_ = model_.nq - (is_floating_ ? 7 : 0);
    dtau_dq_ = dtau_dv_ = Matrix::Zero(velocities_, velocities_);
  }

  // The lengths of the parts of the inputs.
  int positions() const { return positions_; }
  int velocities() const { return velocities_; }
  bool turns_gravity() const { return turns_gravity_; }  // whether g_b is an input

  void inverse_dynamics(const Scalar* x, Scalar* y) {
    take(x, 3);
    write(rnea(model_, data_, q_, part(x, 0), part(x, 1)), y);
  }
  void inertia_matrix(const Scalar* x, Scalar* y) {
    take(x, 1);
    write_upper(crba(model_, data_, q_, pinocchio::Convention::LOCAL), y);
  }
  void gravity(const Scalar* x, Scalar* y) {
    take(x, 1);
    write(computeGeneralizedGravity(model_, data_, q_), y);
  }
  void bias(const Scalar* x, Scalar* y) {
    take(x, 2);
    write(nonLinearEffects(model_, data_, q_, part(x, 0)), y);
  }
  void coriolis_matrix(const Scalar* x, Scalar* y) {
    take(x, 2);
    write(computeCoriolisMatrix(model_, data_, q_, part(x, 0)), y);
  }
  void forward_dynamics(const Scalar* x, Scalar* y) {
    take(x, 3);
    write(aba(model_, data_, q_, part(x, 0), part(x, 1), pinocchio::Convention::LOCAL), y);
  }
  void inverse_dynamics_derivatives(const Scalar* x, Scalar* y) {
    take(x, 3);
    dtau_dq_.setZero();
    dtau_dv_.setZero();
    computeRNEADerivatives(model_, data_, q_, part(x, 0), part(x, 1), dtau_dq_, dtau_dv_, data_.M);
    write(dtau_dv_, write(dtau_dq_, y));
  }
  void forward_dynamics_derivatives(const Scalar* x, Scalar* y) {
    take(x, 3);
    computeABADerivatives(model_, data_, q_, part(x, 0), part(x, 1));
    write_upper(data_.Minv, write(data_.ddq_dv, write(data_.ddq_dq, y)));
  }

 private:
  template <class Numbers>
  static Eigen::Matrix<Scalar, 3, 1> vector(const Numbers& numbers) {
    return Eigen::Map<const Eigen::Vector3d>(numbers.data()).template cast<Scalar>();
  }
  template <class Numbers>
  static Eigen::Matrix<Scalar, 3, 3> matrix(const Numbers& numbers) {
    using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    return Eigen::Map<const Rows>(numbers.data()).template cast<Scalar>();
  }

  // The joint that link `index` moves by, with the links of a spherical joint and of a floating base at their last one.
  static auto add_joint(Model& model, const Mechanism& mechanism, std::size_t index, std::size_t parent) {
    const Link& link = mechanism.links[index];
    const auto base_bodies = static_cast<std::size_t>(mechanism.base_bodies);
    const std::string name = "joint" + std::to_string(index);
    if (index < base_bodies) {
      return model.addJoint(parent, pinocchio::JointModelFreeFlyerTpl<Scalar>(), pinocchio::SE3Tpl<Scalar>::Identity(),
                            name);
    }
    const Link& placed = mechanism.links[link.spherical > 0 ? index - 2 : index];
    const pinocchio::SE3Tpl<Scalar> placement(matrix(placed.R), vector(placed.p));
    if (link.spherical > 0) return model.addJoint(parent, pinocchio::JointModelSphericalTpl<Scalar>(), placement, name);
    if (link.prismatic != 0)
      return model.addJoint(parent, pinocchio::JointModelPrismaticTpl<Scalar, 0, 2>(), placement, name);
    return model.addJoint(parent, pinocchio::JointModelRevoluteTpl<Scalar, 0, 2>(), placement, name);
  }

  static Model model_of(const Mechanism& mechanism) {
    Model model;
    model.gravity.linear() = vector(mechanism.gravity);
    const auto base_bodies = static_cast<std::size_t>(mechanism.base_bodies);
    std::vector<std::size_t> joint_of(mechanism.links.size(), 0);
    for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
      const Link& link = mechanism.links[i];
      const bool is_inside = i + 1 < base_bodies || link.spherical == 1 || link.spherical == 2;
      if (is_inside) continue;
      const int parent = i < base_bodies ? -1 : mechanism.links[link.spherical > 0 ? i - 2 : i].parent;
      joint_of[i] = add_joint(model, mechanism, i, parent < 0 ? 0 : joint_of[static_cast<std::size_t>(parent)]);
      model.appendBodyToJoint(joint_of[i],
                              pinocchio::InertiaTpl<Scalar>(Scalar(link.mass), vector(link.r_C), matrix(link.I)),
                              pinocchio::SE3Tpl<Scalar>::Identity());
    }
    for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
      model.armature[static_cast<Eigen::Index>(i)] = Scalar(mechanism.links[i].armature);
    }
    return model;
  }

  // A floating base stays in the world's axes, so that gravity turns instead.
  Vector neutral() const {
    Vector q = Vector::Zero(model_.nq);
    if (is_floating_) q[6] = Scalar(1);
    return q;
  }

  // Takes q, and g_b behind `parts` parts of the inputs. A quaternion is (w, x, y, z) in flatdyn, and w is last here.
  void take(const Scalar* x, int parts) {
    const int behind_base = is_floating_ ? 7 : 0;
    for (int i = 0; i < positions_; ++i) q_[behind_base + i] = x[i];
    for (std::size_t joint = 1; joint < model_.joints.size(); ++joint) {
      const int first = model_.idx_qs[joint];
      if (model_.nqs[joint] != 4) continue;
      const Scalar w = q_[first];
      for (int i = 0; i < 3; ++i) q_[first + i] = q_[first + i + 1];
      q_[first + 3] = w;
    }
    const Scalar* const g_b = x + positions_ + (parts - 1) * velocities_;
    if (turns_gravity_) model_.gravity.linear() = Eigen::Map<const Eigen::Matrix<Scalar, 3, 1>>(g_b);
  }

  // The part of the inputs behind q: 0 for velocities, 1 for accelerations or torques.
  auto part(const Scalar* x, int index) const {
    return Eigen::Map<const Vector>(x + positions_ + index * velocities_, velocities_);
  }

  // Writes the entries row by row. Returns the place of the next entry.
  template <class M>
  static Scalar* write(const M& m, Scalar* y) {
    Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(y, m.rows(), m.cols()) = m;
    return y + m.size();
  }
  template <class M>
  static Scalar* write_upper(const M& m, Scalar* y) {
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      for (Eigen::Index j = i; j < m.cols(); ++j) *y++ = m(i, j);
    }
    return y;
  }

  bool is_floating_, turns_gravity_;
  Model model_;
  Data data_;
  Vector q_;
  int positions_ = 0, velocities_ = 0;
  Matrix dtau_dq_, dtau_dv_;
};

// A function of the algorithms, with what it takes and returns.
template <class Scalar>
struct Function {
  using Member = void (Algorithms<Scalar>::*)(const Scalar*, Scalar*);

  const char* name;  // of flatdyn's function
  Member run;
  int parts;                         // q, qd, and qdd or tau: how many of these it takes
  int vectors, matrices, symmetric;  // the numbers of its outputs, in this order

  // The number of its inputs.
  int inputs(const Algorithms<Scalar>& of) const {
    return of.positions() + (parts - 1) * of.velocities() + (of.turns_gravity() ? 3 : 0);
  }
  // The number of its outputs.
  int outputs(const Algorithms<Scalar>& of) const {
    const int n = of.velocities();
    return n * vectors + n * n * matrices + n * (n + 1) / 2 * symmetric;
  }
};

template <class Scalar>
const std::vector<Function<Scalar>>& functions() {
  using Of = Algorithms<Scalar>;
  static const std::vector<Function<Scalar>> table = {
      {"inverse_dynamics", &Of::inverse_dynamics, 3, 1, 0, 0},
      {"inertia_matrix", &Of::inertia_matrix, 1, 0, 0, 1},
      {"gravity", &Of::gravity, 1, 1, 0, 0},
      {"bias", &Of::bias, 2, 1, 0, 0},
      {"coriolis_matrix", &Of::coriolis_matrix, 2, 0, 1, 0},
      {"forward_dynamics", &Of::forward_dynamics, 3, 1, 0, 0},
      {"inverse_dynamics_derivatives", &Of::inverse_dynamics_derivatives, 3, 0, 2, 0},
      {"forward_dynamics_derivatives", &Of::forward_dynamics_derivatives, 3, 0, 2, 1},
  };
  return table;
}

// The function of this name. Throws std::runtime_error if there is none.
template <class Scalar>
const Function<Scalar>& function_named(const std::string& name) {
  for (const Function<Scalar>& function : functions<Scalar>()) {
    if (name == function.name) return function;
  }
  throw std::runtime_error("no function " + name);
}

}  // namespace pinocchio_peer
