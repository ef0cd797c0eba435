// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/base_constants.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "code/languages/emit.hpp"
#include "functions/planning/formulations.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string header(const std::string& robot, const std::string& function,
                   ParameterFrames frames = ParameterFrames::file) {
  const Mechanism mechanism = testing::model_of(robot).mechanism;
  EmitOptions options;
  options.frames = frames;
  return emit_header(mechanism, {derive_function(mechanism, function)}, options);
}

TEST(BaseConstants, AreNamesCombinationsAndValues) {
  const std::string text = header("planar_2r_example_7_2.toml", "inverse_dynamics_base");
  EXPECT_THAT(text, HasSubstr("inline constexpr int base_parameter_count = 7;"));
  EXPECT_THAT(text, HasSubstr("\"m1lx\", \"m1ly\", \"I1zz\", \"m2lx\", \"m2ly\", \"I2zz\", \"Im2\"};"));
  EXPECT_THAT(text, HasSubstr("// link frames of the robot file: m(L) is the mass of link L,"));
  EXPECT_THAT(text, HasSubstr("//   pi_b[0] = mlx(link1) + m(link1) + m(link2)\n"));
  EXPECT_THAT(text, HasSubstr("Real(80.0), Real(0.0)"));
  EXPECT_THAT(text, HasSubstr("const Scalar* pi_b"));
  EXPECT_THAT(text, HasSubstr("pi_b[7]"));
}

TEST(BaseConstants, HaveNoValuesWhereTheRobotHasSymbols) {
  const std::string text = header("planar_2r.toml", "base_regressor");
  EXPECT_THAT(text, HasSubstr("//   pi_b[0] = mlx(link1) + a_1 m(link1) + a_1 m(link2)\n"));
  EXPECT_THAT(text, HasSubstr("base_parameter_names"));
  EXPECT_THAT(text, Not(HasSubstr("base_parameter_values")));
}

TEST(BaseConstants, AreInCanonicalFramesOnRequest) {
  const std::string text = header("planar_2r.toml", "base_regressor", ParameterFrames::canonical);
  EXPECT_THAT(text, HasSubstr("// canonical frames (z along the joint's axis)"));
  EXPECT_THAT(text, HasSubstr("//   pi_b[0] = m1lx + a_1 m2\n"));
}

TEST(BaseConstants, StayAwayFromOtherFunctions) {
  EXPECT_THAT(header("planar_2r.toml", "gravity"), Not(HasSubstr("base_parameter")));
  EXPECT_THAT(header("planar_2r.toml", "regressor"), Not(HasSubstr("base_parameter")));
}

}  // namespace
}  // namespace flatdyn
