// SPDX-License-Identifier: GPL-2.0-or-later
// Identities between the functions of one robot, exact, at random points of a prime field.
#include "functions/planning/formulations.hpp"

#include <gtest/gtest.h>

#include "derivation/kernel/regroup.hpp"
#include "graph/mod_p.hpp"
#include "support/robots.hpp"

namespace flatdyn {
namespace {

using Field = ModP<kMersenne61>;

// Arithmetic with random inputs except given joint torques.
struct GivenTorques : ModPArithmetic<> {
  GivenTorques(std::uint64_t seed, std::vector<Field> torques) : ModPArithmetic<>(seed), tau(std::move(torques)) {}
  Field input(const Input& input) const {
    if (input.kind == InputKind::tau && !tau.empty()) return tau[static_cast<std::size_t>(input.index)];
    return ModPArithmetic<>::input(input);
  }
  std::vector<Field> tau;
};

std::vector<Field> values(const Function& function, std::uint64_t seed, const std::vector<Field>& tau = {}) {
  GivenTorques arithmetic(seed, tau);
  const std::vector<Field> all = evaluate(function, arithmetic);
  std::vector<Field> result;
  for (const Output& output : function.outputs) {
    for (const NodeId id : output.entries) result.push_back(all[static_cast<std::size_t>(id)]);
  }
  return result;
}

class RandomRobot : public ::testing::TestWithParam<unsigned> {
 protected:
  RandomRobot() {
    const ModPArithmetic<> arithmetic(seed);
    for (int i = 0; i < mechanism.size(); ++i) {
      qd.push_back(arithmetic.input({InputKind::qd, i}));
      qdd.push_back(arithmetic.input({InputKind::qdd, i}));
    }
  }

  std::vector<Field> value_of(const std::string& name) const { return values(derive_function(mechanism, name), seed); }

  // Row i of a matrix times a vector.
  Field row_times(const std::vector<Field>& matrix, std::size_t i, const std::vector<Field>& vector) const {
    Field sum;
    for (std::size_t j = 0; j < n; ++j) sum += matrix[i * n + j] * vector[j];
    return sum;
  }

  Mechanism mechanism = make_mechanism(testing::random_tree(GetParam(), 6));
  std::size_t n = mechanism.bodies.size();
  std::uint64_t seed = 77 + GetParam();
  std::vector<Field> qd, qdd;
};

TEST_P(RandomRobot, InverseDynamicsIsInertiaPlusBias) {
  const auto tau = value_of("inverse_dynamics"), B = value_of("inertia_matrix"), bias = value_of("bias");
  for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(tau[i] == row_times(B, i, qdd) + bias[i]);
}

TEST_P(RandomRobot, BiasIsCoriolisPlusGravity) {
  for (Body& body : mechanism.bodies) body.viscous = body.coulomb = 0;
  const auto bias = value_of("bias"), C = value_of("coriolis_matrix"), g = value_of("gravity");
  for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(bias[i] == row_times(C, i, qd) + g[i]);
}

TEST_P(RandomRobot, CoriolisMatrixIsChristoffelSymbolsTimesRates) {
  const auto c = value_of("christoffel"), C = value_of("coriolis_matrix");
  const std::size_t columns = n * (n + 1) / 2;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      Field sum;
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t low = std::min(j, k), high = std::max(j, k);
        sum += c[i * columns + high * (high + 1) / 2 + low] * qd[k];
      }
      EXPECT_TRUE(sum == C[i * n + j]);
    }
  }
}

TEST_P(RandomRobot, ForwardDynamicsUndoesInverseDynamics) {
  const Function forward = derive_function(mechanism, "forward_dynamics");
  EXPECT_TRUE(values(forward, seed, value_of("inverse_dynamics")) == qdd);
  EXPECT_GE(forward.validity_conditions.size(), n);  // more if pivots can overflow
}

TEST_P(RandomRobot, KineticEnergyIsTheQuadraticFormOfB) {
  const auto T = value_of("kinetic_energy"), B = value_of("inertia_matrix");
  Field twice;
  for (std::size_t i = 0; i < n; ++i) twice += qd[i] * row_times(B, i, qd);
  EXPECT_TRUE(T[0] + T[0] == twice);
}

TEST_P(RandomRobot, RegroupingChangesNothing) {
  for (const char* name : {"inverse_dynamics", "christoffel", "potential_energy", "inertia_matrix"}) {
    const auto expected = value_of(name);
    for (const Grouping grouping : kGroupings) {
      EXPECT_TRUE(values(derive_function(regrouped(mechanism, grouping), name), seed) == expected) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRobot, ::testing::Range(1u, 7u));

TEST(Regrouped, LeavesMassOnlyWithTheBaseAndPrismaticLinks) {
  const Mechanism mechanism = regrouped(make_mechanism(testing::random_tree(4, 6, true)), Grouping::i_yy);
  for (const Body& body : mechanism.bodies) {
    if (body.prismatic) continue;
    EXPECT_TRUE(body.inertia.mass.is_zero());
    EXPECT_TRUE(vanishes(body.inertia.first_moment[2]));
    EXPECT_TRUE(vanishes(body.inertia.inertia[1][1]));
  }
}

TEST(DeriveFunction, NamesOfFunctionsAndLinksAreChecked) {
  const Mechanism mechanism = make_mechanism(testing::random_tree(1, 3));
  EXPECT_THROW(derive_function(mechanism, "inverse_dynamic"), Failure);
  EXPECT_THROW(derive_function(mechanism, "jacobian:nowhere"), Failure);
  EXPECT_THROW(derive_function(mechanism, "gravity:link1"), Failure);
  EXPECT_EQ(derive_function(mechanism, "jacobian:link1").outputs[0].rows, 6);
}

TEST(DeriveFunction, TheSameMechanismGivesTheSameGraph) {
  const auto graph_of = [](int padding) {
    std::vector<GiNaC::symbol> moved(static_cast<std::size_t>(padding));  // shifts GiNaC's serial numbers
    return derive_function(make_mechanism(testing::random_tree(2, 5)), "forward_dynamics").graph;
  };
  const Graph a = graph_of(0), b = graph_of(17);
  ASSERT_EQ(a.size(), b.size());
  for (NodeId id = 0; id < a.size(); ++id) ASSERT_TRUE(a[id] == b[id]);
}

}  // namespace
}  // namespace flatdyn
