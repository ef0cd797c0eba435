// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/limit.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

TEST(SearchLimit, IsANumberOfCandidatesOrATime) {
  EXPECT_EQ(search_limit("200").value().candidates, 200);
  EXPECT_FALSE(search_limit("200").value().seconds.has_value());
  EXPECT_EQ(search_limit("2.5s").value().seconds, 2.5);
  EXPECT_FALSE(search_limit("2.5s").value().candidates.has_value());
}

TEST(SearchLimit, NothingElseIsOne) {
  for (const char* text : {"", "0", "-3", "2.5", "1e3", "s", "0s", "-1s", "ten", "30 s", "5m", "1000001", "90000s"}) {
    EXPECT_FALSE(search_limit(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace flatdyn
