// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of base parameters against the others, exactly, and their cost.
#include "derivation/parameters/regressor_functions.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "derivation/dynamics/centres.hpp"
#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "functions/planning/formulations.hpp"
#include "graph/count.hpp"
#include "graph/mod_p.hpp"
#include "graph/passes/passes.hpp"
#include "robot/model/field_mechanism.hpp"
#include "support/floating_robots.hpp"
#include "support/robot_models.hpp"
#include "support/robots.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

using Field = ModP<kMersenne61>;

// Arithmetic with random inputs except given base parameters and, if asked for, reference rates equal to the rates.
struct GivenParameters : ModPArithmetic<> {
  GivenParameters(const Mechanism& mechanism, const std::vector<Field>& values, bool same)
      : ModPArithmetic<>(ModPArithmetic<>(11).with_quaternions(mechanism.quaternions())),
        pi_b(values),
        same_rates(same) {}
  Field input(const Input& input) const {
    if (input.kind == InputKind::pi_b) return pi_b[static_cast<std::size_t>(input.index)];
    static const std::map<InputKind, InputKind> actual = {{InputKind::qd_r, InputKind::qd},
                                                          {InputKind::qdd_r, InputKind::qdd},
                                                          {InputKind::v_r, InputKind::v},
                                                          {InputKind::a_r, InputKind::a}};
    const auto found = actual.find(input.kind);
    if (same_rates && found != actual.end()) return ModPArithmetic<>::input({found->second, input.index});
    return ModPArithmetic<>::input(input);
  }
  std::vector<Field> pi_b;
  bool same_rates;
};

class FunctionsOfMechanism {
 protected:
  explicit FunctionsOfMechanism(Mechanism of) : mechanism(std::move(of)), n(mechanism.bodies.size()) {
    for (const Number& value : base_values(mechanism, base_parameters(mechanism))) {
      pi_b.push_back(Field::from(to_rational(value)));
    }
  }

  std::vector<Field> values(const std::string& name, bool same_rates = false) const {
    const Function function = derive_function(mechanism, name);
    GivenParameters arithmetic(mechanism, pi_b, same_rates);
    const std::vector<Field> all = evaluate(function, arithmetic);
    std::vector<Field> result;
    for (const NodeId id : function.outputs[0].entries) result.push_back(all[static_cast<std::size_t>(id)]);
    return result;
  }

  Field input(InputKind kind, std::size_t i) const {
    return GivenParameters(mechanism, pi_b, false)
        .input({with_base(kind, mechanism.has_quasi_velocities()), static_cast<int>(i)});
  }

  static Field row_times(const std::vector<Field>& matrix, std::size_t i, const std::vector<Field>& x) {
    Field sum;
    for (std::size_t k = 0; k < x.size(); ++k) sum += matrix[i * x.size() + k] * x[k];
    return sum;
  }

  // B q̈_r + C(q, q̇) q̇_r + g with the emitted C; friction acts on q̇_r.
  void expect_consistency_with_C() const {
    const std::vector<Field> B = values("inertia_matrix"), C = values("coriolis_matrix"), g = values("gravity"),
                             Y = values("adaptive_regressor");
    const GivenParameters arithmetic(mechanism, pi_b, false);
    for (std::size_t i = 0; i < n; ++i) {
      const Body& body = mechanism.bodies[i];
      const Field rate = input(InputKind::qd_r, i);
      Field torque = g[i] + Field::from(to_rational(body.viscous)) * rate +
                     Field::from(to_rational(body.coulomb)) * arithmetic.sign(rate);
      for (std::size_t k = 0; k < n; ++k) {
        torque += B[i * n + k] * input(InputKind::qdd_r, k) + C[i * n + k] * input(InputKind::qd_r, k);
      }
      EXPECT_TRUE(row_times(Y, i, pi_b) == torque) << "row " << i;
    }
  }

  Mechanism mechanism;
  std::size_t n;
  std::vector<Field> pi_b;
};

class BaseFunctions : public FunctionsOfMechanism, public ::testing::TestWithParam<unsigned> {
 protected:
  BaseFunctions() : FunctionsOfMechanism(make_mechanism(testing::random_tree(GetParam(), 6))) {}
};

TEST_P(BaseFunctions, GiveTheTorque) {
  const std::vector<Field> tau = values("inverse_dynamics"), Y = values("base_regressor");
  EXPECT_TRUE(values("inverse_dynamics_base") == tau);
  EXPECT_TRUE(values("base_parameters") == pi_b);
  for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(row_times(Y, i, pi_b) == tau[i]);
}

TEST_P(BaseFunctions, AdaptiveRegressorIsTheRegressorAtEqualRates) {
  EXPECT_TRUE(values("adaptive_regressor", true) == values("base_regressor"));
}

TEST_P(BaseFunctions, AdaptiveRegressorIsConsistentWithC) { expect_consistency_with_C(); }

