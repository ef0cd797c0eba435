// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/peers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <sstream>

#include "robot/model/random_robot.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Toolchain with_everything() {
  Toolchain toolchain;
  toolchain.has_eigen = toolchain.has_kdl = toolchain.has_mujoco = toolchain.has_dart = true;
  toolchain.peers_folder = "peers";
  return toolchain;
}

Mechanism tree() { return make_mechanism(random_robot(false, 3, 1)); }

TEST(Peers, AllThatThereMayBeKnowAPlainChain) {
  const BenchPeers peers = find_peers(with_everything(), make_mechanism(random_robot(true, 3, 1)));
  EXPECT_THAT(peers.found, SizeIs(std::size(kBenchPeers)));
  EXPECT_THAT(peers.left_out, IsEmpty());
}

TEST(Peers, AllButKdlKnowAFloatingBase) {
  RandomHundredths draw(1);
  Robot robot = random_robot(false, 3, 1);
  robot.links[0] = random_link(draw, "base");
  robot.floating_base = true;
  EXPECT_THAT(find_peers(with_everything(), make_mechanism(robot)).left_out, ElementsAre("KDL: its base is fixed"));
}

TEST(Peers, WhatIsNotInstalledIsLeftOutWithItsPackage) {
  const BenchPeers peers = find_peers(Toolchain(), tree());
  EXPECT_THAT(peers.found, IsEmpty());
  for (const char* line :
       {"reference: it is not installed (libeigen3-dev)", "KDL: it is not installed (liborocos-kdl-dev)",
        "MuJoCo: it is not installed (libmujoco-dev)", "DART: it is not installed (libdart-dev)",
        "Pinocchio: it is not installed (scripts/bench --peers)",
        "CasADi: it is not installed (scripts/bench --peers)"}) {
    EXPECT_THAT(peers.left_out, Contains(line));
  }
}

TEST(Peers, WhatAPeerHasNoWordForLeavesItOut) {
  Mechanism mechanism = tree();
  mechanism.bodies[1].armature = 1;
  EXPECT_THAT(find_peers(with_everything(), mechanism).left_out, Contains("DART: it knows no armature"));
  mechanism.bodies[1].viscous = 1;
  EXPECT_THAT(find_peers(with_everything(), mechanism).left_out, Contains("MuJoCo: its friction is another one"));
  EXPECT_THAT(find_peers(with_everything(), mechanism).left_out, Contains("Pinocchio: its friction is another one"));
  mechanism.bodies[1].armature = 0;
  EXPECT_THAT(find_peers(with_everything(), mechanism).left_out, Contains("DART: its friction is another one"));
}

// A base and a link whose numbers are exact: the format of tests/benchmark/pinocchio/mechanism.hpp.
TEST(Peers, AMechanismForPinocchioHasALineForEachLink) {
  Mechanism mechanism = tree();
  mechanism.bodies.resize(1);
  Body& body = mechanism.bodies[0];
  body.parent = -1;
  body.armature = Number(1) / 4;
  std::istringstream lines(mechanism_file(mechanism, {}));
  std::string head, link;
  std::getline(lines, head);
  std::getline(lines, link);
  EXPECT_THAT(head, ::testing::StartsWith("1 0 "));
  EXPECT_THAT(link, ::testing::AllOf(::testing::StartsWith("-1 0 0 "), ::testing::EndsWith(" 0.25")));
  std::istringstream numbers(link);
  EXPECT_EQ(std::distance(std::istream_iterator<double>(numbers), {}), 3 + 9 + 3 + 1 + 3 + 9 + 1);
}

}  // namespace
}  // namespace flatdyn::testing
