// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/code_size.hpp"

#include <gmock/gmock.h>

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A function that writes q_1 + q_2 to each of its entries.
OptimisedFunction sums(const std::string& name, std::size_t entries) {
  OptimisedFunction made;
  Function& function = made.function;
  function.name = name;
  const NodeId a = function.graph.input({InputKind::q, 0}), b = function.graph.input({InputKind::q, 1});
  Output output{};
  output.entries.assign(entries, function.graph.sum({{1, a}, {1, b}}));
  function.outputs.push_back(output);
  return made;
}

TEST(CodeSize, IsThatOfOperationsAndOfWrittenEntries) {
  EXPECT_EQ(code_bytes(sums("f", 7).function), 9 + 7 * 10);
  OptimisedFunction part = sums("f", 7);
  part.function.outputs[0].left_out.assign(7, true);
  EXPECT_EQ(code_bytes(part.function), 9);
  Function zeros = sums("f", 7).function;
  for (std::size_t k = 2; k < 7; ++k) zeros.outputs[0].entries[k] = zeros.graph.constant(0);
  EXPECT_EQ(code_bytes(zeros), 9 + 2 * 10 + 5 * 2);
}

TEST(CodeSize, NamesFunctionsThatAreLargerThanTheCache) {
  const std::string text = describe_code_size({sums("small", 3275), sums("large", 3276)}, {}, false);
  EXPECT_THAT(text, HasSubstr("single calls are slowed down: large (some 32 KiB)"));
  EXPECT_THAT(text, Not(HasSubstr("small")));
  EXPECT_THAT(describe_code_size({sums("small", 3275)}, {}, false), IsEmpty());
}

TEST(CodeSize, SuggestsLanesWhereThereAreLimbs) {
  EmitOptions options;
  EXPECT_THAT(describe_code_size({sums("large", 3276)}, options, true), HasSubstr("--limbs lanes"));
  EXPECT_THAT(describe_code_size({sums("large", 3276)}, options, false), Not(HasSubstr("--limbs lanes")));
  options.limbs_in_lanes = true;
  const std::string in_lanes = describe_code_size({sums("large", 3276)}, options, true);
  EXPECT_THAT(in_lanes, Not(HasSubstr("--limbs lanes")));
  EXPECT_THAT(in_lanes, HasSubstr("(some 32 KiB), before limbs are computed together"));
}

TEST(CodeSize, IsNothingWhereNothingIsCompiled) {
  EmitOptions options;
  options.language = "javascript";
  EXPECT_THAT(describe_code_size({sums("large", 10'000)}, options, true), IsEmpty());
}

}  // namespace
}  // namespace flatdyn::testing