// The same in velocities that are not the derivatives of coordinates.
struct FreeFunctions : FunctionsOfMechanism {
  explicit FreeFunctions(const LoadedRobot& model) : FunctionsOfMechanism(model.mechanism) {}
  void expect_adaptive_regressor() const {
    EXPECT_TRUE(values("adaptive_regressor", true) == values("base_regressor"));
    expect_consistency_with_C();
  }
};

// A waist whose three axes meet on the base's z axis: forces on its links have no moment about that axis.
constexpr const char* kWaist = R"(name = "waist"
[base]
motion = "floating"
mass = 8
com = [0.1, -0.2, 0.05]
inertia = { xx = 2, yy = 3, zz = 2.5 }
inertia_about = "com"
[[link]]
joint = "yaw"
xyz = [0, 0, 0.2]
axis = [0, 0, 1]
mass = 1
inertia = { xx = 1, yy = 1, zz = 1 }
inertia_about = "com"
[[link]]
joint = "pitch"
axis = [0, 1, 0]
mass = 1
inertia = { xx = 1, yy = 1, zz = 1 }
inertia_about = "com"
[[link]]
joint = "roll"
axis = [1, 0, 0]
mass = 2
com = [0.1, 0.2, 0.3]
inertia = { xx = 1, yy = 1, zz = 1 }
inertia_about = "com"
)";

// In doubles, terms that cancel would leave a rounding error where the entry is zero.
TEST(Regressor, HasNoOperationsWhereItIsAlwaysZero) {
  const Mechanism mechanism = testing::model_of_toml(kWaist).mechanism;
  const Function function = derive_function(mechanism, "regressor");
  ModPArithmetic<> arithmetic(7);
  const std::vector<Field> values = evaluate(function, arithmetic);
  int zeros = 0;
  for (const NodeId entry : function.outputs[0].entries) {
    if (values[static_cast<std::size_t>(entry)] != Field()) continue;
    EXPECT_TRUE(function.graph.is_zero(entry));
    ++zeros;
  }
  EXPECT_GT(zeros, 0);
}

TEST(AdaptiveRegressor, IsConsistentWithCOfAFloatingBase) {
  FreeFunctions(testing::model_of_toml(testing::kSatellite)).expect_adaptive_regressor();
}

TEST(AdaptiveRegressor, IsConsistentWithCOfSphericalJoints) {
  const auto file = std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs/examples/ball_wrist.toml";
  FreeFunctions(load_robot(file, {})).expect_adaptive_regressor();
}

// With the springs that the mechanism has: their torques are Y_s π_s.
TEST_P(BaseFunctions, SpringRegressorGivesTheTorquesOfSprings) {
  const std::vector<Field> without = values("inverse_dynamics");
  std::vector<Field> pi_s;
  for (std::size_t i = 0; i < n; ++i) {
    mechanism.bodies[i].stiffness = Number(static_cast<int>(i + 2)) / 7;
    mechanism.bodies[i].spring_reference = Number(3) / static_cast<int>(i + 1);
    for (const Number& each : {mechanism.bodies[i].stiffness,
                               Number(mechanism.bodies[i].stiffness * mechanism.bodies[i].spring_reference)}) {
      pi_s.push_back(Field::from(to_rational(each)));
    }
  }
  const std::vector<Field> with = values("inverse_dynamics"), Y = values("spring_regressor");
  ASSERT_EQ(Y.size(), n * pi_s.size());
  for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(without[i] + row_times(Y, i, pi_s) == with[i]) << "joint " << i;
}

INSTANTIATE_TEST_SUITE_P(Seeds, BaseFunctions, ::testing::Range(1u, 9u));

int operations(const std::string& robot, const std::string& function) {
  return count_operations(run_passes(derive_function(testing::model_of(robot).mechanism, function))).arithmetic();
}

// The best of the peers needs 988 for the UR5 and 1341 for the Panda.
TEST(BaseRegressor, CostsFewOperations) {
  EXPECT_LE(operations("ur5.urdf", "base_regressor"), 580);
  EXPECT_LE(operations("panda.urdf", "base_regressor"), 1115);
  EXPECT_LE(operations("puma560.toml", "base_regressor"), 690);
  EXPECT_LE(operations("rx90.toml", "base_regressor"), 640);
}

TEST(Centres, AreWhereThreeAxesMeet) {
  const Mechanism mechanism = testing::model_of("panda.urdf").mechanism;
  DerivationContext context(mechanism);
  Centres centres(context.frames);
  for (const int shoulder : {0, 1, 2}) EXPECT_EQ(centres.centre_of(shoulder), 0);
  for (const int other : {3, 4, 5, 6}) EXPECT_EQ(centres.centre_of(other), -1);
  const Vec3 elbow = centres.lever(0, 2);  // along the third axis
  EXPECT_TRUE(elbow[0].is_zero() && elbow[1].is_zero());
  EXPECT_TRUE(elbow[2].is_equal(GiNaC::numeric(316, 1000)));
}

}  // namespace
}  // namespace flatdyn
