// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/snap_effect.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "load/load_robot.hpp"

namespace flatdyn {
namespace {

// A pendulum with its axis tilted by 90 degrees minus 1e-6: the torque m g l cos q has a part of that size.
constexpr const char* kPendulum =
    "<robot name='p'><link name='b'/><link name='l'><inertial><origin xyz='1 0 0'/><mass value='2'/>"
    "<inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link>"
    "<joint name='j' type='continuous'><parent link='b'/><child link='l'/><axis xyz='AXIS'/>"
    "<origin rpy='RPY'/></joint></robot>";

std::vector<double> effects_of(const std::string& rpy, const std::string& axis = "0 0 1") {
  const auto path = std::filesystem::path(::testing::TempDir()) /
                    ("snap_effect_" + std::to_string(rpy.size()) + "_" + std::to_string(axis.size()) + ".urdf");
  std::string text = kPendulum;
  text.replace(text.find("RPY"), 3, rpy);
  text.replace(text.find("AXIS"), 4, axis);
  std::ofstream(path) << text;
  const LoadedRobot model = load_robot(path, {});
  std::vector<double> effects = snap_effects(model, {});
  std::filesystem::remove(path);
  return effects;
}

TEST(SnapEffects, HaveTheSizeOfTheAngleTimesTheTorque) {
  const std::vector<double> effects = effects_of("0.000001 0 0");  // snapped to 0: gravity along the axis
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_GT(effects[0], 1e-6);
  EXPECT_LT(effects[0], 2 * 9.81 * 1e-6);
}

TEST(SnapEffects, AreOfEachAngleApart) {
  const std::vector<double> effects = effects_of("0.000001 0 0.0000001");
  ASSERT_EQ(effects.size(), 2u);
  EXPECT_GT(effects[0], 1e-6);
  EXPECT_EQ(effects[1], 0);  // a turn about gravity
}

TEST(SnapEffects, AreOfDustToo) {
  const std::vector<double> effects = effects_of("0.000001 0 0", "0 1e-10 1");
  ASSERT_EQ(effects.size(), 2u);
  EXPECT_GT(effects[0], 1e-6);
  EXPECT_GT(effects[1], 1e-10);
  EXPECT_LT(effects[1], 2 * 9.81 * 1e-10);
}

TEST(SnapEffects, AreNoneWhereNothingIsSnapped) { EXPECT_TRUE(effects_of("0.5 0 0").empty()); }

}  // namespace
}  // namespace flatdyn
