// SPDX-License-Identifier: GPL-2.0-or-later
// Functions as CasADi calls them: f, and its derivatives under the names that CasADi looks for. Of f with arguments x
// and outputs y these are
//   jac_f       from jac:f, the matrices jac_y_x
//   adj1_f      from vjp:f, adj_x from weights adj_y
//   fwd1_f      from jvp:f, fwd_y from a direction fwd_x
//   jac_adj1_f  from hessian:f and jac:f together, jac_adj_x_x and jac_adj_x_adj_y.
// Derivatives are by the entries of q; the free symbols of a robot are one more argument, the last one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/languages/casadi/sparsity.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct CasadiArgument {
  std::string name;
  Sparsity sparsity;
};

// Where an array of numbers comes from: whole arguments, each at its place in the array. Other places have zeros.
struct AssembledArray {
  struct Piece {
    int argument = 0;  // the number of CasADi's argument
    int place = 0, length = 0;
  };
  int length = 0;
  std::vector<Piece> pieces;

  bool is_argument() const { return pieces.size() == 1 && pieces.front().length == length; }
};

struct CasadiFunction {
  std::string name, derivative_of;  // derivative_of: f; empty for f itself
  std::vector<CasadiArgument> inputs, outputs;
  // The function of the C form: each output that has entries, as a vector of these. None if no output has any.
  std::optional<Function> code;
  std::optional<std::size_t> undifferentiated;  // the output that has no derivatives
  std::vector<AssembledArray> arguments;        // of the C form, in order, without the parameters
  int parameters = -1;                          // the number of CasADi's argument that is the parameters, or -1
};

// The functions in CasADi's form, without those that are only part of others.
std::vector<CasadiFunction> casadi_functions(const Mechanism& mechanism, const std::vector<Function>& functions);

// The code of those that have any, in their order.
std::vector<Function> code_of_casadi_functions(const Mechanism& mechanism, const std::vector<Function>& functions);

// The name in CasADi of a function without derivatives: "jacobian_hand" of "jacobian:hand".
std::string casadi_name(const std::string& function);

}  // namespace flatdyn
