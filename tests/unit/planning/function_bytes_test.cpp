// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/function_bytes.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/system/apart.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/passes/sharing_memo.hpp"
#include "graph/text.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

std::vector<OptimisedFunction> made(const LoadedRobot& model, const std::vector<std::string>& names, bool apart) {
  PipelineOptions options;
  options.functions = names;
  options.in_processes = apart;
  Progress quiet(true);
  Diagnostics findings;
  return make_functions(model, options, quiet, findings);
}

void expect_same(const Function& a, const Function& b) {
  EXPECT_TRUE(has_same_nodes(a, b));
  EXPECT_EQ(to_text(a), to_text(b));
  EXPECT_EQ(a.pivot_scales, b.pivot_scales);
  EXPECT_EQ(a.formulation, b.formulation);
  EXPECT_EQ(a.proven_pivot_share, b.proven_pivot_share);
  for (std::size_t k = 0; k < a.outputs.size(); ++k) EXPECT_EQ(a.outputs[k].quantity, b.outputs[k].quantity);
}

// With symbols and closed loops.
TEST(FunctionBytes, AreTheWholeFunction) {
  for (const char* file : {"planar_2r_example_7_2.toml", "four_bar.toml", "planar_2r.toml"}) {
    const LoadedRobot model = model_of(file);
    for (const OptimisedFunction& each : made(model, {"inverse_dynamics", "forward_dynamics"}, false)) {
      const OptimisedFunction again = from_bytes(to_bytes(each));
      expect_same(each.function, again.function);
      expect_same(each.derived, again.derived);
      ASSERT_EQ(each.passes.size(), again.passes.size());
      EXPECT_EQ(each.passes.back().after, again.passes.back().after);
    }
  }
  EXPECT_ANY_THROW(from_bytes("no bytes"));
}

TEST(FunctionBytes, FunctionsThatAreMadeApartAreTheSame) {
  const LoadedRobot model = model_of("ur5.urdf");
  const std::vector<std::string> names = {"inverse_dynamics", "gravity", "kinetic_energy"};
  const std::vector<OptimisedFunction> here = made(model, names, false), apart = made(model, names, true);
  for (std::size_t k = 0; k < names.size(); ++k) expect_same(here[k].function, apart[k].function);
}

TEST(ComputedApart, TextsComeByTaskAndThoseThatFailAreMissing) {
  const auto texts = computed_apart(40, 3, [](std::size_t task) {
    if (task == 7) throw std::runtime_error("no text");
    return std::string(task * 10'000, static_cast<char>('a' + task % 26));
  });
  ASSERT_EQ(texts.size(), 40u);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    EXPECT_EQ(texts[k].has_value(), k != 7);
    const std::string wanted(k * 10'000, static_cast<char>('a' + k % 26));
    EXPECT_EQ(texts[k].value_or(wanted), wanted);
  }
}

TEST(ComputedApart, AProcessThatEndsLeavesItsTasksToOthers) {
  const auto texts = computed_apart(10, 2, [](std::size_t task) {
    if (task == 0) std::abort();
    return std::to_string(task);
  });
  EXPECT_FALSE(texts[0]);
  for (std::size_t k = 1; k < texts.size(); ++k) EXPECT_EQ(texts[k], std::to_string(k));
}

}  // namespace
}  // namespace flatdyn::testing
