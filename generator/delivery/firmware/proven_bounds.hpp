// SPDX-License-Identifier: GPL-2.0-or-later
// The bounds of a function's rounding errors by `flatdyn certify`, for a self test: one per entry, with the states at
// which they hold.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "code/readback/emitted_text.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

class ProvenBounds {
 public:
  // The bounds of function k in the text of a C++ header; none if `certify` refuses it because of divisions, inputs
  // without limits or symbols. `mechanism` and `text` must outlive the object.
  ProvenBounds(const Mechanism& mechanism, const std::vector<Function>& functions, const EmittedText& text,
               std::size_t k, const std::string& scalar, Progress& progress);

  // Bounds of the absolute error of each entry of all outputs at a state that keeps the limits of the function's
  // inputs; negative if nothing is proven.
  std::vector<double> at(const State& state) const;

 private:
  bool keeps_limits(const State& state) const;

  const Mechanism& mechanism_;
  StraightLine lines_;
  std::vector<double> bounds_;  // one per entry; negative: none
};

}  // namespace flatdyn
