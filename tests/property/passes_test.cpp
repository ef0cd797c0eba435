// SPDX-License-Identifier: GPL-2.0-or-later
// Properties of every pass on any function: exactly the same values, no higher count, a graph in normal form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "graph/mod_p.hpp"
#include "graph/passes/passes.hpp"
#include "graph/well_formed.hpp"
#include "property/random_function.hpp"

namespace flatdyn {
namespace {

template <std::uint64_t P>
std::vector<std::uint64_t> values(const Function& function, std::uint64_t seed) {
  ModPArithmetic<P> arithmetic(seed);
  const auto all = evaluate(function, arithmetic);
  std::vector<std::uint64_t> result;
  for (const NodeId root : roots(function)) result.push_back(all[static_cast<std::size_t>(root)].value());
  return result;
}

void expect_same_values(const Function& a, const Function& b, std::uint64_t seed) {
  EXPECT_EQ(values<kMersenne61>(a, seed), values<kMersenne61>(b, seed));
  EXPECT_EQ(values<kPrime61b>(a, seed + 1), values<kPrime61b>(b, seed + 1));
  EXPECT_EQ(values<kPrime61c>(a, seed + 2), values<kPrime61c>(b, seed + 2));
}

void expect_same_graph(const Function& a, const Function& b) {
  ASSERT_EQ(a.graph.size(), b.graph.size());
  for (NodeId id = 0; id < a.graph.size(); ++id) {
    ASSERT_EQ(a.graph[id], b.graph[id]) << "node " << id;
    const std::string *name_a = a.graph.name(id), *name_b = b.graph.name(id);
    ASSERT_EQ(name_a == nullptr, name_b == nullptr) << "node " << id;
    if (name_a != nullptr) {
      ASSERT_EQ(*name_a, *name_b);
    }
  }
  EXPECT_EQ(roots(a), roots(b));
}

class RandomFunctions : public ::testing::TestWithParam<int> {
 protected:
  std::uint64_t seed() const { return 20260 + static_cast<std::uint64_t>(GetParam()); }
  Function make() const {
    return RandomFunction(seed()).make(15 + static_cast<int>(seed() * 37 % 140), 2 + GetParam() % 6);
  }
};

TEST_P(RandomFunctions, KeepTheirValuesThroughEveryPass) {
  SCOPED_TRACE("seed " + std::to_string(seed()));
  const Function original = make();
  ASSERT_EQ(check_well_formed(original), std::nullopt);
  Function current = original;
  for (const Pass& pass : pass_table()) {
    SCOPED_TRACE(pass.name);
    for (const Function& input : {original, current}) {
      const Function result = pass.run(input);
      const OperationCount before = count_operations(input), after = count_operations(result);
      EXPECT_LE(after.arithmetic() + 5 * after.divisions, before.arithmetic() + 5 * before.divisions);
      EXPECT_LE(after.divisions, before.divisions);
      EXPECT_LE(after.trigonometric, before.trigonometric);
      ASSERT_EQ(check_well_formed(result), std::nullopt);
      expect_same_values(original, result, seed());
    }
    current = pass.run(current);
  }
}

TEST_P(RandomFunctions, GiveTheSameGraphEveryTime) {
  SCOPED_TRACE("seed " + std::to_string(seed()));
  expect_same_graph(make(), make());
  std::vector<PassRecord> record;
  const Function once = run_passes(make(), &record);
  expect_same_graph(once, run_passes(make()));
  expect_same_values(make(), once, seed());
  EXPECT_EQ(check_well_formed(once), std::nullopt);
  ASSERT_FALSE(record.empty());
  EXPECT_EQ(record.front().before, count_operations(make()));
  EXPECT_EQ(record.back().after, count_operations(once));
}

TEST_P(RandomFunctions, AreInNormalFormAfterOneRebuild) {
  SCOPED_TRACE("seed " + std::to_string(seed()));
  const Pass& dead_code = pass_table().front();
  const Function once = dead_code.run(make());
  expect_same_graph(once, dead_code.run(once));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFunctions, ::testing::Range(0, 60));

}  // namespace
}  // namespace flatdyn
