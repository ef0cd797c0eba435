// SPDX-License-Identifier: GPL-2.0-or-later
// Verification must detect errors: right functions pass, and each way of spoiling one is caught.
#include "proof/verify/verify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "functions/function_table.hpp"
#include "functions/planning/formulations.hpp"
#include "proof/verify/compiled.hpp"
#include "proof/verify/properties.hpp"
#include "support/robots.hpp"
#include "support/spare_joints.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

class Verify : public ::testing::Test {
 protected:
  Function derive(const std::string& name) const { return derive_function(mechanism, name); }
  VerifyReport run(const std::vector<Function>& functions) const {
    Progress quiet(true);
    return verify(robot, mechanism, functions, {.states = 20}, quiet);
  }
  // The function with one entry of its first output multiplied by a factor.
  Function spoiled(const std::string& name, std::size_t entry, const Rational& factor) const {
    Function function = derive(name);
    NodeId& id = function.outputs.at(0).entries.at(entry);
    EXPECT_FALSE(function.graph.is_zero(id));
    id = function.graph.scaled(factor, id);
    return function;
  }

  const Robot robot = testing::random_tree(6, 4, true);
  const Mechanism mechanism = testing::with_spare_joints(make_mechanism(robot));
};

TEST_F(Verify, PassesWhatIsRight) {
  std::vector<Function> functions;
  for (const FunctionRow& entry : function_table()) {
    if (entry.applies_to(mechanism)) functions.push_back(derive(entry.name));
  }
  const std::string link = robot.links.at(2).name;
  for (const char* stem : {"forward_kinematics:", "jacobian:", "jacobian_dot_qd:"}) {
    functions.push_back(derive(stem + link));
  }
  const VerifyReport report = run(functions);
  ASSERT_EQ(report.functions.size(), functions.size());
  for (const FunctionReport& f : report.functions) {
    EXPECT_TRUE(f.passed) << f.function << " graph " << f.graph_error << " double " << f.generated.largest << " edge "
                          << f.at_edges.largest;
    EXPECT_LE(f.reference.largest, 64) << f.function;
  }
  EXPECT_EQ(report.properties.size(), 5u);
  EXPECT_TRUE(report.passed()) << to_text(report);
}

// A relative error of 1e-30 is far below what doubles show; fifty digits reveal it, and so does the exact comparison.
TEST_F(Verify, SeesAPartInTenToTheThirty) {
  const Rational nearly = 1 + Rational("1/1" + std::string(30, '0'));
  const VerifyReport report = run({spoiled("gravity", 0, nearly)});
  const FunctionReport& row = report.functions.at(0);
  EXPECT_FALSE(row.proven);
  EXPECT_GT(row.graph_error, 1e-35);
  EXPECT_LT(row.generated.largest, 16);
  EXPECT_FALSE(report.passed());
}

TEST_F(Verify, SeesAPartInTenToTheTwelveInDouble) {
  const Rational nearly = 1 + Rational(1) / 1000000000000;
  const FunctionReport row = run({spoiled("inertia_matrix", 0, nearly)}).functions.at(0);
  EXPECT_FALSE(row.passed);
  EXPECT_GT(row.generated.largest, 16);
}

TEST_F(Verify, PropertiesSeeAWrongMatrix) {
  const std::vector<State> states = random_states(mechanism, 3, 1);
  const auto failed = [&](const std::vector<Function>& functions) {
    std::vector<std::string> names;
    for (const Property& property : check_properties(functions, states)) {
      if (!property.passed) names.push_back(property.name.substr(0, 14));
    }
    return names;
  };
  using Names = std::vector<std::string>;
  const int n = mechanism.size();
  EXPECT_EQ(failed({derive("inertia_matrix"), derive("coriolis_matrix")}), Names{});
  EXPECT_EQ(failed({spoiled("inertia_matrix", 0, -1)}), Names{"B is positive "});
  Function lopsided = derive("inertia_matrix");
  for (int i = 0; i < n * n; ++i) {
    const auto entry = static_cast<std::size_t>(i);
    if (i % n == i / n || lopsided.graph.is_zero(lopsided.outputs[0].entries[entry])) continue;
    lopsided = spoiled("inertia_matrix", entry, Rational(1001) / 1000);
    break;
  }
  EXPECT_EQ(failed({lopsided}), Names{"B is symmetric"});
  Function wrong = derive("coriolis_matrix");
  for (NodeId& id : wrong.outputs[0].entries) id = wrong.graph.scaled(Rational(1001) / 1000, id);
  EXPECT_EQ(failed({derive("inertia_matrix"), wrong}), Names{"w'(dB/dt - 2C)"});
}

TEST_F(Verify, TheCompiledTextComputesWhatTheGraphDoes) {
  const std::vector<Function> functions = {derive("inverse_dynamics_tip_force"), derive("kinetic_energy"),
                                           derive("forward_kinematics"), derive("forward_dynamics")};
  const CompiledFunctions compiled(mechanism, functions);
  for (const State& state : random_states(mechanism, 5, 2)) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const std::vector<double> values = compiled.call(k, state),
                                expected = *GraphEvaluator<double>(functions[k])(state);
      ASSERT_EQ(values.size(), expected.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(values[i], expected[i], 1e-11 * (1 + std::abs(expected[i]))) << functions[k].name << " " << i;
      }
    }
  }
}

// A body whose mass is a symbol, with value 0: B is singular, and the compiled function returns false.
TEST(Compiled, GivesNoNumbersWhereTheFunctionReturnsFalse) {
  const GiNaC::symbol m("m");
  Robot robot = testing::random_tree(5, 1);
  robot.symbols = {{m, "m", {}}};
  robot.links[1].inertials[0].mass.number = m;
  robot.links[1].inertials[0].tensor = zero_matrix();
  robot.joints[0].motor.reset();
  const Mechanism mechanism = make_mechanism(robot);
  const std::vector<Function> functions = {derive_function(mechanism, "forward_dynamics")};
  State state = random_states(mechanism, 1, 1)[0];
  const CompiledFunctions compiled(mechanism, functions);
  state.parameters = {0.5};
  EXPECT_TRUE(std::isfinite(compiled.call(0, state).at(0)));
  state.parameters = {0.0};
  EXPECT_TRUE(std::isnan(compiled.call(0, state).at(0)));
}

class WithoutCompiler : public ::testing::Test {
 protected:
  WithoutCompiler() {
    if (const char* chosen = std::getenv("CXX")) saved_ = chosen;
    ::setenv("CXX", "/no/such/compiler", 1);
  }
  ~WithoutCompiler() override { saved_.empty() ? ::unsetenv("CXX") : ::setenv("CXX", saved_.c_str(), 1); }

 private:
  std::string saved_;
};

TEST_F(WithoutCompiler, SaysWhatIsMissing) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(5, 1));
  try {
    CompiledFunctions compiled(mechanism, {derive_function(mechanism, "gravity")});
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::io);
    EXPECT_STREQ(failure.what(), "no C++ compiler: /no/such/compiler cannot be run");
  }
}

}  // namespace
}  // namespace flatdyn
