// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of q, q̇ and τ at the states that a step goes through, all in one graph.
#pragma once

#include <string>
#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

class Stages {
 public:
  // `of`: such a function, a copy of which is made for each stage.
  explicit Stages(Function of);

  Graph& graph() { return result_.graph; }
  NodeId step_length() { return graph().input({InputKind::h, 0}); }
  // All entries of q, q̇ or τ.
  std::vector<NodeId> arguments(InputKind kind);

  // The entries of the function's outputs at the next stage. Its conditions become those of the result.
  std::vector<std::vector<NodeId>> outputs_at(const std::vector<NodeId>& q, const std::vector<NodeId>& qd);

  // x + factor h ẋ: positions, "q", or rates, "qd", at the stage that is next.
  std::vector<NodeId> after(const std::string& name, const std::vector<NodeId>& x, const Rational& factor,
                            const std::vector<NodeId>& rate);

  // The function with these outputs, and with the conditions of all stages. Ends the use of this object.
  Function finished(std::vector<Output> outputs);

 private:
  Function of_, result_;
  int stages_ = 0;
};

}  // namespace flatdyn
