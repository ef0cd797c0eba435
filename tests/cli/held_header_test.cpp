// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn verify --header`: code that is held is the robot's, or the statement that is not is named.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char *kArmWithHeader = "robots/planar_2r_example_7_2.toml", *kName = "planar_2r_example_7_2.hpp";

// A robot, and how its code was generated.
struct Held {
  const char *robot, *options, *file;
};

class HeldCode : public ::testing::TestWithParam<Held> {};

TEST_P(HeldCode, IsTheRobotsAsItWasWrittenAndWithoutItsComments) {
  const Scratch scratch;
  const Held& held = GetParam();
  ASSERT_EQ(run_flatdyn(fmt::format("generate {} {} -q -o '{}'", held.robot, held.options, scratch.path())).code, 0);
  const std::string scene = std::string(held.options).find("--scene") == std::string::npos
                                ? ""
                                : " --scene docs/examples/ball_wrist_limits.toml";
  const std::string command = fmt::format("verify {} --header '{}'{}", held.robot, scratch.path(held.file), scene);
  const Outcome outcome = run_flatdyn(command);
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("every function is the robot's, and nothing else is in it"));
  EXPECT_THAT(outcome.out, HasSubstr("the robot's, proven"));
  if (std::string(held.options).find("--fix") != std::string::npos) {
    EXPECT_THAT(outcome.err, HasSubstr("it is compared with the robot by its stamp: --fix=waist=pi/3"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, HeldCode,
    ::testing::Values(
        Held{kArmWithHeader, "", kName}, Held{"robots/finger.toml", "--language c --scalar float", "finger.h"},
        Held{"robots/finger.toml", "--language c", "finger.c"},
        Held{kArmWithHeader, "--form pair --scalar double,float --stages gravity,bias --fuse gravity,bias",
             "planar_2r_example_7_2.cpp"},
        Held{"robots/planar_2r.toml", "--language javascript --name arm", "arm.d.ts"},
        Held{"robots/scara.toml", "--language cuda --functions gravity,bias", "scara.cuh"},
        Held{"robots/rx90.toml", "--max-lines 30 --fma --functions bias,forward_dynamics --namespace my_arm",
             "rx90.hpp"},
        Held{"robots/four_bar.toml", "--sincos library", "four_bar.hpp"},
        Held{"robots/scara.toml", "--frame tool=link4,0.1,0,0,0,0,pi/4 --functions jacobian:tool", "scara.hpp"},
        Held{"docs/examples/ball_wrist.toml",
             "--scene docs/examples/ball_wrist_limits.toml --functions gravity,inertia_matrix --fix waist=pi/3",
             "ball_wrist.hpp"},
        Held{"robots/quadruped12.urdf", "--base floating --functions gravity,kinetic_energy --limbs lanes",
             "quadruped12.hpp"}));

// A header of the planar arm with one change.
class EditedHeader : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Scratch scratch;
    ASSERT_EQ(run_flatdyn(fmt::format("generate {} -q -o '{}' --functions gravity,inverse_dynamics,inertia_matrix",
                                      kArmWithHeader, scratch.path()))
                  .code,
              0);
    original_ = scratch.read(kName);
  }

  void edit(const std::string& before, const std::string& after, const std::string& behind = "") {
    std::string text = original_;
    const std::size_t at = text.find(before, text.find(behind));
    ASSERT_NE(at, std::string::npos) << before;
    line_ = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    scratch_.write(kName, text.replace(at, before.size(), after));
  }

  Outcome verify(const std::string& more = "") const {
    return run_flatdyn(fmt::format("verify {} --header '{}' {}", kArmWithHeader, scratch_.path(kName), more));
  }

  // Expects these words at the line of the edit.
  void expect_refused(const std::string& message) const {
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.code, 5) << outcome.err << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr(fmt::format("{}:{}: error: {}", scratch_.path(kName), line_, message)));
    EXPECT_THAT(outcome.out, HasSubstr(": NOT the robot's as it is"));
  }

  Scratch scratch_;
  int line_ = 0;
  static inline std::string original_;
};

TEST_F(EditedHeader, WithAnotherCoefficientNamesFunctionAndStatement) {
  edit("Scalar(22.5)", "Scalar(22.25)", "void inverse_dynamics");
  expect_refused(
      "inverse_dynamics: \"22.25\" in \"const Scalar N_2_z = Scalar(22.25) * domega_2_z - Scalar(25.0) * (s_2 * "
      "ddp_o_2_x - c_2 * ddp_o_2_y);\" is not the robot's\n    hint: flatdyn writes \"22.5\" in ");
  EXPECT_THAT(verify().out, HasSubstr("NOT the robot's: 2 of 2 entries differ: tau[0], tau[1]"));
}

