// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

class Snapping : public RobotFiles {
 protected:
  Robot with_roll(const std::string& roll, const ReadOptions& options = {}) {
    return read("r.urdf", one_joint_urdf("revolute", "<origin rpy=\"" + roll + " 0 0\"/>"), options);
  }
  static Number angle_of(const Robot& robot) {
    const Pose& origin = robot.joints.at(0).origin;
    return origin.displacements.empty() ? Number(0) : origin.displacements.at(0).angle;
  }
};

TEST_F(Snapping, TakesADecimalForTheMultipleThatIsMeant) {
  const std::vector<std::pair<std::string, int>> twelfths = {{"1.57079632679", 6},      {"-1.5708", -6},
                                                             {"3.141592653589793", 12}, {"0.7853981633974483", 3},
                                                             {"0.2617993877991494", 1}, {"12.566370614359172", 48}};
  for (const auto& [written, n] : twelfths) {
    const Robot robot = with_roll(written);
    EXPECT_TRUE(angle_of(robot).is_equal(n * GiNaC::Pi / 12)) << written;
    ASSERT_EQ(robot.snaps.size(), 1U) << written;
    EXPECT_EQ(robot.snaps[0].written, written);
    EXPECT_EQ(robot.snaps[0].what, "joint \"j\", origin, rpy");
    EXPECT_EQ(robot.snaps[0].place.line, 1);
  }
}

TEST_F(Snapping, KnowsTheDifference) {
  const Number difference = with_roll("1.57079632679").snaps.at(0).difference;
  EXPECT_TRUE(is_rational(difference));
  EXPECT_EQ(to_decimal(difference, 12), to_decimal(GiNaC::Pi / 2 - exact_decimal("1.57079632679"), 12));
}

TEST_F(Snapping, LeavesOtherAnglesAlone) {
  const Robot robot = with_roll("1.5709");  // 1e-4 away
  EXPECT_TRUE(angle_of(robot).is_equal(exact_decimal("1.5709")));
  EXPECT_TRUE(robot.snaps.empty());
}

TEST_F(Snapping, ZeroIsNoSnapButNearlyZeroIs) {
  EXPECT_TRUE(with_roll("0").snaps.empty());
  const Robot robot = with_roll("-1e-9");
  EXPECT_TRUE(angle_of(robot).is_zero());
  EXPECT_EQ(robot.snaps.size(), 1U);
}

TEST_F(Snapping, CanBeTurnedOff) {
  ReadOptions options;
  options.snap_tolerance = 0;
  const Robot robot = with_roll("1.57079632679", options);
  EXPECT_TRUE(angle_of(robot).is_equal(exact_decimal("1.57079632679")));
  EXPECT_TRUE(robot.snaps.empty());
}

TEST_F(Snapping, HoldsForTomlDecimalsNotForExpressions) {
  const auto alpha = [&](const std::string& value) {
    return read("r.toml", "dh = \"modified\"\n[[link]]\nmass = 1\nalpha = " + value + "\n");
  };
  EXPECT_EQ(alpha("1.57079632679").snaps.size(), 1U);
  EXPECT_TRUE(angle_of(alpha("1.57079632679")).is_equal(GiNaC::Pi / 2));
  EXPECT_TRUE(alpha("\"pi/2\"").snaps.empty());
  EXPECT_TRUE(angle_of(alpha("\"pi/2\"")).is_equal(GiNaC::Pi / 2));
  EXPECT_TRUE(angle_of(alpha("\"1.5708\"")).is_equal(exact_decimal("1.5708")));
}

TEST_F(Snapping, RemembersMultiplesThatAreRounded) {
  const auto rounded = [&](const std::string& alpha, const std::string& top = "") {
    return read("r.toml", top + "dh = \"modified\"\n[[link]]\nmass = 1\nalpha = " + alpha + "\n").rounded_angles.size();
  };
  for (const char* angle : {"1.57", "-0.785", "3.14", "1.571", "0.524"}) EXPECT_EQ(rounded(angle), 1U) << angle;
  for (const char* angle : {"1.5708", "1.6", "1.56", "0.52", "0.001", "1.57100", "\"1.57\""}) {
    EXPECT_EQ(rounded(angle), 0U) << angle;
  }
  EXPECT_EQ(rounded("45.1", "angles = \"deg\"\n"), 0U);
}

TEST_F(Snapping, OtherIrrationalAnglesBecomeRational) {
  const Robot robot = read("r.toml", "dh = \"modified\"\n[[link]]\nmass = 1\nalpha = \"pi/2 - 0.1\"\n");
  EXPECT_TRUE(is_rational(angle_of(robot)));
  EXPECT_EQ(to_decimal(angle_of(robot), 50), to_decimal(GiNaC::Pi / 2 - Number(1) / 10, 50));
}

}  // namespace
}  // namespace flatdyn
