// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/diagnostics.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

TEST(Diagnostics, WritesPlaceSeverityMessageAndHint) {
  Diagnostics diagnostics;
  diagnostics.error({"arm.urdf", 12}, "link \"a\": mass is negative (-1)", "write it positive");
  diagnostics.warning({"arm.urdf", 0}, "of the whole file");
  diagnostics.note({}, "of the command line");
  ASSERT_EQ(diagnostics.all().size(), 3U);
  EXPECT_EQ(to_string(diagnostics.all()[0]),
            "arm.urdf:12: error: link \"a\": mass is negative (-1)\n    hint: write it positive");
  EXPECT_EQ(to_string(diagnostics.all()[1]), "arm.urdf: warning: of the whole file");
  EXPECT_EQ(to_string(diagnostics.all()[2]), "note: of the command line");
}

TEST(Diagnostics, KnowsWhatItHolds) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_FALSE(diagnostics.only_unsupported());
  diagnostics.note({}, "n");
  EXPECT_FALSE(diagnostics.has_warnings());
  diagnostics.warning({}, "w");
  EXPECT_TRUE(diagnostics.has_warnings());
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.unsupported({}, "u");
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_TRUE(diagnostics.only_unsupported());
  diagnostics.error({}, "e");
  EXPECT_FALSE(diagnostics.only_unsupported());
}

}  // namespace
}  // namespace flatdyn
