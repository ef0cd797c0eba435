// SPDX-License-Identifier: GPL-2.0-or-later
// The values that a function must return at a state by the recursive reference, which is written without a look at the
// derivation, in double and 50 digits; and the size of the terms of its entries, for scaled errors.
#pragma once

#include <functional>
#include <vector>

#include "graph/function.hpp"
#include "graph/function_name.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

// The robot that a reference computes with.
template <class S>
struct ReferenceModel {
  const Mechanism& mechanism;  // the frames that parameters refer to
  reference::Robot<S> robot;   // whose tip is the frame that the function is about, see robot_for_function()
  const SymbolValues& symbols;
};

// The entries of all outputs, in order.
template <class S>
using ReferenceFunction = std::function<std::vector<S>(const StateOf<S>&)>;

// Makes the reference of a function, which must outlive it, for one robot.
template <class S>
using Preparation = ReferenceFunction<S> (*)(const ReferenceModel<S>&, const Function&);

struct NumericReference {
  Preparation<double> in_double;
  Preparation<Real50> exact;
  Preparation<double>
      magnitude;  // by entry: the sum of the absolute values of its terms (truth/reference/magnitude.hpp)
  // Whether one state needs many recursions: Christoffel symbols by polarisation need n², regressors one per column.
  bool needs_many_recursions = false;

  template <class S>
  Preparation<S> over() const {
    if constexpr (std::is_same_v<S, double>) return in_double;
    if constexpr (std::is_same_v<S, Real50>) return exact;
  }
};

// The robot for a function: a function of a named link ("jacobian:hand") has that link's frame as its tip.
template <class S>
reference::Robot<S> robot_for_function(const Function& function, const Robot& written, reference::Robot<S> robot) {
  const std::optional<std::string> link = parts_of_name(function.name).link;
  if (!link) return robot;
  for (std::size_t l = 0; l < written.links.size(); ++l) {
    if (written.links[l].name == *link) robot.tip = static_cast<int>(l);
  }
  robot.R_tip.setIdentity();
  robot.p_tip.setZero();
  return robot;
}

}  // namespace flatdyn
