// SPDX-License-Identifier: GPL-2.0-or-later
// A check whether a formulation that was chosen for its operation count loses digits.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "functions/deviation/expected.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

class RoundingCheck {
 public:
  // The robot and the mechanism must outlive this object.
  RoundingCheck(const Robot& robot, const Mechanism& mechanism);

  // The largest scaled error of the function in double, computed by a tape, divided by that of the recursive reference,
  // which counts as one unit at least; the larger of the values for random and for extreme states.
  double loss(const Function& function);

 private:
  // The reference's values at one of the states, as far as they have been asked for.
  struct Known {
    std::optional<bool> is_regular;
    std::optional<std::vector<double>> rounded, scale;
  };

  Expected remembered(Expected expected);

  ExpectedValues expected_;
  std::string known_function_;
  std::map<const State*, Known> known_;  // of known_function_, which is tried in several forms; never iterated over
  std::vector<State> random_, extreme_;
};

}  // namespace flatdyn
