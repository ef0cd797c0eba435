// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/name_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace flatdyn {
namespace {

using ::testing::ElementsAre;

TEST(NameList, BlanksAroundNamesDoNotCount) {
  EXPECT_THAT(names_in("gravity"), ElementsAre("gravity"));
  EXPECT_THAT(names_in(" gravity , bias"), ElementsAre("gravity", "bias"));
}

TEST(NameList, NothingBetweenCommasIsRefused) {
  for (const char* list : {"gravity,,bias", "gravity,", ",gravity", "", " ", "gravity, ,bias"}) {
    EXPECT_THROW(names_in(list), std::invalid_argument) << list;
  }
}

}  // namespace
}  // namespace flatdyn
