// SPDX-License-Identifier: GPL-2.0-or-later
// The names of a function's variables.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "code/lower/expressions.hpp"
#include "code/lower/schedule.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// The names in one scope: each is a valid C++ identifier and used once.
class NameTable {
 public:
  explicit NameTable(std::set<std::string> taken) : taken_(std::move(taken)) {}

  // `wanted` made valid, with _2, _3, … appended if it is taken.
  std::string unique(const std::string& wanted);
  // The next of t1, t2, …
  std::string temporary();

  const std::set<std::string>& taken() const { return taken_; }

 private:
  std::set<std::string> taken_;
  int temporaries_ = 0;
};

// Names the variables. Inputs: q_1 = q[0], as in the textbook; parameters by `parameters`, stored values by `stored`.
// Nodes: their own names, else s_1, c_1 (of q_1), tau_1 (stored in tau[0]), else t1, t2, … in the order of the
// statements.
VariableNames name_variables(const Function& function, const Schedule& schedule,
                             const std::vector<std::string>& parameters, const std::vector<std::string>& stored,
                             NameTable& names);

}  // namespace flatdyn
