// SPDX-License-Identifier: GPL-2.0-or-later
// tests/consumer/header: a separate CMake project builds against generated/ and runs, with one arm in a header, and
// another in header and source.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

TEST(Consumer, BuildsAndRuns) {
  const TemporaryFolder build;
  const std::string command = fmt::format(
      "(cmake -S '{0}/tests/consumer/header' -B '{1}' -D GENERATED='{0}/generated' && cmake --build '{1}' && "
      "'{1}/consumer') "
      "> '{1}/log' 2>&1",
      FLATDYN_SOURCE_DIR, build.path().string());
  EXPECT_EQ(std::system(command.c_str()), 0) << content_of(build.path() / "log");
}

}  // namespace
}  // namespace flatdyn::testing
