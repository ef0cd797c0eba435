// SPDX-License-Identifier: GPL-2.0-or-later
// record_casadi MECHANISM FUNCTION...: prints Pinocchio's functions as C that CasADi has recorded, casadi_FUNCTION.
#include <pinocchio/autodiff/casadi.hpp>

#include "algorithms.hpp"

#include <cstdio>
#include <iostream>

namespace {

using namespace pinocchio_peer;
using casadi::SX;

casadi::Function recorded(const Mechanism& mechanism, const std::string& name) {
  Algorithms<SX> algorithms(mechanism);
  const Function<SX>& function = function_named<SX>(name);
  const SX x = SX::sym("x", function.inputs(algorithms));
  std::vector<SX> in, out(static_cast<std::size_t>(function.outputs(algorithms)), SX(0));
  for (casadi_int k = 0; k < x.rows(); ++k) in.push_back(x(k));
  (algorithms.*function.run)(in.data(), out.data());
  return casadi::Function("casadi_" + name, {x}, {SX::densify(SX::vertcat(out))});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Mechanism mechanism = read_mechanism(argc > 1 ? argv[1] : "");
    casadi::CodeGenerator code("casadi_functions");
    for (int k = 2; k < argc; ++k) code.add(recorded(mechanism, argv[k]));
    std::cout << code.dump();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "record_casadi: %s\n", error.what());
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
