// SPDX-License-Identifier: GPL-2.0-or-later
// A function that is going to be differentiated. With closed loops its graph has their motion as well: all joints move
// along with the independent ones, so that derivatives by these are those of motions in which every Φ stays as it is,
//   D_k f = Σ_p G_pk ∂f/∂q_p.
#pragma once

#include <vector>

#include "derivation/differentiation/tangents.hpp"
#include "derivation/dynamics/loop_functions.hpp"

namespace flatdyn {

class Differentiable {
 public:
  // `function`: derived in these choices; `arguments`: by which it is differentiated, besides free symbols.
  Differentiable(const Mechanism& mechanism, Function function, const std::vector<InputKind>& arguments,
                 const Choices& choices);

  const Function& function() const { return function_; }
  const Tangents& tangents() const { return tangents_; }

  // A derivative, whose graph is that of the function with more nodes, with conditions for the loops that it needs.
  Function finished(Function derivative) const;

 private:
  Function function_;
  Tangents tangents_;
  std::vector<ClosedLoops::Condition> conditions_;  // as nodes of the function's graph
};

}  // namespace flatdyn
