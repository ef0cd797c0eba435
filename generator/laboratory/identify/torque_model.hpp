// SPDX-License-Identifier: GPL-2.0-or-later
// τ = Y_b(q, q̇, q̈) π_b of one robot as a fast function of doubles: the emitted base regressor, compiled and loaded. Of
// a floating base, the first six entries of q̇ and q̈ are (0, ω) and (f, ω̇), base_motion.hpp: gravity is part of f.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "functions/load/loaded_robot.hpp"

namespace flatdyn {

class CompiledFunctions;

class TorqueModel {
 public:
  // Derives, emits and compiles the regressor. Throws Failure(unsupported) for a robot with free symbols, Failure(io)
  // if there is no compiler.
  TorqueModel(const LoadedRobot& model, ParameterSet set, Progress& progress);
  ~TorqueModel();
  TorqueModel(const TorqueModel&) = delete;
  TorqueModel& operator=(const TorqueModel&) = delete;

  const Mechanism& mechanism() const { return model_.mechanism; }
  // The number n of equations: of joints, after the six of a floating base's force.
  int equations() const { return model_.mechanism.size(); }
  // The equation of the first joint, and the number of joints.
  int first_joint() const { return model_.mechanism.base_bodies(); }
  int joints() const { return equations() - first_joint(); }
  // By equation, the first one of the same joint: six of a floating base and three of a spherical joint belong
  // together.
  std::vector<int> first_of_joint() const;
  // Whose equation it is, in sentences: 'joint "elbow"', 'the base's force along x'.
  std::string subject_of(int equation) const;
  // A short name for tables: the joint's, or "base_fx".
  std::string name_of(int equation) const;
  // "N" or "N m".
  const char* unit_of(int equation) const { return torque_unit(model_.mechanism.joint(equation)); }
  // The length b of π_b.
  int parameters() const { return base_.size(); }
  const BaseParameters& base() const { return base_; }
  // π_b of the robot file, b numbers.
  const std::vector<double>& file_values() const { return file_values_; }
  // I_m of the robot file, kg m² or kg.
  double file_rotor(int equation) const { return file_rotors_[static_cast<std::size_t>(equation)]; }
  // The name of parameter k of π_b, and the body that it is of.
  std::string parameter_name_of(int k) const;
  const Body& body_of_parameter(int k) const;
  // The columns of row i of Y_b that are not zero for every motion, ascending.
  const std::vector<int>& columns_of(int equation) const { return columns_[static_cast<std::size_t>(equation)]; }

  // Writes Y_b(q, q̇, q̈), n × b row by row, to y. Units: rad or m, and seconds; row i times π_b is in N m or N.
  void regressor(const double* q, const double* qd, const double* qdd, double* y) const;
  // ∂Y_b/∂q̈_j by entry of q̈, each n × b: (∂Y_b/∂q̈_j) π_b is column j of B(q).
  std::vector<Eigen::MatrixXd> acceleration_rows(const double* q) const;
  // Writes J_eᵀ h_e, n numbers, to tau: the joint torques, (7.42), of the force and moment h_e (6 numbers, base axes)
  // that the tip exerts on its environment.
  void tip_torque(const double* q, const double* h_e, double* tau) const;

  // Adds the torques of the robot file's springs, N m or N, which no base parameter says, to tau.
  void add_springs(const double* q, double* tau) const;
  // Their derivatives by q, of joints by joints.
  const Eigen::MatrixXd& stiffness() const { return stiffness_; }

  // The hash of the emitted text, so of geometry, gravity and parameters. Observations of different models are not
  // joined.
  const std::string& fingerprint() const { return fingerprint_; }

 private:
  LoadedRobot model_;
  BaseParameters base_;
  std::vector<double> file_values_, file_rotors_;
  std::vector<std::vector<int>> columns_;
  std::string fingerprint_;
  Eigen::MatrixXd stiffness_;
  Eigen::VectorXd relaxed_;  // the torques of the springs at q = 0, with the other sign
  std::unique_ptr<CompiledFunctions> compiled_;
};

}  // namespace flatdyn
