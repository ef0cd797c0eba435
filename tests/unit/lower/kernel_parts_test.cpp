// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/kernel_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/packed_places.hpp"
#include "code/lower/schedule.hpp"
#include "functions/planning/kernel_columns.hpp"
#include "proof/verify/kernel_proof.hpp"
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

bool reads_entries(const Function& part) {
  const std::vector<Input> inputs = inputs_read(part);
  return std::any_of(inputs.begin(), inputs.end(), [](const Input& each) { return each.kind == InputKind::stored; });
}

// The derivatives of the Panda's forward dynamics, whose later parts read B^-1 from the first one's output.
TEST(KernelParts, ReadWhatEarlierOnesHaveWritten) {
  const testing::PrintedCode code(testing::model_of("panda.urdf"), {"forward_dynamics_derivatives"});
  const Function& whole = code.functions()[0];
  const KernelParts direct = kernel_parts({whole}, values_in_registers(true));
  const KernelParts parts =
      kernel_parts({whole}, values_in_registers(true), {reading_own_outputs(code.model(), whole)});
  const auto most_live = [](const KernelParts& of) {
    long most = 0;
    for (const Function& part : of.functions) most = std::max(most, most_live_values(part));
    return most;
  };
  EXPECT_FALSE(reads_entries(parts.functions.front()));
  EXPECT_TRUE(reads_entries(parts.functions.back()));
  EXPECT_EQ(parts.functions.front().validity_conditions.size(), whole.validity_conditions.size());
  EXPECT_LT(most_live(parts), most_live(direct));
  EXPECT_NO_THROW(prove_parts(whole, parts.functions));

  // In another order a part reads what none has written; without one an entry is missing; another entry is wrong.
  std::vector<Function> wrong = parts.functions;
  std::rotate(wrong.begin(), wrong.begin() + 1, wrong.end());
  EXPECT_THROW(composed(whole, wrong), Failure);
  wrong = parts.functions;
  wrong.pop_back();
  EXPECT_THROW(composed(whole, wrong), Failure);
  wrong = parts.functions;
  std::swap(wrong.back().outputs[0].entries[1], wrong.back().outputs[0].entries[2]);
  EXPECT_THROW(prove_parts(whole, wrong), Failure);
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
