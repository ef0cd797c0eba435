// SPDX-License-Identifier: GPL-2.0-or-later
// B singular to the last place: a link of almost no mass between two joints about the same axis. A pivot is then only
// rounding error, and functions that divide by it report that.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "definition/pivot_ratio.hpp"
#include "emit/languages/emit.hpp"
#include "model/states.hpp"
#include "planning/make_functions.hpp"
#include "support/written_model.hpp"
#include "verify/compiled.hpp"
#include "verify/proof.hpp"
#include "verify/verify.hpp"

namespace flatdyn {
namespace {

LoadedRobot arm_with_link_of_mass(const std::string& mass) {
  return testing::model_of_toml(fmt::format(R"(
[[link]]
mass = 2
inertia_about = "com"
com = [0.3, 0, 0.1]
inertia = {{ xx = 0.1, yy = 0.2, zz = 0.2 }}
[[link]]
xyz = [0.5, 0, 0]
rpy = [1, 0, 0]
mass = {0}
inertia_about = "com"
com = [0.1, 0, 0]
inertia = {{ xx = {0}, yy = {0}, zz = {0} }}
[[link]]
mass = 1
inertia_about = "com"
com = [0.4, 0.1, 0.2]
inertia = {{ xx = 0.02, yy = 0.03, zz = 0.04 }}
)",
                                            mass));
}

std::vector<OptimisedFunction> that_divide_by_pivots(const LoadedRobot& model) {
  PipelineOptions options;
  options.functions = {"forward_dynamics", "forward_dynamics_derivatives", "operational_inertia"};
  Progress quiet(true);
  Diagnostics none;
  return make_functions(model, options, quiet, none);
}

TEST(LostPivots, AreASmallShareOfTheDiagonal) {
  EXPECT_GT(smallest_pivot_ratio(arm_with_link_of_mass("1").mechanism), 1e-3);
  const double share = smallest_pivot_ratio(arm_with_link_of_mass("1e-9").mechanism);
  EXPECT_LT(share, 1e-7);
  EXPECT_GT(share, 1e-11);
  EXPECT_LT(smallest_pivot_ratio(arm_with_link_of_mass("1e-30").mechanism), 1e-15);
}

TEST(LostPivots, AreCheckedOnlyWhereTheyMayBeLost) {
  // The pivots of J B^-1 J^T are always checked.
  for (const auto& [mass, of_B] : {std::pair("1", 0U), std::pair("1e-30", 3U)}) {
    for (const OptimisedFunction& made : that_divide_by_pivots(arm_with_link_of_mass(mass))) {
      EXPECT_EQ(made.function.pivot_scales.size(), made.function.task.rows.size() + of_B)
          << made.function.name << ", " << mass;
    }
  }
}

// Near the stretched pose, 1e-9 rad from singular, J B^-1 J^T has a pivot that is only rounding error.
TEST(LostPivots, AreCheckedInTheOperationalSpaceOfAnyArm) {
  const LoadedRobot arm = testing::model_of_toml(R"(
[[link]]
mass = 1
com = [0.5, 0, 0]
[[link]]
xyz = [1, 0, 0]
mass = 1
com = [0.5, 0, 0]
[tip]
xyz = [1, 0, 0]
)");
  PipelineOptions options;
  options.functions = {"operational_inertia"};
  Progress quiet(true);
  Diagnostics none;
  const std::vector<Function> functions = functions_of(make_functions(arm, options, quiet, none));
  const CompiledFunctions compiled(arm.mechanism, functions);
  State state = random_states(arm.mechanism, 1, 1).front();
  for (const double q2 : {1.1925454989639916e-9, 1e-10, 3e-9, 1e-12}) {
    state.q = {1.6057098304459343, q2};
    EXPECT_TRUE(std::isnan(compiled.call(0, state)[0])) << q2;
  }
  for (const double q2 : {1e-5, 1e-3, 1.0}) {
    state.q = {1.6057098304459343, q2};
    EXPECT_FALSE(std::isnan(compiled.call(0, state)[0])) << q2;
  }
}

TEST(LostPivots, AreTold) {
  for (const auto& [mass, notes] : {std::pair("1", 0U), std::pair("1e-9", 0U), std::pair("1e-30", 1U)}) {
    PipelineOptions options;
    options.functions = {"forward_dynamics"};
    Progress quiet(true);
    Diagnostics found;
    make_functions(arm_with_link_of_mass(mass), options, quiet, found);
    EXPECT_EQ(found.all().size(), notes) << mass;
  }
}

TEST(LostPivots, AreNoErrorsOfTheCode) {
  const LoadedRobot model = arm_with_link_of_mass("1e-30");
  Progress quiet(true);
  VerifyOptions options;
  options.states = 10;
  const VerifyReport report =
      verify(model.robot, model.mechanism, functions_of(that_divide_by_pivots(model)), options, quiet);
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(report.functions.front().refused, 10U);
  EXPECT_THAT(to_text(report), ::testing::HasSubstr("a pivot is lost in rounding"));
}

// The check is in the text, in every language and form, and is read back.
TEST(LostPivots, AreCheckedInEveryForm) {
  const LoadedRobot model = arm_with_link_of_mass("1e-12");
  const std::vector<OptimisedFunction> made = that_divide_by_pivots(model);
  const std::vector<Function> functions = functions_of(made);
  EmitOptions options;
  const std::string header = emit_cpp(model.mechanism, functions, options);
  EXPECT_THAT(header, ::testing::HasSubstr("Scalar(0.015625) * "));
  EXPECT_THAT(header, ::testing::HasSubstr("lost in rounding"));
  prove_text(header, made, std::nullopt);
  options.most_lines = 60;
  prove_text(emit_cpp(model.mechanism, functions, options), made, std::nullopt);
  prove_text(EmittedText(emit_javascript(model.mechanism, functions, options), "number"), made, std::nullopt);
  for (const char* scalar : {"double", "float"}) {
    options.scalar = scalar;
    options.language = Language::c;
    const HeaderAndSource c = emit_c(model.mechanism, functions, options);
    prove_text(EmittedText(c.header + c.source, scalar), made, std::nullopt);
  }
}

}  // namespace
}  // namespace flatdyn
