// SPDX-License-Identifier: GPL-2.0-or-later
#include "simulate/joint_dynamics.hpp"

namespace flatdyn {
namespace {

Model without_dry_friction(Model model) {
  for (Body& body : model.mechanism.bodies) body.coulomb = 0;
  return model;
}

Eigen::VectorXd of_joints(const Mechanism& mechanism, Number Body::*member) {
  Eigen::VectorXd values(mechanism.size());
  for (int i = 0; i < mechanism.size(); ++i) {
    values(i) = nearest_double(mechanism.bodies[static_cast<std::size_t>(i)].*member);
  }
  return values;
}

}  // namespace

JointDynamics::JointDynamics(const Model& model, Progress& progress)
    : model_(without_dry_friction(with_whole_functions(model))) {
  require_numbers(model.robot, "a simulation");
  viscous_ = of_joints(model.mechanism, &Body::viscous);
  coulomb_ = of_joints(model.mechanism, &Body::coulomb);
  terms_.emplace(make_fusion(model_, {"inertia_matrix", "bias"}, progress).fusion.function);
  const std::vector<Function> functions =
      whole_functions(model_, {"gravity", "potential_energy"}, "a simulation", progress);
  gravity_.emplace(functions[0]);
  potential_.emplace(functions[1]);
  entries_.resize(terms_->results());
  result_ = {Eigen::MatrixXd(joints(), joints()), Eigen::VectorXd(joints())};
  g_.resize(joints());
}

TapeInputs JointDynamics::inputs(const double* q, const double* qd) const {
  const auto n = static_cast<std::size_t>(joints());
  TapeInputs given;
  given[InputKind::q] = {q, n};
  if (qd != nullptr) given[InputKind::qd] = {qd, n};
  return given;
}

const MotionTerms& JointDynamics::at(const double* q, const double* qd) {
  terms_->run(inputs(q, qd), entries_);
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
