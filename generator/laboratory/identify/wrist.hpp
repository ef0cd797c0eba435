// SPDX-License-Identifier: GPL-2.0-or-later
// A payload from a force sensor at the wrist (7.4); no model of the arm's masses is needed.
#pragma once

#include "flatdyn/reference/robot.hpp"
#include "laboratory/identify/payload.hpp"

namespace flatdyn {

// The log's h_e is what the sensor measures: the force and moment that the tip's link exerts on the payload, along the
// axes of that link's frame, about its origin. The unknowns are the ten parameters of the payload, then constant
// offsets of the sensor's six components. The motion of the tip's link follows from that of the joints and of a
// floating base.
class WristEquations : public EquationModel {
 public:
  // Throws Failure(unsupported) for a robot with free symbols.
  explicit WristEquations(const LoadedRobot& model);

  void evaluate(const MeasuredMotion& motion, double* entries, double* known) const override;
  void require(const LogLayout& layout, const Place& place, Diagnostics& diagnostics) const override;
  int measured(const LogLayout& layout) const override { return layout.h_e(); }

 private:
  mutable reference::Robot<double> robot_;  // spherical joints are turned as in the motion that was evaluated last
  int positions_, rates_;                   // entries of q; of q̇ and q̈
};

PayloadEstimate estimate_payload_at_wrist(const Observations& observations);

}  // namespace flatdyn
