// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/zero_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

TEST(ZeroMap, FillsWhatIsNotAlwaysZero) {
  Function function;
  Graph& graph = function.graph;
  const NodeId zero = graph.constant(0), q = graph.input({InputKind::q, 0});
  Output output;
  output.layout = Layout::matrix;
  output.rows = 2;
  output.cols = 3;
  output.entries = {zero, q, zero, graph.constant(2), zero, zero};
  EXPECT_EQ(nonzero_entries(function, output), 2);
  const std::string svg = zero_map(function, output, "a < \"b\"");
  EXPECT_THAT(svg, HasSubstr("d=\"M1 0h.9v.9h-.9zM0 1h.9v.9h-.9z\""));
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 3 2\""));
  EXPECT_THAT(svg, HasSubstr("aria-label=\"a &lt; &quot;b&quot;\""));
}

}  // namespace
}  // namespace flatdyn
