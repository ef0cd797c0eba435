// SPDX-License-Identifier: GPL-2.0-or-later
// --frames: base parameters are combinations of the parameters of the file's links, or of canonical ones on request,
// and every output says which.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Standard DH: the frames of its links are not the canonical ones.
constexpr const char* kArm = "robots/planar_2r_example_7_2.toml";
constexpr const char* kCanonical = " --frames canonical";

const auto kSaysFile = AllOf(HasSubstr("mlx(link1) + m(link1) + m(link2)"), HasSubstr("link frames of the robot file"));
const auto kSaysCanonical = AllOf(HasSubstr("m1lx + m2"), HasSubstr("canonical frames (z along the joint"));

std::string output_of(const std::string& command) {
  const Outcome outcome = run_flatdyn(command);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

TEST(Frames, AreThoseOfTheFileInInspect) {
  const std::string inspect = fmt::format("inspect {} -q --base-parameters", kArm);
  EXPECT_THAT(output_of(inspect), kSaysFile);
  EXPECT_THAT(output_of(inspect), HasSubstr("link link1, moved by theta_1\n  m = 55 kg, m r = (-25, 0, 0) kg m"));
  EXPECT_THAT(output_of(inspect + kCanonical), kSaysCanonical);
  const json in_file = json::parse(output_of(inspect + " --json"));
  EXPECT_EQ(in_file.at("frames"), "file");
  EXPECT_EQ(in_file.at("base_parameters")[0].at("combination"), "m1lx + m2");
  EXPECT_EQ(in_file.at("base_parameters")[0].at("file_combination"), "mlx(link1) + m(link1) + m(link2)");
  const json canonical = json::parse(output_of(inspect + " --json" + kCanonical));
  EXPECT_EQ(canonical.at("frames"), "canonical");
  EXPECT_FALSE(canonical.at("base_parameters")[0].contains("file_combination"));
}

TEST(Frames, AreThoseOfTheFileInReportsOfAnIdentification) {
  const Scratch scratch;
  write_log(scratch.path("log.csv"), simulated(model_of("planar_2r_example_7_2.toml"), {.samples = 500}));
  const std::string identify = fmt::format("identify {} --data {}", kArm, scratch.path("log.csv"));
  EXPECT_THAT(output_of(identify), AllOf(kSaysFile, HasSubstr("\nm1lx  80 ")));
  EXPECT_THAT(output_of(identify + kCanonical), AllOf(kSaysCanonical, HasSubstr("\nm1lx  80 ")));
  const json in_file = json::parse(output_of(identify + " --json"));
  EXPECT_EQ(in_file.at("frames"), "file");
  EXPECT_EQ(in_file.at("base_parameters")[0].at("combination"), "m1lx + m2");
  EXPECT_EQ(in_file.at("base_parameters")[0].at("file_combination"), "mlx(link1) + m(link1) + m(link2)");
}

TEST(Frames, AreThoseOfTheFileInHeaders) {
  const std::string generate = fmt::format("generate {} -q --functions base_regressor -o -", kArm);
  EXPECT_THAT(output_of(generate), AllOf(kSaysFile, Not(HasSubstr("--frames canonical\n"))));
  EXPECT_THAT(output_of(generate + kCanonical), AllOf(kSaysCanonical, HasSubstr("--frames canonical\n")));
}

TEST(Frames, AreThoseOfTheFileOnPages) {
  const Scratch scratch;
  const std::string report = fmt::format("report {} -q -o {}", kArm, scratch.path("page.html"));
  output_of(report);
  EXPECT_THAT(scratch.read("page.html"), kSaysFile);
  output_of(report + kCanonical);
  EXPECT_THAT(scratch.read("page.html"), kSaysCanonical);
}

TEST(Frames, AreThoseOfTheFileInExcite) {
  const Scratch scratch;
  const std::string excite = fmt::format("excite {} --evaluations 10 --duration 2 -o {}", kArm, scratch.path());
  EXPECT_THAT(output_of(excite), HasSubstr("in the link frames of the robot file: m(L)"));
  EXPECT_THAT(output_of(excite + kCanonical), HasSubstr("in canonical frames (z along"));
  const json weakest = json::parse(output_of(excite + " --json")).at("weakest")[0];
  EXPECT_TRUE(weakest.contains("combination") && weakest.contains("file_combination")) << weakest;
}

TEST(Frames, HaveTwoNames) { EXPECT_EQ(run_flatdyn(fmt::format("inspect {} --frames dh", kArm)).code, 2); }

}  // namespace
}  // namespace flatdyn::testing
