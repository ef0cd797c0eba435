// SPDX-License-Identifier: GPL-2.0-or-later
// The arguments of emitted functions: names, lengths, meanings.
#pragma once

#include <string>
#include <vector>

#include "code/lower/joint_counts.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct InputArgument {
  std::string name;     // "qd"
  int length = 0;       // entries
  std::string meaning;  // "joint velocities, rad/s or m/s"
};

// The argument for a kind of input. `counts`: lengths of q and q̇; `own`: that of an argument whose length depends on
// the function. Throws std::logic_error for parameters, which are passed in one struct, and for stored values.
InputArgument input_argument(InputKind kind, JointCounts counts, int own = 0);

// An argument of a function, with the length and the meaning that it has there.
InputArgument input_argument(InputKind kind, JointCounts counts, const Function& function);

// The local variable that an input is read into: "qd_2" for qd[1]; for a parameter, the name of its member.
std::string variable_of_input(const Input& input, const std::vector<std::string>& parameters);

// Whether the function returns its value: it has one scalar output and cannot fail.
bool returns_value(const Function& function);

}  // namespace flatdyn
