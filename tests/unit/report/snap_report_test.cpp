// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/snap_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

std::vector<Snap> some_snaps() {
  const Place place{"arm.urdf", 12};
  return {{place, "joint \"j\", origin, rpy", "1.5708", GiNaC::Pi / 2, exact_decimal("-3.67e-6"), Snap::Kind::angle},
          {place, "joint \"j\", axis, x", "-1.2e-15", 0, exact_decimal("1.2e-15"), Snap::Kind::axis},
          {place, "joint \"j\", axis, y", "1e-15", 0, exact_decimal("-1e-15"), Snap::Kind::axis},
          {place, "link \"l\", inertia, xy", "3.7e-19", 0, exact_decimal("-3.7e-19"), Snap::Kind::product_of_inertia}};
}
const SnapEffects kEffects = {{{3e-6, {}}, {2e-15, 2.11e-15}, {3e-15, {}}, {4e-18, {}}}, {}};

TEST(SnapReport, IsOneLine) {
  EXPECT_EQ(
      describe_snaps(some_snaps(), kEffects, SnapDetail::one_line),
      "\n4 numbers were snapped to exact ones near them (1 angle, 2 components of axes, 1 product of inertia); the "
      "largest torque change at random states is 3e-06 N m; -v lists them\n");
  EXPECT_EQ(describe_snaps({some_snaps()[1]}, {{{2e-15, 2.11e-15}}, 2.11e-15}, SnapDetail::one_line),
            "\n1 number was snapped to an exact one near it (1 component of axes); together they change no torque by "
            "more than 3e-15 N m; -v lists them\n");
  EXPECT_EQ(describe_snaps({}, {}, SnapDetail::one_line), "");
}

TEST(SnapReport, ListsEach) {
  const std::string text = describe_snaps(some_snaps(), kEffects, SnapDetail::each);
  EXPECT_THAT(text, HasSubstr("  arm.urdf:12: joint \"j\", origin, rpy: 1.5708 snapped to pi/2: off by -3.7e-06 rad, "
                              "changes torques by up to 3.0e-06 N m at random states\n"));
  EXPECT_THAT(
      text,
      HasSubstr("  arm.urdf:12: joint \"j\", axis, x: -1.2e-15 snapped to 0: off by 1.2e-15, changes no torque by more "
                "than 2.2e-15 N m\n"));
  EXPECT_THAT(text, HasSubstr("off by -3.7e-19 kg m^2, changes torques by up to 4.0e-18 N m at random states\n"));
}

TEST(SnapReport, HasKindsInJson) {
  const nlohmann::ordered_json json = snaps_json(some_snaps(), kEffects);
  ASSERT_EQ(json.size(), 4U);
  EXPECT_EQ(json[1].dump(), R"({"line":12,"kind":"axis","what":"joint \"j\", axis, x","written":"-1.2e-15",)"
                            R"("taken_for":"0","largest_torque_change":2e-15,"torque_change_bound":2.2e-15})");
  EXPECT_EQ(json[0].at("kind"), "angle");
  EXPECT_EQ(json[3].at("kind"), "product of inertia");
}

}  // namespace
}  // namespace flatdyn
