// SPDX-License-Identifier: GPL-2.0-or-later
// Error bounds that can be added up by hand, and what Gappa says of them.
#include "certify/error_terms.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "certify/gappa.hpp"

namespace flatdyn {
namespace {

constexpr double kSeconds = 60;  // for Gappa, more than enough

// (x + y) z with |x|, |y| <= 0.7 and |z| <= 3.
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

// The sum is within 1.4, so its error is u; it reaches the product three times. The product is within 4.2: 4 u.
TEST_P(SumTimesThree, HasTheErrorThatIsAddedUpByHand) {
  const OutputError error = analysis_->error_of(output_);
  const double u = std::ldexp(1.0, -format_.precision);
  ASSERT_EQ(error.terms.size(), 2u);
  EXPECT_EQ(error.terms[0].error, u);
  EXPECT_EQ(error.terms[1].error, 4 * u);
  EXPECT_NEAR(error.terms[0].sensitivity, 3, 0.005);
  EXPECT_NEAR(error.terms[1].sensitivity, 1, 0.002);
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
  EXPECT_THAT(ask_gappa(scripts, kSeconds), ::testing::Each(Verdict::proven));
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
  EXPECT_THAT(ask_gappa(scripts, kSeconds), ::testing::Each(Verdict::refused));
}

INSTANTIATE_TEST_SUITE_P(Scalars, SumTimesThree, ::testing::Values("double", "float"),
                         [](const auto& of) { return of.param; });

// x y - y x: the two products are one operation, and nothing is left of its error.
TEST(ErrorAnalysis, SeesErrorsThatCancel) {
  StraightLine lines;
  const int x = lines.input({InputKind::qd, 0}), y = lines.input({InputKind::qd, 1});
  const int product = lines.multiply(x, y);
  const int output = lines.subtract(lines.add(product, x), product);
  ErrorAnalysis analysis(lines, {rounding_format("double"), 0x1p-53, [](double) { return 0.0; }},
                         [](const Input&) { return 1.5; });
  const OutputError error = analysis.error_of(output);
  ASSERT_EQ(error.terms.size(), 2u);  // those of the sum and of the difference
  EXPECT_GT(error.terms.front().operation, product);
}

// c x: errors of the cosine, of the constant and of two roundings.
TEST(ErrorAnalysis, CountsSinesAndConstants) {
  StraightLine lines;
  const int constant = lines.constant(0.1), cosine = lines.cosine(0), x = lines.input({InputKind::qd, 0});
  const int output = lines.multiply(constant, lines.multiply(cosine, x));
  ErrorAnalysis analysis(lines, {rounding_format("double"), 0x1p-53, [](double) { return 1e-18; }},
                         [](const Input&) { return 1.5; });
  const OutputError error = analysis.error_of(output);
  ASSERT_EQ(error.terms.size(), 4u);
  EXPECT_EQ(error.terms[0].error, 1e-18);  // reaches the output by 1.5
  EXPECT_NEAR(error.terms[0].sensitivity, 1.5, 0.003);
  const double by_hand = 1.5e-18 + 0x1p-53 * 0.15 + 0x1p-53 * 0.1 + 0x1p-56;
  EXPECT_GE(error.bound, by_hand);
  EXPECT_LE(error.bound, 1.005 * by_hand);
}

}  // namespace
}  // namespace flatdyn
