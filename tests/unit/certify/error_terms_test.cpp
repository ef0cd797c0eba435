// SPDX-License-Identifier: GPL-2.0-or-later
// Error bounds that can be added up by hand, and Gappa's results for them.
#include "proof/certify/error_terms.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/diagnostics/diagnostics.hpp"
#include "proof/certify/gappa.hpp"

namespace flatdyn {
namespace {

constexpr double kSeconds = 60;  // for Gappa, more than enough

double only_error(const ErrorGroup& group) {
  return group.components.size() == 1 && group.components[0].size() == 1 ? group.components[0][0].error : NAN;
}

// The function (x + y) z with |x|, |y| <= 0.7 and |z| <= 3.
class SumTimesThree : public ::testing::TestWithParam<const char*> {
 protected:
  SumTimesThree() : format_(rounding_format(GetParam())) {
    StraightLine lines;
    const int sum = lines.add(lines.input({InputKind::qd, 0}), lines.input({InputKind::qd, 1}));
    output_ = lines.multiply(sum, lines.input({InputKind::qd, 2}));
    analysis_ = std::make_unique<ErrorAnalysis>(
        lines, RoundingModel{format_, std::ldexp(1.0, -format_.precision), [](double) { return 0.0; }},
        [](const Input& input) { return input.index == 2 ? 3.0 : 0.7; });
  }

