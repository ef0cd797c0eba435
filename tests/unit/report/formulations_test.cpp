// SPDX-License-Identifier: GPL-2.0-or-later
// Reports name the formulations that cost less than others.
#include <gtest/gtest.h>

#include "report/describe.hpp"

namespace flatdyn {
namespace {

OptimisedFunction made_by(const char* name, const char* formulation) {
  OptimisedFunction made;
  made.function.name = name;
  made.function.formulation = formulation;
  return made;
}

TEST(Formulations, AreNamedWithTheirFunctions) {
  EXPECT_EQ(describe_formulations({made_by("gravity", "closed form"), made_by("forward_dynamics", "articulated bodies"),
                                   made_by("bias", kRecursion), made_by("jacobian", ""),
                                   made_by("coriolis_matrix", "closed form")}),
            "cheapest of several formulations: articulated bodies for forward_dynamics; closed form for gravity, "
            "coriolis_matrix\n\n");
}

TEST(Formulations, OfRecursionsAreNotWorthALine) {
  EXPECT_EQ(describe_formulations({made_by("bias", kRecursion), made_by("jacobian", "")}), "");
}

}  // namespace
}  // namespace flatdyn
