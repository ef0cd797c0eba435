// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/combinations.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

// y = 2 a - b is a combination of the columns a and b. Only the field shows that y + 1e-13 a² is none.
TEST(Combinations, AreDecidedExactly) {
  std::vector<std::vector<Combinations::F>> D;
  std::vector<Combinations::F> y, nearly;
  Eigen::MatrixXd real(8, 2);
  Eigen::VectorXd real_y(8);
  for (int k = 0; k < 8; ++k) {
    const int a = k * k + 1, b = 3 * k - 7;
    const auto in_field = [](int x) {
      return x < 0 ? -Combinations::F(static_cast<std::uint64_t>(-x)) : Combinations::F(static_cast<std::uint64_t>(x));
    };
    D.push_back({in_field(a), in_field(b)});
    real.row(k) << a, b;
    y.push_back(in_field(2 * a - b));
    nearly.push_back(y.back() + in_field(a * a) * Combinations::F::from(Rational("1/10000000000000")));
    real_y(k) = 2 * a - b;
  }
  const Combinations combinations(D, real);
  const std::optional<Combinations::Found> found = combinations.of(y, real_y);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->coefficients(0), 2, 1e-12);
  EXPECT_NEAR(found->coefficients(1), -1, 1e-12);
  EXPECT_LT(found->error_bound, 1e-8);
  EXPECT_FALSE(combinations.of(nearly, real_y));
}

}  // namespace
}  // namespace flatdyn
