// SPDX-License-Identifier: GPL-2.0-or-later
// The accuracy that the README promises: the compiled text of real robots against 50 digits.
#include <gtest/gtest.h>

#include "functions/planning/make_functions.hpp"
#include "proof/verify/verify.hpp"

namespace flatdyn {
namespace {

constexpr const char* kRobots = FLATDYN_SOURCE_DIR "/robots/";

VerifyReport report_of(const std::string& robot, const std::vector<std::string>& functions) {
  PipelineOptions options;
  options.functions = functions;
  const LoadedRobot model = load_robot(kRobots + robot, options);
  Progress quiet(true);
  Diagnostics left_out;
  const std::vector<Function> made = functions_of(make_functions(model, options, quiet, left_out));
  return verify(model.robot, model.mechanism, made, {}, quiet);
}

class ScaledError : public ::testing::TestWithParam<const char*> {};

// The bounds are 16 units, and 0.6 units above the reference in double. Different sets of random states differ by a
// tenth; the rest is for sines and cosines of sums of parallel joints' angles, which are rounded more often than those
// of the angles.
TEST_P(ScaledError, IsSmallAndNotWorseThanTheReferences) {
  constexpr double kMore = 0.6;
  const VerifyReport report =
      report_of(GetParam(), {"inverse_dynamics", "inertia_matrix", "christoffel", "gravity", "bias", "forward_dynamics",
                             "kinetic_energy", "potential_energy", "forward_kinematics", "jacobian"});
  ASSERT_EQ(report.functions.size(), 10u);
  for (const FunctionReport& f : report.functions) {
    EXPECT_LE(f.generated.largest, 16) << f.function;
    EXPECT_LE(f.generated.percentile_99, f.reference.percentile_99 + kMore) << f.function;
    EXPECT_LE(f.at_edges.largest, 16) << f.function;
    EXPECT_LT(f.graph_error, 1e-35) << f.function;
  }
  EXPECT_TRUE(report.passed()) << to_text(report);
}

INSTANTIATE_TEST_SUITE_P(Robots, ScaledError,
                         ::testing::Values("pendulum_motor.toml", "cartesian_2.toml", "planar_2r.toml",
                                           "prismatic_revolute.toml", "scara.toml", "puma560.toml", "ur5.urdf",
                                           "panda.urdf"),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

}  // namespace
}  // namespace flatdyn
