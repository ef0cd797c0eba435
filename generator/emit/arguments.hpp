// SPDX-License-Identifier: GPL-2.0-or-later
// The arguments of emitted functions: names, lengths, what they mean.
#pragma once

#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

struct InputArgument {
  std::string name;     // "qd"
  int length = 0;       // entries
  std::string meaning;  // "joint velocities, rad/s or m/s"
};

// How long q̇ is, and with it q̈ and τ; and how long q, which is longer where loops are closed.
struct JointCounts {
  int joints, positions;

  JointCounts(int n) : joints(n), positions(n) {}  // NOLINT(google-explicit-constructor): most robots have one number
  explicit JointCounts(const Mechanism& mechanism) : joints(mechanism.size()), positions(mechanism.position_count()) {}
};

// `counts`: lengths of q and q̇; `base_parameters`: of pi_b. Not for InputKind::parameter: those arrive in one struct.
InputArgument input_argument(InputKind kind, JointCounts counts, int base_parameters = 0);

// The local variable that an input is read into: "qd_2" of qd[1]; a parameter's is its member's name.
std::string variable_of_input(const Input& input, const std::vector<std::string>& parameters);

// "qd[1]", "parameters.m1".
std::string access_of_input(const Input& input, const std::vector<std::string>& parameters,
                            const Dialect& dialect = {});

// "q[1..6], qd[0..6], parameters.m1"; "nothing".
std::string list_of_inputs(const std::vector<Input>& inputs, const std::vector<std::string>& parameters,
                           const Dialect& dialect = {});

// The function has one scalar output and cannot fail: it returns the value.
bool returns_value(const Function& function);

// How an output lies in memory: "7 x 7, row by row".
std::string layout_text(const Output& output);

}  // namespace flatdyn
