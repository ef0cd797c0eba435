// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/dialect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "code/languages/c/dialect.hpp"
#include "code/languages/c/lanes_dialect.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/languages/javascript/dialect.hpp"
#include "support/emitted_forms.hpp"
#include "unit/emit/hand_made.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Dialect, WritesLiterals) {
  EXPECT_EQ(CppDialect().literal(Rational(-1, 4)), "Scalar(-0.25)");
  EXPECT_EQ(CDialect("double", "arm").literal(Rational(-1, 4)), "-0.25");
  EXPECT_EQ(CDialect("float", "arm").literal(Rational(2)), "2.0f");
  EXPECT_EQ(CDialect("float", "arm").infinity(true), "-HUGE_VALF");
}

// A literal rounds like a cast from double: one tenth in float, with as many digits as distinguish it from its
// neighbours.
TEST(Dialect, RoundsToFloatByWayOfDouble) {
  EXPECT_EQ(CDialect("float", "arm").literal(Rational(1, 10)), "0.1f");
  // A number slightly above the middle of two floats whose nearest double is that middle: half to even.
  const Rational middle = 1 + Rational(1, 1 << 24);
  const Rational above = middle + Rational(1, Rational::Integer(1) << 80);
  EXPECT_EQ(CDialect("float", "arm").literal(above), "1.0f");
  EXPECT_THROW(CDialect("float", "arm").literal(Rational(Rational::Integer(1) << 128)), Failure);
}

TEST(Dialect, MakesPrefixesOfNamespaces) {
  EXPECT_EQ(CDialect("double", "acme::arm").global("gravity"), "acme_arm_gravity");
  EXPECT_EQ(CDialect("double", "class_").global("gravity"), "class_gravity");
  EXPECT_EQ(CDialect("double", "acme::arm").count_name("joint_count"), "ACME_ARM_JOINT_COUNT");
  EXPECT_EQ(CppDialect().global("gravity"), "gravity");
}

TEST(Dialect, TakesSquareRootsFromTheLibrary) {
  EXPECT_EQ(CppDialect().sqrt("x"), "detail::sqrt(x)");
  EXPECT_EQ(CDialect("double", "arm").sqrt("x"), "sqrt(x)");
  EXPECT_EQ(CDialect("float", "arm").sqrt("x"), "sqrtf(x)");
  EXPECT_EQ(JavascriptDialect().sqrt("x"), "Math.sqrt(x)");
}

// Vectors of GNU C: every scalar constant must be spread over lanes.
TEST(Dialect, SpreadsNumbersOverLanes) {
  const LanesDialect lanes("float", "arm");
  EXPECT_EQ(lanes.scalar(), "arm_lanes");
  EXPECT_EQ(lanes.number(), "float");
  EXPECT_EQ(lanes.literal(Rational(-1, 4)), "arm_lanes_all(-0.25f)");
  EXPECT_EQ(lanes.parameter("m_1"), "arm_lanes_all(parameters->m_1)");
  EXPECT_EQ(lanes.parameters_argument(), "const arm_parameters* parameters");
  EXPECT_EQ(lanes.sqrt("x"), "arm_lanes_sqrt(x)");
  EXPECT_EQ(lanes.conditions_begin() + lanes.always(), "arm_lanes_mask valid = ~(arm_lanes_mask){0}");
  EXPECT_EQ(CDialect("float", "arm").conditions_begin() + CppDialect().always(), "bool valid = true");
}

EmitOptions in_c() {
  EmitOptions options;
  options.language = "c";
  return options;
}

TEST(CText, AsksTheLibraryInOnePlace) {
  const testing::HeaderAndSource text =
      testing::emit_c(testing::two_link_mechanism({"m1"}), {testing::two_link_inertia_matrix()}, in_c());
  EXPECT_THAT(text.header, HasSubstr("void two_link_arm_inertia_matrix(const two_link_arm_parameters* parameters,"));
  EXPECT_THAT(text.header, HasSubstr("// The same from sine[k] = sin(q[k]) and cosine[k] = cos(q[k]) of the caller's, "
                                     "k = 1.\n"));
  EXPECT_THAT(text.header, Not(HasSubstr("restrict ")));
  EXPECT_THAT(text.source, HasSubstr("  two_link_arm_sines_and_cosines(q, 1, 1, sine, cosine);\n"
                                     "  two_link_arm_inertia_matrix_given(parameters, sine, cosine, B, D);\n"));
  EXPECT_THAT(text.source, HasSubstr("  (void)parameters;\n  (void)sine;\n"));
  EXPECT_EQ(text.source.find("cos(q["), text.source.rfind("cos(q["));
}

TEST(CText, NamesNeverCollide) {
  Function gravity = testing::pendulum_gravity(), other = gravity;
  gravity.name = "gravity";
  other.name = "gravity:given";
  const testing::HeaderAndSource text = testing::emit_c(testing::two_link_mechanism({"m1"}), {gravity, other}, in_c());
  EXPECT_THAT(text.header, HasSubstr("two_link_arm_gravity_given("));
  EXPECT_THAT(text.header, HasSubstr("two_link_arm_gravity_given_2("));
  EXPECT_THAT(text.header, HasSubstr("two_link_arm_gravity_given_2_given("));
}

}  // namespace
}  // namespace flatdyn
