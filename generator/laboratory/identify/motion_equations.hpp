// SPDX-License-Identifier: GPL-2.0-or-later
// The equations that a planned motion gives, and the parameters that they determine. The motion has a coordinate for
// each entry of q̇: the joints' positions, but roll, pitch and yaw of spherical joints and six coordinates of a
// floating base (base_coordinates.hpp).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laboratory/identify/base_coordinates.hpp"
#include "laboratory/identify/torque_model.hpp"

namespace flatdyn {

// A planned motion at an instant, as functions take it: entries of q, and of v and a, the twist of a floating base and
// its derivative first.
struct PlannedState {
  Eigen::VectorXd q, v, a;
  BaseState base{};
};

class MotionEquations {
 public:
  using RowByRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  // has_base_force: whether the force on a floating base will be measured. If not, the joints' equations alone count,
  // and the parameters that they depend on.
  explicit MotionEquations(const TorqueModel& model, bool has_base_force = true);

  const TorqueModel& model() const { return model_; }
  // The numbers that a motion consists of at an instant: one of each joint, after six of a floating base.
  int coordinates() const { return model_.equations(); }
  // The coordinate that the first equation is of, and the number of equations.
  int first_equation() const { return first_equation_; }
  int equations() const { return coordinates() - first_equation_; }
  // The entries of π_b that the equations depend on.
  const std::vector<int>& columns() const { return columns_; }
  int parameters() const { return static_cast<int>(columns_.size()); }

  // The motion by coordinates, their rates and accelerations: coordinates() numbers each.
  PlannedState state(const double* q, const double* qd, const double* qdd) const;
  // Y_b in these equations and columns. Arguments: coordinates() numbers each.
  RowByRow regressor(const double* q, const double* qd, const double* qdd) const;
  // The torques of the robot file, one per coordinate, N m or N.
  Eigen::VectorXd torques(const double* q, const double* qd, const double* qdd) const;
  // The file's values of columns().
  const Eigen::VectorXd& file_values() const { return file_values_; }
  // Information on all of π_b as that on columns(), whatever the others are. root: rows of b entries, or none.
  Eigen::MatrixXd information_on_columns(const Eigen::MatrixXd& root) const;

 private:
  // Writes Y_b at the motion to all_; returns the entries of q.
  Eigen::VectorXd evaluate(const double* q, const double* qd, const double* qdd) const;

  const TorqueModel& model_;
  int first_equation_;
  std::vector<int> columns_;
  Eigen::VectorXd file_values_;
  Eigen::Vector3d gravity_;
  mutable RowByRow all_;
};

}  // namespace flatdyn