  const RoundingFormat& format_;
  int output_ = 0;
  std::unique_ptr<ErrorAnalysis> analysis_;
};

// The sum is within 1.4, so its error is u, which the product multiplies by three. The product is within 4.2: 4 u.
TEST_P(SumTimesThree, HasTheErrorThatIsAddedUpByHand) {
  const OutputError error = analysis_->error_of(output_);
  const double u = std::ldexp(1.0, -format_.precision);
  ASSERT_EQ(error.groups.size(), 2u);
  EXPECT_EQ(only_error(error.groups[0]), u);
  EXPECT_EQ(only_error(error.groups[1]), 4 * u);
  EXPECT_NEAR(error.groups[0].sensitivity, 3, 0.005);
  EXPECT_NEAR(error.groups[1].sensitivity, 1, 0.002);
  EXPECT_GE(error.bound, 7 * u);
  EXPECT_LE(error.bound, 7.02 * u);
}

TEST_P(SumTimesThree, IsProvenByGappa) {
  ASSERT_TRUE(has_gappa()) << "scripts/setup installs it";
  const OutputError error = analysis_->error_of(output_);
  std::vector<GappaScript> scripts = rounding_scripts("f", *analysis_, format_);
  ASSERT_EQ(scripts.size(), 1u);
  EXPECT_THAT(scripts[0].text, ::testing::HasSubstr("rnd(qd_1 + qd_2) - (qd_1 + qd_2)"));
  scripts.push_back(sum_script("f", "tau[0]", "N m", error));
  EXPECT_EQ(scripts[1].name, "f.tau_0.g");
  EXPECT_THAT(run_gappa(scripts, kSeconds), ::testing::Each(Verdict::proven));
}

TEST_P(SumTimesThree, WithABoundThatIsTooSmallIsRefused) {
  OutputError error = analysis_->error_of(output_);
  error.bound /= 2;
  std::vector<GappaScript> scripts = {sum_script("f", "tau[0]", "N m", error)};
  GappaScript roundings = rounding_scripts("f", *analysis_, format_).front();
  const std::string of_sum = fmt::format("[-1b{0}, 1b{0}]", -format_.precision);
  const std::size_t at = roundings.text.find(of_sum);
  ASSERT_NE(at, std::string::npos) << roundings.text;
  roundings.text.replace(at, of_sum.size(), fmt::format("[-1b{0}, 1b{0}]", -format_.precision - 1));
  scripts.push_back(roundings);
  EXPECT_THAT(run_gappa(scripts, kSeconds), ::testing::Each(Verdict::refused));
}

INSTANTIATE_TEST_SUITE_P(Scalars, SumTimesThree, ::testing::Values("double", "float"),
                         [](const auto& of) { return of.param; });

// x y - y x: the two products are one operation, and its error cancels.
TEST(ErrorAnalysis, SeesErrorsThatCancel) {
  StraightLine lines;
  const int x = lines.input({InputKind::qd, 0}), y = lines.input({InputKind::qd, 1});
  const int product = lines.multiply(x, y);
  const int output = lines.subtract(lines.add(product, x), product);
  ErrorAnalysis analysis(lines, {rounding_format("double"), 0x1p-53, [](double) { return 0.0; }},
                         [](const Input&) { return 1.5; });
  const OutputError error = analysis.error_of(output);
  EXPECT_EQ(error.terms(), 2);  // those of the sum and of the difference
  EXPECT_GT(error.groups.front().components[0][0].operation, product);
}

// c x: errors of the cosine, of the constant and of two roundings.
TEST(ErrorAnalysis, CountsSinesAndConstants) {
  StraightLine lines;
  const int constant = lines.constant(0.1), cosine = lines.cosine(0), x = lines.input({InputKind::qd, 0});
  const int output = lines.multiply(constant, lines.multiply(cosine, x));
  ErrorAnalysis analysis(lines, {rounding_format("double"), 0x1p-53, [](double) { return 1e-18; }},
                         [](const Input&) { return 1.5; });
  const OutputError error = analysis.error_of(output);
  ASSERT_EQ(error.groups.size(), 4u);
  EXPECT_EQ(only_error(error.groups[0]), 1e-18);  // reaches the output with factor 1.5
  EXPECT_NEAR(error.groups[0].sensitivity, 1.5, 0.003);
  const double by_hand = 1.5e-18 + 0x1p-53 * 0.15 + 0x1p-53 * 0.1 + 0x1p-56;
  EXPECT_GE(error.bound, by_hand);
  EXPECT_LE(error.bound, 1.005 * by_hand);
}

// c (x + u) - s (y + v), then times z: the errors of both sums form a vector, which is rotated and does not grow.
TEST(ErrorAnalysis, BoundsErrorsOfAVectorTogether) {
  StraightLine lines;
  const auto speed = [&lines](int k) { return lines.input({InputKind::qd, k}); };
  const int c = lines.cosine(0), s = lines.sine(0);
  const int x = lines.add(speed(0), speed(1)), y = lines.add(speed(2), speed(3));
  const int output = lines.multiply(lines.subtract(lines.multiply(c, x), lines.multiply(s, y)), speed(4));
  ErrorAnalysis analysis(lines, {rounding_format("double"), 0, [](double) { return 0.0; }},
                         [](const Input& input) { return input.index == 4 ? 3.0 : 0.9; });
  const OutputError error = analysis.error_of(output);
  const auto vector = std::find_if(error.groups.begin(), error.groups.end(),
                                   [](const ErrorGroup& group) { return group.components.size() == 2; });
  ASSERT_NE(vector, error.groups.end());
  EXPECT_EQ(vector->components[0][0].operation, x);
  EXPECT_EQ(vector->components[1][0].operation, y);
  const double by_hand = 3 * std::hypot(0x1p-53, 0x1p-53);  // and not twice 3 * 2^-53
  EXPECT_NEAR(vector->bound, by_hand, 0.005 * by_hand);
  const GappaScript script = sum_script("f", "tau[0]", "N m", error);
  EXPECT_THAT(script.text, ::testing::HasSubstr(fmt::format("sqrt(r{0} * r{0} + r{1} * r{1})", x, y)));
  EXPECT_THAT(run_gappa({script}, kSeconds), ::testing::Each(Verdict::proven));
}

// 2^k x is exact, but it may overflow all the same.
TEST(ErrorAnalysis, RefusesExactProductsThatOverflow) {
  StraightLine lines;
  const int output = lines.multiply(lines.constant(0x1p40), lines.input({InputKind::qd, 0}));
  const auto bound_of = [&](double limit) {
    ErrorAnalysis analysis(lines, {rounding_format("float"), 0x1p-24, [](double) { return 0.0; }},
                           [limit](const Input&) { return limit; });
    return analysis.error_of(output).bound;
  };
  EXPECT_EQ(bound_of(1e20), 0);
  EXPECT_THROW(bound_of(1e30), Failure);
}

// x y z of 1e-120 each is 0 in double; its bound is not, and neither is that of its error.
TEST(ErrorAnalysis, BoundsOfTinyNumbersDoNotVanish) {
  StraightLine lines;
  const auto speed = [&lines](int k) { return lines.input({InputKind::qd, k}); };
  const int output = lines.multiply(lines.multiply(speed(0), speed(1)), speed(2));
  ErrorAnalysis analysis(lines, {rounding_format("double"), 0x1p-53, [](double) { return 0.0; }},
                         [](const Input&) { return 1e-120; });
  const OutputError error = analysis.error_of(output);
  EXPECT_EQ(error.terms(), 2);
  EXPECT_GT(analysis.norms().largest(output), 0);
  EXPECT_GT(error.bound, 0);
}

// Many operations read a sine: its derivative is at most the sum over them.
TEST(ErrorAnalysis, ADerivativeIsNoLargerThanItsReadersAllow) {
  StraightLine lines;
  const int c = lines.cosine(0), s = lines.sine(0);
  int sum = lines.input({InputKind::qd, 0});
  for (int k = 1; k < 6; ++k) {
    const int turned = lines.multiply(k % 2 == 0 ? c : s, sum);
    sum = lines.add(turned, lines.input({InputKind::qd, k}));
  }
  constexpr int kEnough = 16;  // enough for the sizes of the sums
  ErrorAnalysis analysis(
      lines, {rounding_format("double"), 0x1p-53, [](double) { return 0.0; }}, [](const Input&) { return 1.0; },
      nullptr, kEnough);
  const OutputError error = analysis.error_of(sum);
  double of_sines = 0;
  for (const ErrorGroup& group : error.groups) {
    for (const AlikeErrors& alike : group.components) {
      if (alike[0].operation == c || alike[0].operation == s) of_sines = std::max(of_sines, group.sensitivity);
    }
  }
  EXPECT_GT(of_sines, 0);
  EXPECT_LE(of_sines, 1.005 * (5 + 3 + 1));  // sums of 1, 3, and 5 numbers are multiplied by s
}

}  // namespace
}  // namespace flatdyn
