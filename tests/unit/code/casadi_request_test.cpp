// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that are derived for CasADi, by what is asked for.
#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "code/languages/casadi/request.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using Names = std::vector<std::string>;

const Mechanism& arm() {
  static const Mechanism mechanism = testing::model_of("planar_2r_example_7_2.toml").mechanism;
  return mechanism;
}

TEST(CasadiRequest, HasAllDerivativesOfAFunctionAlone) {
  const FunctionsNeeded needed = functions_for_casadi(arm(), {"gravity"});
  EXPECT_EQ(needed.functions, (Names{"gravity", "jac:gravity", "vjp:gravity"}));
  EXPECT_EQ(needed.fused, (std::vector<Names>{{"hessian:gravity", "jac:gravity"}}));
  EXPECT_EQ(needed.note, "");
}

TEST(CasadiRequest, HasTheDerivativesThatAreNamed) {
  const FunctionsNeeded needed = functions_for_casadi(arm(), {"jac:gravity", "bias", "jvp:gravity", "vjp:bias"});
  EXPECT_EQ(needed.functions, (Names{"gravity", "jac:gravity", "jvp:gravity", "bias", "vjp:bias"}));
  EXPECT_TRUE(needed.fused.empty());
  // The Hessian is the Jacobian of the adjoint.
  EXPECT_EQ(functions_for_casadi(arm(), {"hessian:bias"}).functions, (Names{"bias", "vjp:bias"}));
}

TEST(CasadiRequest, IsDynamicsAndKinematicsIfNothingIsAskedFor) {
  const FunctionsNeeded needed = functions_for_casadi(arm(), {});
  EXPECT_EQ(needed.functions.size(), 9U);
  EXPECT_EQ(needed.fused.size(), 3U);
}

TEST(CasadiRequest, LeavesOutWhatThereIsNot) {
  const FunctionsNeeded loops = functions_for_casadi(testing::model_of("five_bar.toml").mechanism, {"gravity"});
  EXPECT_EQ(loops.functions, Names{"gravity"});
  EXPECT_TRUE(loops.fused.empty());
  EXPECT_NE(loops.note.find("closed loops"), std::string::npos);
  EXPECT_THROW(functions_for_casadi(testing::model_of("five_bar.toml").mechanism, {"jac:gravity"}), Failure);
  EXPECT_EQ(functions_for_casadi(arm(), {"base_parameters"}).functions, Names{"base_parameters"});
}

}  // namespace
}  // namespace flatdyn
