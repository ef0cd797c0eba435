// SPDX-License-Identifier: GPL-2.0-or-later
// Copies, attached models, meshes and settings of MJCF texts as flatdyn reads them against MuJoCo itself.
#include "support/mujoco_peer.hpp"

namespace flatdyn::mujoco_peer {
namespace {

TEST_F(MujocoFiles, CopiesStandWhereMujocoPutsThem) {
  compare_text(R"(<mujoco><default><joint damping=".3"/></default><worldbody>
    <body name="hub"><joint name="h" axis="1 0 1"/><geom size=".1"/>
      <replicate count="3" offset=".4 .1 0" euler="10 20 30" sep="-">
        <body name="a" pos="0 .5 0"><joint name="j" axis="0 1 0"/><geom type="box" size=".1 .2 .3"/>
          <body name="b" pos="0 0 .3"><joint name="k"/><geom size=".1" pos=".1 0 0"/></body></body>
      </replicate></body></worldbody>
    <actuator><motor joint="j" armature=".5" gear="2"/></actuator>
    <equality><joint joint1="k" joint2="j" polycoef="0 .5 0 0 0"/></equality></mujoco>)");
}

TEST_F(MujocoFiles, CopiesOfCopiesStandWhereMujocoPutsThem) {
  compare_text(R"(<mujoco><default><default class="q"><joint damping="4"/></default></default><worldbody>
    <body name="hub"><joint name="h" axis="1 0 0"/><geom size=".1"/><frame pos="0 0 .5">
      <replicate count="2" offset=".3 0 0" sep="-" childclass="q"><frame pos="0 0 .1">
        <replicate count="3" euler="0 0 40"><body name="a" pos="0 .5 0"><joint name="j" axis="0 1 0"/>
          <geom type="capsule" size=".1 .2" pos=".1 .2 0"/></body></replicate></frame>
        <geom name="g" size=".2"/></replicate></frame></body></worldbody></mujoco>)");
}

TEST_F(MujocoFiles, AttachedModelsMoveAsInMujoco) {
  add_file("arm.xml", R"(<mujoco model="arm"><default><joint damping="2" armature=".3"/>
    <default class="k"><joint armature=".5"/></default></default>
    <worldbody><geom size=".1"/><body name="base" childclass="k" pos="0 0 1"><geom size=".1" pos=".1 0 0"/>
      <joint name="j" axis="1 1 0"/><body name="tip" pos="1 0 0" euler="17 0 0"><geom type="box" size=".1 .2 .3"/>
        <joint name="i" axis="0 1 0"/></body></body></worldbody>
    <actuator><motor joint="j" armature=".1" gear="3"/></actuator>
    <equality><joint joint1="j" joint2="i"/></equality></mujoco>)");
  compare_text(R"(<mujoco><asset><model name="s" file="arm.xml"/></asset>
    <default><joint damping="7" frictionloss="3"/></default>
    <worldbody><body name="hub" euler="10 0 0"><joint name="h" axis="0 1 0"/><geom size=".1"/>
      <frame pos="0 0 .4" euler="0 20 0"><attach model="s" prefix="l_"/></frame>
      <attach model="s" body="tip" prefix="r_"/></body></worldbody></mujoco>)");
}

using MeshPoint = std::array<float, 3>;
using MeshTriangle = std::array<MeshPoint, 3>;

// An L of plates, whose centroid does not see all of its faces.
std::vector<MeshTriangle> bracket_of_plates() {
  const std::vector<std::array<float, 2>> outline = {{0, 0}, {3, 0}, {3, .25}, {.25, .25}, {.25, 4}, {0, 4}};
  const float thick = .5;
  const auto at = [&](std::size_t i, float z) { return MeshPoint{outline[i][0], outline[i][1], z}; };
  std::vector<MeshTriangle> triangles;
  for (const auto& [a, b, c] : std::vector<std::array<std::size_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    triangles.push_back({at(a, thick), at(b, thick), at(c, thick)});
    triangles.push_back({at(a, 0), at(c, 0), at(b, 0)});
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    triangles.push_back({at(i, 0), at(j, 0), at(j, thick)});
    triangles.push_back({at(i, 0), at(j, thick), at(i, thick)});
  }
  return triangles;
}

std::string binary_stl(const std::vector<MeshTriangle>& triangles) {
  std::string bytes(80, ' ');
  const auto add = [&bytes](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  add(static_cast<std::uint32_t>(triangles.size()));
  for (const MeshTriangle& triangle : triangles) {
    add(MeshPoint{});
    add(triangle);
    add(std::uint16_t{0});
  }
  return bytes;
}

constexpr const char* kPyramid = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf -3 -2 -1\n";
constexpr const char* kOpenPyramid = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";
constexpr const char* kPrism =  // whose quadrilaterals are not plane
    "o prism\nv 0 0 0\nv 0 0 3\nv 0 2 0\nv 0 2 3.5\nv 1 0 0\nv 1 0 3\nv 1 2 0\nv 1.25 2 3\n"
    "f 1 2 4 3\nf 5/1 7/1 8/1 6/1\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";

TEST_F(MujocoFiles, MeshesHaveMujocosInertia) {
  add_file("bracket.stl", binary_stl(bracket_of_plates()));
  add_file("pyramid.obj", kPyramid);
  add_file("open.obj", kOpenPyramid);
  add_file("prism.obj", kPrism);
  std::string meshes, bodies;
  int k = 0;
  for (const char* mesh :
       {R"(file="bracket.stl")", R"(file="bracket.stl" inertia="exact")", R"(file="pyramid.obj")",
        R"(file="pyramid.obj" inertia="exact" scale="1 -2 3")",
        R"(file="pyramid.obj" refpos="1 2 3" refquat="1 0 0 .5" scale="2 2 2")",
        R"(file="pyramid.obj" refpos="1 2 3" scale="2 -3 .1")", R"(file="open.obj")",
        R"(file="open.obj" inertia="exact")", R"(file="prism.obj")", R"(file="prism.obj" class="c")",
        R"(vertex="0 0 0  1 0 0  0 1 0  0 0 1" face="0 2 1  0 1 3  0 3 2  1 2 3")",
        R"(vertex="0 0 0  1 0 0  0 2 0  0 0 3  .1 .2 .3  1 1 1")", R"(file="bracket.stl" inertia="convex")",
        R"(file="bracket.stl" inertia="shell")", R"(file="open.obj" inertia="shell" scale="1 2 -1")",
        R"(file="prism.obj" inertia="convex" scale="1 2 3")"}) {
    meshes += fmt::format(R"(<mesh name="m{}" {}/>)", ++k, mesh);
    bodies += fmt::format(
        R"(<body><joint axis="1 2 3"/><geom type="mesh" mesh="m{}" pos=".1 0 0" euler="0 0 30"/></body>)", k);
  }
  const std::string xml =
      "<mujoco><default><default class=\"c\"><mesh scale=\"1 2 3\" inertia=\"exact\"/></default>"
      "</default><asset>" +
      meshes + "</asset><worldbody>" + bodies + "</worldbody></mujoco>";
  compare_bodies(xml);
  along_its_axes_ = true;
  compare_text(xml);
}

// A text per fact about <compiler> and <default>.
TEST_F(MujocoFiles, SettingsAreThoseOfMujoco) {
  const std::string bodies = R"(<worldbody><body euler="10 20 30"><joint axis="1 0 1"/>
      <geom type="box" size=".1 .2 .3" euler="5 6 7"/><body pos="0 .5 0" euler="40 -20 10"><joint axis="0 1 0"/>
      <geom type="capsule" size=".1 .2" pos=".1 0 .3"/></body></body></worldbody></mujoco>)";
  for (const char* settings : {R"(eulerseq="ZYX" settotalmass="7")", R"(eulerseq="XyZ")", R"(eulerseq="xxy")",
                               R"(angle="radian" inertiafromgeom="true")", R"(fusestatic="true")",
                               R"(inertiagrouprange="0 1" boundmass="900" boundinertia="1e-3")"}) {
    SCOPED_TRACE(settings);
    compare_text(std::string("<mujoco><compiler ") + settings + "/>" + bodies);
  }
}

TEST_F(MujocoFiles, BoundsAndBalancesAreThoseOfMujoco) {
  compare_text(R"(<mujoco><compiler boundmass=".5" boundinertia=".01" balanceinertia="true"/><worldbody>
    <body><joint axis="1 0 1"/><inertial pos=".1 0 0" mass=".1" diaginertia=".001 .001 .1"/>
    <body pos="0 .5 0"><joint axis="0 1 0"/>
      <inertial pos=".1 .2 0" mass="2" diaginertia=".1 .2 .005" euler="30 0 0"/></body></body></worldbody></mujoco>)");
}

TEST_F(MujocoFiles, ClassesInClassesAreThoseOfMujoco) {
  compare_text(
      R"(<mujoco><compiler inertiagrouprange="1 3"/><default><geom group="2"/><joint armature=".1" damping=".5"/>
    <general gear="3"/><motor gear="4" armature=".2"/><default class="a"><geom group="4"/><position kp="5"/>
    <default class="b"><geom group="3" density="500"/><joint stiffness="3" springref="20" ref="10"/></default></default>
    </default><worldbody><body><joint name="j" axis="1 0 1"/><geom size=".1"/>
    <body pos="0 .5 0" childclass="a"><joint name="k" axis="0 1 0" class="b"/><geom size=".2" pos=".1 0 0"/>
      <geom class="b" size=".1" pos="0 .1 0"/></body></body></worldbody>
    <actuator><motor joint="j"/><position joint="k" class="b"/><general joint="k" gear="2" armature=".02"/>
      <velocity joint="j" kv="2"/></actuator></mujoco>)");
}

TEST_F(MujocoFiles, JointsOfAFreeBodyFollowOthers) {
  compare_text(R"(<mujoco><worldbody><body name="table" pos="0 0 -1"><geom type="box" size="1 1 .1"/></body>
      <body name="trunk"><freejoint/><geom type="box" size=".3 .2 .1" pos=".01 .02 0"/>
      <body name="arm" pos=".3 0 .1" euler="10 20 30"><joint name="j" axis="0 1 0" damping=".3"/>
        <geom type="capsule" size=".05 .2" pos=".1 0 0"/>
        <body name="left" pos=".3 .05 0"><joint name="k" type="slide" axis="0 1 0" armature=".01"/><geom size=".04"/></body>
        <body name="right" pos=".3 -.05 0"><joint name="l" type="slide" axis="0 -1 0"/><geom size=".04"/></body></body>
      <body name="tail" pos="-.3 0 0"><joint name="t"/><geom type="capsule" size=".03 .1" pos="-.1 0 .02"/></body>
    </body></worldbody><equality><joint joint1="l" joint2="k"/><joint joint1="t" joint2="j" polycoef=".1 -.5 0 0 0"/>
    </equality></mujoco>)");
}

}  // namespace
}  // namespace flatdyn::mujoco_peer
