// SPDX-License-Identifier: GPL-2.0-or-later
// One closed loop in the tree in 50 digits, with its joints at a generic position, where what is zero at all positions
// can be distinguished from what is not, or at a given position.
#pragma once

#include <functional>
#include <vector>

#include "flatdyn/reference/real50.hpp"
#include "graph/arithmetic.hpp"
#include "robot/model/field_loops.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Every joint a coordinate: as where joints are coupled, with A = 1. Those of a coupled tree stay as they are.
Mechanism with_coupling(Mechanism tree);

// The tree that is left when the robot's loops are cut, its base held still. Its mimicking joints stay coupled.
Mechanism open_mechanism(const Robot& robot);

// The frame of a link, which must be there.
const LinkFrame& frame_of(const Mechanism& tree, const std::string& link);

// A written loop in a tree that has gone through with_coupling().
LoopClosure closure_of(const Loop& written, const Mechanism& tree);

class LoopSample {
 public:
  using Real = reference::Real50;

  // Frames that are turned by any angles are rational to 40 digits, so what is zero in a plane is nearly so.
  static bool is_zero(const Real& x);

  // Where the joints are, and what free symbols stand for: none a multiple of another.
  static Real drawn(const Input& input);

  LoopSample(const Mechanism& tree, const LoopClosure& loop,
             const std::function<Real(const Input&)>& value_of = LoopSample::drawn);

  Matrix<Real> jacobian() const;  // of all components, m or 1 per rad or m of an entry of q
  Matrix<Real> rows() const;      // of those that the joints change
  std::vector<Real> gap() const;  // of all components, m and 1
  Real cosine() const;            // between its axes

 private:
  LoopGeometry<Real, Real> geometry() const { return {field_, points_}; }

  RealArithmetic<Real> arithmetic_;
  MechanismOver<Real> field_;
  std::vector<JointPoint<Real>> points_;
};

// Whether an entry of q has a part in the rows.
bool depends_on(const Matrix<LoopSample::Real>& J, int position);

// The first of these entries of q whose columns of J are independent, as many as there are.
std::vector<int> independent_columns(const Matrix<LoopSample::Real>& J, const std::vector<int>& positions);

}  // namespace flatdyn
