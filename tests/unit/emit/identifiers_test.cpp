// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/identifiers.hpp"

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
  EXPECT_EQ(cpp_identifier("größe"), "gr_e");
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
