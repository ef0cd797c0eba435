// SPDX-License-Identifier: GPL-2.0-or-later
// What `flatdyn certify` says of a function's rounding errors, for a self test: by entry, and at which states it holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/states.hpp"
#include "readback/emitted_text.hpp"

namespace flatdyn {

class ProvenBounds {
 public:
  // Of function k in the text of a C++ header; none where `certify` refuses: divisions, inputs without limits, symbols.
  // Both must outlive it.
  ProvenBounds(const Mechanism& mechanism, const std::vector<Function>& functions, const EmittedText& text,
               std::size_t k, const std::string& scalar, Progress& progress);

  // Of the absolute error of each entry of all outputs, at a state that keeps the limits of what the function reads;
  // negative where nothing is proven.
  std::vector<double> at(const State& state) const;

 private:
  bool keeps_limits(const State& state) const;

  const Mechanism& mechanism_;
  StraightLine lines_;
  std::vector<double> bounds_;  // by entry; negative: none
};

}  // namespace flatdyn
