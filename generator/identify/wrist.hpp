// SPDX-License-Identifier: GPL-2.0-or-later
// A payload from a force sensor at the wrist (7.4); no model of the arm's masses is needed.
#pragma once

#include "flatdyn/reference/robot.hpp"
#include "identify/payload.hpp"

namespace flatdyn {

// Folds samples as they arrive. The log's h_e is what the sensor measures: the force and moment that the tip's link
// exerts on the payload, along the axes of that link's frame, about its origin. Constant offsets of the sensor are
// estimated too.
class WristObserver {
 public:
  explicit WristObserver(const Robot& robot);

  void add(const MeasuredMotion& motion);
  // correlation: that of the noise, SampleFilter::correlation().
  PayloadEstimate estimate(double correlation = 1);

 private:
  reference::Robot<double> robot_;
  int joints_;
  std::vector<TriangularFactor> factors_;  // one per component of the wrench
};

}  // namespace flatdyn
