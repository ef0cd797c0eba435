// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a function that was chosen for its cost pays for it in digits.
#pragma once

#include <vector>

#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/robot.hpp"
#include "reference/expected.hpp"

namespace flatdyn {

class RoundingCheck {
 public:
  // Both must outlive it.
  RoundingCheck(const Robot& robot, const Mechanism& mechanism);

  // The largest scaled error in double, as a tape computes it, over the largest of the recursive reference, which
  // counts as one unit at least: at random states, or at extreme ones, where it is more.
  double loss(const Function& function) const;

 private:
  ExpectedValues expected_;
  std::vector<State> random_, extreme_;
};

}  // namespace flatdyn
