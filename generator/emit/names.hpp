// SPDX-License-Identifier: GPL-2.0-or-later
// What the variables of a function are called.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emit/expression.hpp"
#include "emit/schedule.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// Names of one scope: each is a valid C++ identifier and given once.
class NameTable {
 public:
  explicit NameTable(std::set<std::string> taken) : taken_(std::move(taken)) {}

  // `wanted` made valid, with _2, _3, … if it is taken.
  std::string unique(const std::string& wanted);
  // t1, t2, …
  std::string temporary();

  const std::set<std::string>& taken() const { return taken_; }

 private:
  std::set<std::string> taken_;
  int temporaries_ = 0;
};

// Inputs: q_1 = q[0], as in the textbook; parameters by `parameters`. Nodes: the name given to them, else s_1, c_1 (of
// q_1), tau_1 (stored in tau[0]), else t1, t2, … in the order of the statements.
VariableNames name_variables(const Function& function, const Schedule& schedule,
                             const std::vector<std::string>& parameters, NameTable& names);

}  // namespace flatdyn
