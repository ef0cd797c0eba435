// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of q, q̇ and τ at the states that a step goes through, all in one graph.
#pragma once

#include <vector>

#include "derivation/dynamics/step_chart.hpp"
#include "graph/function.hpp"

namespace flatdyn {

class Stages {
 public:
  using Entries = StepChart::Entries;

  // `of`: such a function, a copy of which is made for each stage. The mechanism must outlive this object.
  Stages(const Mechanism& mechanism, Function of);
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  Graph& graph() { return result_.graph; }
  const StepChart& chart() const { return chart_; }
  NodeId step_length() { return graph().input({InputKind::h, 0}); }

  // The entries of the function's outputs at the next stage. Its conditions become those of the result.
  std::vector<Entries> outputs_at(const StepChart::Positions& positions, const Entries& qd);

  // factor h x.
  Entries along(const Rational& factor, const Entries& x);
  // x + factor h ẋ, the rates at the stage that is next.
  Entries rates_after(const Entries& qd, const Rational& factor, const Entries& qdd);
  // The positions there.
  StepChart::Positions positions_after(const Entries& change, const StepChart::Turns& turns);

  // The function with these outputs, and with the conditions of all stages. Ends the use of this object.
  Function finished(std::vector<Output> outputs);

 private:
  void name_all(const char* stem, const Entries& entries);

  Function of_, result_;
  StepChart chart_;
  int stages_ = 0;
};

}  // namespace flatdyn
