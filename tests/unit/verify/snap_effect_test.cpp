// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/snap_effect.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/system/temporary_folder.hpp"
#include "functions/load/load_robot.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

// A pendulum with its axis tilted by 90 degrees minus 1e-6: the torque m g l cos q has a part of that size.
constexpr const char* kPendulum =
    "<robot name='p'><link name='b'/><link name='l'><inertial><origin xyz='1 0 0'/><mass value='2'/>"
    "<inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link>"
    "<joint name='j' type='continuous'><parent link='b'/><child link='l'/><axis xyz='AXIS'/>"
    "<origin rpy='RPY'/></joint></robot>";

SnapEffects effects_of(const std::string& rpy, const std::string& axis = "0 0 1") {
  const auto path = std::filesystem::path(::testing::TempDir()) /
                    ("snap_effect_" + std::to_string(rpy.size()) + "_" + std::to_string(axis.size()) + ".urdf");
  std::string text = kPendulum;
  text.replace(text.find("RPY"), 3, rpy);
  text.replace(text.find("AXIS"), 4, axis);
  std::ofstream(path) << text;
  const LoadedRobot model = load_robot(path, {});
  SnapEffects effects = snap_effects(model, {});
  std::filesystem::remove(path);
  return effects;
}

// The bound is above what was seen, and not far above it: `size` is that of the torque.
void expect_effect(const SnapEffect& effect, double size) {
  EXPECT_GT(effect.seen, size / 20);
  ASSERT_TRUE(effect.bound);
  EXPECT_GE(*effect.bound, effect.seen);
  EXPECT_LT(*effect.bound, 30 * size);
}

constexpr double kTorque = 2 * 9.81;

TEST(SnapEffects, HaveTheSizeOfTheAngleTimesTheTorque) {
  const SnapEffects effects = effects_of("0.000001 0 0");  // snapped to 0: gravity along the axis
  ASSERT_EQ(effects.each.size(), 1u);
  expect_effect(effects.each[0], kTorque * 1e-6);
  EXPECT_EQ(effects.bound, effects.each[0].bound);
}

TEST(SnapEffects, AreOfEachAngleApart) {
  const SnapEffects effects = effects_of("0.000001 0 0.0000001");
  ASSERT_EQ(effects.each.size(), 2u);
  expect_effect(effects.each[0], kTorque * 1e-6);
  EXPECT_LT(effects.each[1].seen, 1e-40);  // a turn about gravity
  EXPECT_LT(*effects.each[1].bound, *effects.each[0].bound);
  EXPECT_GT(*effects.bound, *effects.each[0].bound) << "of both together";
}

TEST(SnapEffects, AreOfDustToo) {
  const SnapEffects effects = effects_of("0.000001 0 0", "0 1e-10 1");
  ASSERT_EQ(effects.each.size(), 2u);
  expect_effect(effects.each[0], kTorque * 1e-6);
  expect_effect(effects.each[1], kTorque * 1e-10);
}

TEST(SnapEffects, HaveNoBoundsWhereAFreeSymbolMayHaveAnyValue) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "arm.toml";
  std::ofstream(file) << "[[link]]\nmass = \"m\"\ncom = [1, 0, 0]\nrpy = [1.5708, 0, 0]\n";
  const SnapEffects effects = snap_effects(load_robot(file, {}), {});
  ASSERT_EQ(effects.each.size(), 1u);
  EXPECT_GT(effects.each[0].seen, 0);
  EXPECT_FALSE(effects.each[0].bound);
  EXPECT_FALSE(effects.bound);
}

// The line on which the slider moves is turned by 9e-6 rad, which is snapped.
TEST(SnapEffects, AreThoseOfClosedLoops) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "crank.toml";
  std::string text = testing::text_of_robot("slider_crank.toml");
  const std::string axis = "axis = [1, 0, 0]\n";
  text.insert(text.find(axis) + axis.size(), "rpy = [0, 0, 9e-6]\n");
  std::ofstream(file) << text;
  const SnapEffects effects = snap_effects(load_robot(file, {}), {});
  ASSERT_EQ(effects.each.size(), 1u);
  EXPECT_GT(effects.each[0].seen, 0);
  EXPECT_LT(effects.each[0].seen, 1e-4);
}

TEST(SnapEffects, AreNoneWhereNothingIsSnapped) { EXPECT_TRUE(effects_of("0.5 0 0").each.empty()); }

}  // namespace
}  // namespace flatdyn
