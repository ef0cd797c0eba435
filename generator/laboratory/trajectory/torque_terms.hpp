// SPDX-License-Identifier: GPL-2.0-or-later
// The torques of a motion, each contribution of (7.42) by itself:
//   τ_i = Σ_j b_ij q̈_j + Σ_j c_ijj q̇_j² + Σ_{j<k} 2 c_ijk q̇_j q̇_k + g_i + F_vi q̇_i + F_si sgn(q̇_i) + (Jᵀ h_e)_i
// Motors are part of B: b_ii contains the rotor's k_r² I_m and the armature, b_ij the contribution of a rotor that
// turns with a link.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "graph/tape.hpp"
#include "laboratory/trajectory/closed_positions.hpp"
#include "laboratory/trajectory/trajectory.hpp"
#include "robot/model/joint_friction.hpp"

namespace flatdyn {

enum class TermKind { own_inertia, coupling, centrifugal, coriolis, gravity, viscous, coulomb, tip_force, spring };

// One term of one joint's torque. j, k: the joints whose acceleration or rates act; -1 for none.
struct TorqueTerm {
  TermKind kind;
  int joint = 0, j = -1, k = -1;
  std::size_t entry = 0;  // index into the output that it is made from: B, or the Christoffel symbols

  // "inertia_1_2", "centrifugal_1_2", "coriolis_1_1_2", "gravity_1", …, joints from 1.
  std::string name() const;
};

const char* name_of(TermKind kind);

class TorqueTerms {
 public:
  // Derives the functions; terms that are zero for every motion are left out. Throws Failure(unsupported) for free
  // symbols.
  TorqueTerms(const LoadedRobot& model, bool tip_force, Progress& progress);

  int joints() const { return n_; }
  // The terms joint by joint, in the order of the formula above.
  const std::vector<TorqueTerm>& terms() const { return terms_; }

  // Writes every term, N m or N, to `values`, and to `tau` the torques of the generated inverse dynamics, which are
  // derived independently of the terms. Not thread-safe.
  void evaluate(const TrajectoryPoint& point, std::span<double> values, std::span<double> tau);

 private:
  double value_of(const TorqueTerm& term, const TrajectoryPoint& point) const;
  void add_terms_of(int i, const Function& B, const Function& symbols);

  int n_ = 0;
  bool has_springs_ = false;
  ClosedPositions closed_;
  std::vector<TorqueTerm> terms_;
  JointFriction friction_;
  std::vector<Tape> tapes_;  // B, Christoffel symbols, g, inverse dynamics, the bias at rest, J of the tip
  std::vector<std::vector<double>> results_;  // one per tape
};

// The torques along a trajectory, by point.
struct TorqueHistory {
  std::vector<TorqueTerm> terms;
  std::vector<std::vector<double>> values;  // per term, N m or N
  std::vector<std::vector<double>> tau;     // per joint, N m or N
  // The largest difference between a torque and the sum of its terms, relative to the sum of their absolute values.
  double disagreement = 0;
};
// Evaluates the terms at every point of the trajectory.
TorqueHistory torque_history(TorqueTerms& terms, const Trajectory& trajectory);

}  // namespace flatdyn
