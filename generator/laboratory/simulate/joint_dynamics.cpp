// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/simulate/joint_dynamics.hpp"

#include "functions/planning/make_functions.hpp"
#include "robot/model/floating_base.hpp"
#include "robot/model/joint_friction.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

LoadedRobot without_friction_that_jumps(LoadedRobot model) {
  require_numbers(model.robot, "a simulation");
  for (Body& body : model.mechanism.bodies) {
    if (!body.dry.is_smooth()) body.coulomb = 0;
  }
  return model;
}

}  // namespace

JointDynamics::JointDynamics(const LoadedRobot& model, Progress& progress)
    : model_(without_friction_that_jumps(without_scene_restrictions(model))),
      closed_(model_),
      friction_(joint_friction(model.mechanism)) {
  viscous_ = vector_of(friction_.viscous);
  coulomb_ = vector_of(friction_.coulomb);
  if (has_base_armature(model.mechanism)) base_armature_ = nearest_double(model.mechanism.bodies.front().armature);
  terms_.emplace(make_fusion(model_, {"inertia_matrix", "bias"}, progress).fusion.function);
  const std::vector<Function> functions =
      derive_numeric_functions(model_, {"gravity", "potential_energy"}, "a simulation", progress);
  gravity_.emplace(functions[0]);
  potential_.emplace(functions[1]);
  entries_.resize(terms_->results());
  result_ = {Eigen::MatrixXd(joints(), joints()), Eigen::VectorXd(joints())};
  g_.resize(joints());
  const Vec3& g_0 = model_.mechanism.gravity;
  gravity_in_world_ = {nearest_double(g_0[0]), nearest_double(g_0[1]), nearest_double(g_0[2])};
  g_b_ = gravity_in_world_;
  w_.assign(model_.mechanism.spherical.size(), 1);
}

Eigen::VectorXd JointDynamics::smooth_friction(const Eigen::VectorXd& qd) const {
  Eigen::VectorXd torque = viscous_.cwiseProduct(qd);
  for (const SmoothFriction& each : friction_.smooth) {
    const auto k = static_cast<Eigen::Index>(each.coordinate);
    torque(k) += each.torque(qd(k));
  }
  return torque;
}

void JointDynamics::turn_base(const Eigen::Quaterniond& orientation) {
  g_b_ = orientation.conjugate() * gravity_in_world_;
}

void JointDynamics::turn_spherical_joints(const double* w) {
  w_.assign(w, w + static_cast<std::ptrdiff_t>(mechanism().spherical.size()));
}

void JointDynamics::place_spherical_joints(const double* q) {
  positions_.resize(static_cast<std::size_t>(mechanism().position_count()));
  for (int k = mechanism().base_bodies(); k < mechanism().size(); ++k) {
    positions_[static_cast<std::size_t>(mechanism().position_of(k))] = q[k];
  }
  for (std::size_t j = 0; j < w_.size(); ++j) {
    const int first = mechanism().spherical[j];
    const Eigen::Quaterniond turn = Eigen::Quaterniond(w_[j], q[first], q[first + 1], q[first + 2]).normalized();
    double* const entries = positions_.data() + mechanism().quaternion_of(first);
    entries[0] = turn.w(), entries[1] = turn.x(), entries[2] = turn.y(), entries[3] = turn.z();
  }
}

std::span<const double> JointDynamics::positions(const double* q) {
  if (mechanism().has_spherical_joints()) {
    place_spherical_joints(q);
    return positions_;
  }
  const int of_base = mechanism().base_bodies();
  return closed_.of({q + of_base, static_cast<std::size_t>(joints() - of_base)});
}

TapeInputs JointDynamics::inputs(const double* q, const double* qd) {
  const auto n = static_cast<std::size_t>(joints());
  TapeInputs given;
  given[InputKind::q] = positions(q);
  if (qd != nullptr) given[with_base(InputKind::qd, mechanism().has_quasi_velocities())] = {qd, n};
  if (mechanism().floating_base) given[InputKind::g_b] = {g_b_.data(), static_cast<std::size_t>(g_b_.size())};
  return given;
}

const MotionTerms& JointDynamics::at(const double* q, const double* qd) {
  if (!terms_->run(inputs(q, qd), entries_)) closed_.refuse_singular();
  const Eigen::Index n = joints();
  result_.B = Eigen::Map<const Eigen::MatrixXd>(entries_.data(), n, n);
  result_.n = Eigen::Map<const Eigen::VectorXd>(entries_.data() + n * n, n);
  return result_;
}

const Eigen::VectorXd& JointDynamics::gravity(const double* q) {
  gravity_->run(inputs(q, nullptr), {g_.data(), static_cast<std::size_t>(g_.size())});
  return g_;
}

double JointDynamics::potential_energy(const double* q) {
  double energy = 0;
  potential_->run(inputs(q, nullptr), {&energy, 1});
  return energy;
}

}  // namespace flatdyn