TEST_F(EditedHeader, WithAnotherIndexNamesIt) {
  edit("tau[1] =", "tau[0] =", "void inverse_dynamics");
  expect_refused("inverse_dynamics: \"0\" in \"tau[0] = qdd_1");
  EXPECT_THAT(verify().out, HasSubstr("NOT the robot's: line "));
}

TEST_F(EditedHeader, WithoutAStatementNamesTheMissingOne) {
  edit("  const Scalar omega_2_z = qd_1 + qd_2;\n", "", "void inverse_dynamics");
  expect_refused("inverse_dynamics: the statement \"const Scalar omega_2_z = qd_1 + qd_2;\" is missing");
}

TEST_F(EditedHeader, WithAStatementMoreNamesIt) {
  edit("  B[3] =", "  B[3] = Scalar(1.0);\n  B[3] =");
  expect_refused("inertia_matrix: the statement \"B[3] = Scalar(1.0);\" is one too many");
}

TEST_F(EditedHeader, WithAnotherConstantOutsideOfFunctionsNamesIt) {
  edit("joint_count = 2", "joint_count = 3");
  expect_refused(
      "\"3\" in \"inline constexpr int joint_count = 3;\" is not the robot's\n    hint: flatdyn writes \"2\"");
  EXPECT_THAT(verify().out, HasSubstr("around the functions, 1 statement is not what flatdyn writes"));
  edit("2.75573137070700676789e-06", "2.75573137070700776789e-06");
  expect_refused("\"2.75573137070700776789e-06\" in \"const Doubles p");
  edit("namespace functions {", "template <> inline void gravity(const double*, double*) {} namespace functions {");
  EXPECT_EQ(verify().code, 5);
}

TEST_F(EditedHeader, WithOtherStatementsThatComputeTheSameIsProven) {
  edit("const Scalar domega_2_z = qdd_1 + qdd_2;", "const Scalar domega_2_z = qdd_2 + qdd_1;", "void inverse_dynamics");
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("the robot's, proven; its statements are others"));
}

TEST_F(EditedHeader, SaysOfEachDifferenceInJson) {
  edit("Scalar(22.5)", "Scalar(22.25)", "void inverse_dynamics");
  const Outcome outcome = verify("--json");
  EXPECT_EQ(outcome.code, 5);
  const nlohmann::json found = nlohmann::json::parse(outcome.out);
  EXPECT_FALSE(found["passed"]);
  EXPECT_EQ(found["differences"][0]["line"], line_);
  EXPECT_EQ(found["differences"][0]["function"], "inverse_dynamics");
  EXPECT_EQ(found["functions"][1]["verdict"], "different");
}

TEST_F(EditedHeader, ThatNoParserCanReadIsNamedByItsLine) {
  edit("  B[3] =", "} }  B[3] =");
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("it is no text that flatdyn writes: "));
  scratch_.write(kName, original_.substr(0, original_.size() / 2));
  EXPECT_EQ(verify().code, 5);
}

TEST_F(EditedHeader, OfAnotherRobotIsRefused) {
  scratch_.write(kName, original_);
  const std::string header = scratch_.path(kName);
  const Outcome other = run_flatdyn(fmt::format("verify robots/planar_2r_absolute.toml --header '{}'", header));
  EXPECT_EQ(other.code, 5) << other.err;
  EXPECT_THAT(other.err, HasSubstr("\"planar_2r_example_7_2\" in \"namespace planar_2r_example_7_2 {\" is not"));
  EXPECT_THAT(other.err, HasSubstr("its stamp names another text of the robot file"));
}

TEST_F(EditedHeader, OfAnotherVersionIsComparedAllTheSame) {
  edit("flatdyn 0", "flatdyn 99.0");
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("functions are compared in exact arithmetic"));
  edit("// Input:", "// Options: --functions gravity --shape round\n// Input:");
  const Outcome unknown = verify();
  EXPECT_EQ(unknown.code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("its stamp is not one of flatdyn"));
}

TEST_F(EditedHeader, WithoutAStampIsRefused) {
  edit("// Generated by flatdyn", "// Made by");
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("its first comment has no stamp of flatdyn"));
  const Outcome nothing =
      run_flatdyn(fmt::format("verify {} --header '{}'", kArmWithHeader, scratch_.path("nothing.hpp")));
  EXPECT_EQ(nothing.code, 6);
}

TEST(HeldHeader, OfASceneAsksForIt) {
  const Scratch scratch;
  const std::string robot = "docs/examples/ball_wrist.toml";
  ASSERT_EQ(run_flatdyn(fmt::format("generate {} --scene docs/examples/ball_wrist_limits.toml --functions gravity -q "
                                    "-o '{}'",
                                    robot, scratch.path()))
                .code,
            0);
  const Outcome outcome = run_flatdyn(fmt::format("verify {} --header '{}'", robot, scratch.path("ball_wrist.hpp")));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("it was written for a scene: "));
  EXPECT_THAT(outcome.err, HasSubstr("add --scene FILE"));
}

}  // namespace
}  // namespace flatdyn::testing
