// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/kernel_parts.hpp"

#include <gtest/gtest.h>

#include "emit/packed_places.hpp"
#include "emit/schedule.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

std::vector<Function> functions_of_panda(const std::vector<std::string>& names) {
  return testing::PrintedCode(testing::model_of("panda.urdf"), names).functions();
}

// Every entry is in one part, equal to the whole's.
TEST(KernelParts, TogetherWriteEveryEntryOnce) {
  const std::vector<Function> whole = functions_of_panda({"inverse_dynamics_derivatives"});
  const KernelParts parts = kernel_parts(whole, values_in_registers(true));
  ASSERT_EQ(parts.counts, std::vector<int>{2});
  for (std::size_t o = 0; o < whole[0].outputs.size(); ++o) {
    for (std::size_t e = 0; e < whole[0].outputs[o].entries.size(); ++e) {
      int writers = 0;
      for (const Function& part : parts.functions) writers += part.outputs[o].leaves_out(e) ? 0 : 1;
      EXPECT_EQ(writers, 1) << o << " " << e;
    }
  }
}

// The Panda's derivatives have 210 values at once, of which a thread holds 115 doubles.
TEST(KernelParts, HaveFewerValuesAtOnce) {
  const std::vector<Function> whole = functions_of_panda({"inverse_dynamics_derivatives", "gravity"});
  EXPECT_GT(most_live_values(whole[0]), 200);
  const KernelParts parts = kernel_parts(whole, values_in_registers(true));
  for (const Function& part : parts.functions) EXPECT_LE(most_live_values(part), 150) << part.name;
  EXPECT_EQ(parts.counts.at(1), 0);
}

TEST(KernelParts, FirstOneChecksPivots) {
  const std::vector<Function> whole = functions_of_panda({"forward_dynamics_derivatives"});
  const KernelParts parts = kernel_parts(whole, values_in_registers(true));
  ASSERT_GE(parts.functions.size(), 2u);
  EXPECT_EQ(parts.functions[0].validity_conditions.size(), whole[0].validity_conditions.size());
  for (std::size_t k = 1; k < parts.functions.size(); ++k) {
    ASSERT_EQ(parts.functions[k].validity_conditions.size(), 1u);
    EXPECT_TRUE(always_holds(parts.functions[k], 0));
  }
}

TEST(PackedPlaces, LeaveOutZerosAndHaveEqualEntriesOnce) {
  Graph graph;
  const NodeId a = graph.input({InputKind::q, 0}), b = graph.input({InputKind::q, 1}), zero = graph.constant(0);
  Output output;
  output.layout = Layout::matrix;
  output.rows = output.cols = 2;
  output.entries = {b, a, a, zero};
  EXPECT_EQ(packed_places(output, graph), (std::vector<int>{0, 1, 1, -1}));
  EXPECT_FALSE(is_identity(packed_places(output, graph)));
  output.entries = {b, a};
  EXPECT_TRUE(is_identity(packed_places(output, graph)));
}

}  // namespace
}  // namespace flatdyn
