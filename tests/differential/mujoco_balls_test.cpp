// SPDX-License-Identifier: GPL-2.0-or-later
// Ball joints of MJCF texts as flatdyn reads them against MuJoCo itself.
#include "support/mujoco_peer.hpp"

namespace flatdyn::mujoco_peer {
namespace {

// An arm, on it a ball off its body's origin, behind that a hinge and another ball in one body.
constexpr const char* kArmWithBalls = R"(<body name="arm" pos="0 .1 .2" euler="10 20 30"><joint axis="0 1 0"/>
    <geom type="capsule" size=".05 .2" pos=".1 0 0"/>
    <body name="hand" pos=".4 0 .1" euler="0 40 5">
      <joint name="wrist" type="ball" pos=".02 .03 -.01" damping=".4"/>
      <geom type="box" size=".1 .2 .05" pos=".05 .1 0"/>
      <body name="finger" pos="0 .2 0"><joint axis="1 0 1" damping=".2"/><joint type="ball" pos="0 .01 0"/>
        <geom type="ellipsoid" size=".03 .04 .1" pos="0 .02 .1"/></body>
      <body name="thumb" pos="0 -.2 0" euler="3 0 70"><joint type="slide" axis="1 0 0"/><geom size=".05"/></body>
    </body></body>)";

TEST_F(MujocoFiles, BallsTurnAsInMujoco) {
  compare_text(fmt::format("<mujoco><worldbody>{}</worldbody></mujoco>", kArmWithBalls));
}

TEST_F(MujocoFiles, BallsTurnOnAFreeBodyAsInMujoco) {
  compare_text(fmt::format(R"(<mujoco><worldbody><body name="trunk"><freejoint/>
      <geom type="box" size=".3 .2 .1" pos=".01 .02 0"/>{}</body></worldbody></mujoco>)",
                           kArmWithBalls));
}

}  // namespace
}  // namespace flatdyn::mujoco_peer
