// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/identifiers.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

TEST(Identifiers, KeepsWhatIsValid) {
  EXPECT_EQ(cpp_identifier("panda_joint1"), "panda_joint1");
  EXPECT_EQ(cpp_identifier("LF_HAA"), "LF_HAA");
}

TEST(Identifiers, ReplacesWhatIsNot) {
  EXPECT_EQ(cpp_identifier("arm-1/joint 2"), "arm_1_joint_2");
  EXPECT_EQ(cpp_identifier("2dof_planar"), "x2dof_planar");
}

TEST(Identifiers, WritesLettersOfOtherScriptsInAscii) {
  EXPECT_EQ(cpp_identifier("größe"), "grosse");
  EXPECT_EQ(cpp_identifier("θ1"), "theta1");
  EXPECT_EQ(cpp_identifier("Плечо-2"), "Plecho_2");
  EXPECT_EQ(cpp_identifier("Łokieć"), "Lokiec");
  EXPECT_EQ(cpp_identifier("关节一"), "u5173_u8282_u4e00");
  EXPECT_EQ(cpp_identifier("关节二"), "u5173_u8282_u4e8c");
  EXPECT_EQ(cpp_identifier("arm关a"), "arm_u5173_a");
  EXPECT_EQ(cpp_identifier("45°"), "x45");
  EXPECT_EQ(cpp_identifier("a\xFF"
                           "b"),
            "a_b");  // not UTF-8
}

TEST(Identifiers, AvoidsWhatCppReserves) {
  EXPECT_EQ(cpp_identifier("class"), "class_");
  EXPECT_EQ(cpp_identifier("co_await"), "co_await_");
  EXPECT_EQ(cpp_identifier("NAN"), "NAN_");
  EXPECT_EQ(cpp_identifier("std"), "std_");
  EXPECT_EQ(cpp_identifier("detail"), "detail_");  // generated headers have a namespace of that name
  EXPECT_EQ(cpp_identifier("__a__b"), "a_b");
  EXPECT_EQ(cpp_identifier("_Upper"), "Upper");
}

TEST(Identifiers, AlwaysGivesAName) {
  EXPECT_EQ(cpp_identifier(""), "unnamed");
  EXPECT_EQ(cpp_identifier("--"), "unnamed");
}

}  // namespace
}  // namespace flatdyn
