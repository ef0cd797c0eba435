// SPDX-License-Identifier: GPL-2.0-or-later
// record_cppadcodegen MECHANISM FUNCTION...: prints Pinocchio's functions as C that CppADCodeGen has recorded,
// cppadcodegen_FUNCTION. Each is in a namespace, as each defines CppADCodeGen's types anew.
#include <pinocchio/codegen/cppadcg.hpp>

#include "algorithms.hpp"

#include <cstdio>
#include <iostream>

namespace {

using namespace pinocchio_peer;
using Coded = CppAD::cg::CG<double>;
using Scalar = CppAD::AD<Coded>;

void record(const Mechanism& mechanism, const std::string& name) {
  Algorithms<Scalar> algorithms(mechanism);
  const Function<Scalar>& function = function_named<Scalar>(name);
  CppAD::vector<Scalar> x(static_cast<std::size_t>(function.inputs(algorithms)));
  CppAD::vector<Scalar> y(static_cast<std::size_t>(function.outputs(algorithms)));
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = Scalar(0.5);
  CppAD::Independent(x);
  (algorithms.*function.run)(x.data(), y.data());
  CppAD::ADFun<Coded> recorded(x, y);
  recorded.optimize("no_compare_op");

  CppAD::cg::CodeHandler<double> handler;
  CppAD::vector<Coded> in(x.size());
  handler.makeVariables(in);
  CppAD::vector<Coded> out = recorded.Forward(0, in);
  CppAD::cg::LanguageC<double> language("double");
  language.setGenerateFunction("cppadcodegen_" + name);
  CppAD::cg::LangCDefaultVariableNameGenerator<double> names;
  std::cout << "inline namespace of_" << name << " {\n";
  handler.generateCode(std::cout, language, out, names);
  std::cout << "}\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Mechanism mechanism = read_mechanism(argc > 1 ? argv[1] : "");
    std::cout << "#include <math.h>\n#include <stdio.h>\n";
    for (int k = 2; k < argc; ++k) record(mechanism, argv[k]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "record_cppadcodegen: %s\n", error.what());
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
