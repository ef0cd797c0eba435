// SPDX-License-Identifier: GPL-2.0-or-later
// The torques of a motion, each contribution by itself, as (7.42) has them:
//   τ_i = Σ_j b_ij q̈_j + Σ_j c_ijj q̇_j² + Σ_{j<k} 2 c_ijk q̇_j q̇_k + g_i + F_vi q̇_i + F_si sgn(q̇_i) + (Jᵀ h_e)_i
// Motors are part of B: b_ii has the rotor's k_r² I_m and the armature, b_ij what a rotor adds that turns with a link.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "graph/tape.hpp"
#include "load/loaded_robot.hpp"
#include "model/joint_friction.hpp"
#include "trajectory/closed_positions.hpp"
#include "trajectory/trajectory.hpp"

namespace flatdyn {

enum class TermKind { own_inertia, coupling, centrifugal, coriolis, gravity, viscous, coulomb, tip_force };

// One term of one joint's torque. j, k: whose acceleration or rates act; -1 where none do.
struct TorqueTerm {
  TermKind kind;
  int joint = 0, j = -1, k = -1;
  std::size_t entry = 0;  // of what it is made from: of B, of the Christoffel symbols

  // "inertia_1_2", "centrifugal_1_2", "coriolis_1_1_2", "gravity_1", …, joints from 1.
  std::string name() const;
};

const char* name_of(TermKind kind);

class TorqueTerms {
 public:
  // Derives; terms that are zero at every motion are left out. Throws Failure(unsupported) for free symbols.
  TorqueTerms(const LoadedRobot& model, bool tip_force, Progress& progress);

  int joints() const { return n_; }
  // Joint by joint, in the order of the formula above.
  const std::vector<TorqueTerm>& terms() const { return terms_; }

  // Every term, N m or N, into `values`; the torques of inverse dynamics as they are generated, derived apart from the
  // terms, into `tau`. Not from two threads at once.
  void evaluate(const TrajectoryPoint& point, std::span<double> values, std::span<double> tau);

 private:
  double value_of(const TorqueTerm& term, const TrajectoryPoint& point) const;
  void add_terms_of(int i, const Function& B, const Function& symbols);

  int n_ = 0;
  ClosedPositions closed_;
  std::vector<TorqueTerm> terms_;
  JointFriction friction_;
  std::vector<Tape> tapes_;                   // B, Christoffel symbols, g, J of the tip, inverse dynamics
  std::vector<std::vector<double>> results_;  // of each
};

// Along a trajectory: by point.
struct TorqueHistory {
  std::vector<TorqueTerm> terms;
  std::vector<std::vector<double>> values;  // of each term, N m or N
  std::vector<std::vector<double>> tau;     // of each joint
  // Largest difference between a torque and the sum of its terms, over the sum of their absolute values.
  double disagreement = 0;
};
TorqueHistory torque_history(TorqueTerms& terms, const Trajectory& trajectory);

}  // namespace flatdyn
