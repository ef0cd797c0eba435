// SPDX-License-Identifier: GPL-2.0-or-later
// --frame, and [[frame]] of a scene: frames that are fixed to links, and are links to everything else.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr int kUsage = 2;

std::string evaluated(const std::string& function, const std::string& options) {
  const Outcome outcome = run_flatdyn(fmt::format(
      "eval -q robots/panda.urdf --function {} --states docs/examples/panda_states.csv {}", function, options));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

// The hand's tool centre point is a link of the file: 0.1034 m from the hand along z.
TEST(AddedFrames, AreWhereALinkOfTheFileIs) {
  const std::string tool = "--frame tool=panda_hand,0,0,0.1034";
  for (const char* function : {"forward_kinematics", "jacobian"}) {
    EXPECT_EQ(evaluated(fmt::format("{}:tool", function), tool),
              evaluated(fmt::format("{}:panda_hand_tcp", function), ""));
  }
  EXPECT_EQ(evaluated("jacobian", tool + " --tip tool"), evaluated("jacobian", "--tip panda_hand_tcp"));
}

TEST(AddedFrames, AreProven) {
  const Outcome outcome = run_flatdyn(
      "verify -q --json --states 4 robots/ur5.urdf --frame tool=wrist_3_link,0.1,0,1/7,pi/2,0,1.5707963 "
      "--frame tip_of_tool=tool,0,0.05,0 --functions "
      "forward_kinematics:tool,jacobian:tip_of_tool,frame_velocity:tip_of_tool,frame_acceleration:tool");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const json& function : json::parse(outcome.out)["functions"]) EXPECT_TRUE(function["proven"]) << function;
}

TEST(AddedFrames, OfASceneLeaveTheTipWhereItIs) {
  const Scratch scratch;
  scratch.write("scene.toml",
                "angles = \"deg\"\n[[frame]]\nname = \"tool\"\nlink = \"panda_hand\"\nxyz = [0, 0, 0.1034]\n"
                "rpy = [0, 0, 90]\n");
  const std::string scene = "--scene " + scratch.path("scene.toml");
  const Outcome outcome = run_flatdyn("inspect -q --json robots/panda.urdf " + scene);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["tip"], "panda_hand_tcp");
  EXPECT_EQ(evaluated("forward_kinematics:tool", scene),
            evaluated("forward_kinematics:tool", "--frame tool=panda_hand,0,0,0.1034,0,0,pi/2"));
  EXPECT_EQ(evaluated("forward_kinematics:tool", scene),
            evaluated("forward_kinematics:tool", "--frame 'tool = panda_hand, 0, 0, 0.1034, 0, 0, 90deg'"));
}

TEST(AddedFrames, ThatAreNoneAreSaid) {
  const auto refused = [](const std::string& frame, const char* text) {
    const Outcome outcome = run_flatdyn(fmt::format("inspect robots/panda.urdf --frame '{}'", frame));
    EXPECT_EQ(outcome.code, kUsage) << frame;
    EXPECT_THAT(outcome.err, HasSubstr(text)) << frame;
  };
  for (const char* frame : {"tool", "tool=panda_hand", "=panda_hand,0,0,0", "tool=,0,0,0", "tool=panda_hand,0,0",
                            "tool=panda_hand,0,0,0,0", "tool=panda_hand,0,0,0,"}) {
    refused(frame, "is no frame");
  }
  refused("a,b=panda_hand,0,0,0", "comma");
  refused(" =panda_hand,0,0,0", "its name is empty");
  refused("a --tip b=panda_hand,0,0,0", "looks like an option");
  refused("tool=panda_hand,0,0,up", "is a symbol, which only a file may have");
  refused("tool=panda_hnd,0,0,0", "panda_hand");
  refused("panda_hand=panda_link7,0,0,0", "has this name");
}

TEST(AddedFrames, BehindTheTipCannotBeConvertedToAFormatWithoutOne) {
  const Scratch scratch;
  const std::string convert = "convert -q robots/panda.urdf --frame tool=panda_hand,0,0,1 -o ";
  const Outcome outcome = run_flatdyn(convert + scratch.path("a.urdf"));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("a robot with another tip"));
  EXPECT_EQ(run_flatdyn(convert + scratch.path("a.toml")).code, 0);
}

}  // namespace
}  // namespace flatdyn::testing
