// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/regressor.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/planning/formulations.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/field_mechanism.hpp"
#include "support/robots.hpp"

namespace flatdyn {
namespace {

using Field = ModP<kMersenne61>;

std::vector<Field> field_values(const Function& function, std::uint64_t seed) {
  ModPArithmetic<> arithmetic(seed);
  const std::vector<Field> all = evaluate(function, arithmetic);
  std::vector<Field> result;
  for (const NodeId id : function.outputs[0].entries) result.push_back(all[static_cast<std::size_t>(id)]);
  return result;
}

bool moves(const Mechanism& mechanism, int i, int j) {
  while (j > i) j = mechanism.bodies[static_cast<std::size_t>(j)].parent;
  return i == j;
}

class RandomRegressor : public ::testing::TestWithParam<unsigned> {
 protected:
  Mechanism mechanism = make_mechanism(testing::random_tree(GetParam(), 6));
  Function function = derive_function(mechanism, "regressor");
  int n = mechanism.size();
};

// (7.81), with motors on any link and both kinds of friction.
TEST_P(RandomRegressor, TimesTheParametersIsTheTorque) {
  const std::vector<Field> Y = field_values(function, 7),
                           tau = field_values(derive_function(mechanism, "inverse_dynamics"), 7);
  const std::vector<Number> pi = dynamic_parameters(mechanism);
  for (std::size_t i = 0; i < tau.size(); ++i) {
    Field sum;
    for (std::size_t k = 0; k < pi.size(); ++k) sum += Y[i * pi.size() + k] * Field::from(to_rational(pi[k]));
    EXPECT_TRUE(sum == tau[i]) << "joint " << i;
  }
}

// (7.80): torque i does not depend on bodies that joint i does not move; of its own body, it depends on each parameter
// that the joint's type allows.
TEST_P(RandomRegressor, HasStructuralZerosByBranch) {
  const Graph& graph = function.graph;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < kParametersPerJoint * n; ++k) {
      const NodeId entry = function.outputs[0].entries[static_cast<std::size_t>(i * kParametersPerJoint * n + k)];
      if (!moves(mechanism, i, joint_of(k))) {
        EXPECT_TRUE(graph.is_zero(entry)) << i << " " << parameter_name(k);
      }
      if (i == joint_of(k) && parameter_of(k) >= Parameter::Im) {
        EXPECT_FALSE(graph.is_zero(entry)) << parameter_name(k);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRegressor, ::testing::Range(1u, 9u));

TEST(Regressor, IsBlockUpperTriangularForAChain) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(6, 5, true));
  const Function function = derive_function(mechanism, "regressor");
  const int columns = kParametersPerJoint * mechanism.size();
  EXPECT_EQ(function.outputs[0].cols, columns);
  for (int i = 0; i < mechanism.size(); ++i) {
    for (int k = 0; k < kParametersPerJoint * i; ++k) {
      EXPECT_TRUE(function.graph.is_zero(function.outputs[0].entries[static_cast<std::size_t>(i * columns + k)]));
    }
  }
}

// A payload fixed to the last link adds to that link's parameters, and the regressor does not change.
TEST(Regressor, TakesATipPayloadAsParametersOfTheLastLink) {
  Robot robot = testing::random_tree(6, 4, true);
  const Mechanism bare = make_mechanism(robot);
  robot.links.back().inertials.push_back(testing::link("payload", 2, {0, 1, 0}, identity_matrix()).inertials[0]);
  const Mechanism loaded = make_mechanism(robot);
  EXPECT_TRUE(field_values(derive_function(bare, "regressor"), 3) ==
              field_values(derive_function(loaded, "regressor"), 3));
  const std::vector<Number> before = dynamic_parameters(bare), after = dynamic_parameters(loaded);
  const int last = bare.size() - 1;
  EXPECT_TRUE((after[static_cast<std::size_t>(index_of(last, Parameter::m))] -
               before[static_cast<std::size_t>(index_of(last, Parameter::m))])
                  .is_equal(2));
  for (std::size_t k = 0; k < static_cast<std::size_t>(index_of(last, Parameter::m)); ++k) {
    EXPECT_TRUE(after[k].is_equal(before[k])) << parameter_name(static_cast<int>(k));
  }
}

TEST(Parameters, HaveTheNamesPeopleWrite) {
  EXPECT_EQ(parameter_name(0), "m1");
  EXPECT_EQ(parameter_name(index_of(1, Parameter::mly)), "m2ly");
  EXPECT_EQ(parameter_name(index_of(11, Parameter::Ixz)), "I12xz");
  EXPECT_EQ(parameter_name(index_of(2, Parameter::Im)), "Im3");
}

TEST(Parameters, AnArmatureIsTheInertiaOfARotorWithoutCoupling) {
  Robot robot = testing::random_tree(6, 2, true);
  for (Joint& joint : robot.joints) joint.motor.reset();
  robot.joints[1].armature.number = 3;
  const Mechanism mechanism = make_mechanism(robot);
  const auto place = static_cast<std::size_t>(index_of(1, Parameter::Im));
  EXPECT_TRUE(dynamic_parameters(mechanism)[place].is_equal(3));
  const Function function = derive_function(mechanism, "regressor");
  const auto entry = [&](std::size_t row) { return function.outputs[0].entries[row * 26 + place]; };
  EXPECT_TRUE(function.graph.is_zero(entry(0)));
  EXPECT_EQ(function.graph[entry(1)].op, Op::input);
}

TEST(Parameters, RefuseAMotorAndAnArmatureOnOneJoint) {
  Mechanism mechanism = make_mechanism(testing::random_tree(6, 2, true));
  mechanism.bodies[1].rotor = Rotor{0, 50, 1, {0, 0, 1}};
  mechanism.bodies[1].armature = 1;
  EXPECT_THROW(dynamic_parameters(mechanism), Failure);
}

TEST(Parameters, AreCountedByWhatTheFileGives) {
  Mechanism mechanism = make_mechanism(testing::random_tree(6, 2, true));
  for (Body& body : mechanism.bodies) {
    body.rotor.reset();
    body.armature = body.viscous = body.coulomb = 0;
  }
  mechanism.bodies[1].inertia = {};
  mechanism.bodies[1].viscous = 1;
  const auto count = [&](ParameterSet set) {
    const std::vector<bool> present = parameters_in(mechanism, set);
    return std::count(present.begin(), present.end(), true);
  };
  EXPECT_EQ(count(ParameterSet::inertial), 20);
  EXPECT_EQ(count(ParameterSet::given), 21);
  EXPECT_EQ(count(ParameterSet::full), 26);
  EXPECT_LE(count(ParameterSet::nonzero), 11);
  EXPECT_GT(count(ParameterSet::nonzero), 1);
}

}  // namespace
}  // namespace flatdyn
