// SPDX-License-Identifier: GPL-2.0-or-later
#include "flatdyn/reference/mpfr_real.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace flatdyn::reference {
namespace {

using Real = MpfrReal<201>;
constexpr int kFloatBits = std::numeric_limits<float>::digits;

TEST(MpfrReal, In24BitsOperationsGiveTheBitsOfFloat) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> number(-100, 100);
  const Real::Precision of_float(kFloatBits);
  for (int k = 0; k < 1000; ++k) {
    const float a = number(engine), b = number(engine);
    const Real x(a), y(b);
    ASSERT_EQ((x + y).convert_to<double>(), double(a + b));
    ASSERT_EQ((x - y).convert_to<double>(), double(a - b));
    ASSERT_EQ((x * y).convert_to<double>(), double(a * b));
    ASSERT_EQ((x / y).convert_to<double>(), double(a / b));
    ASSERT_EQ(sqrt(x * x).convert_to<double>(), double(std::sqrt(a * a)));
  }
}

TEST(MpfrReal, InAPrecisionNumbersAndCopiesAreRounded) {
  const Real third = Real(1) / 3;
  std::vector<Real> numbers = {third};
  {
    const Real::Precision of_float(kFloatBits);
    const Real copy = third;
    EXPECT_EQ(copy.convert_to<double>(), double(1.0F / 3.0F));
    EXPECT_EQ(Real("0.1").convert_to<double>(), double(0.1F));
    EXPECT_EQ(std::numeric_limits<Real>::epsilon(), double(std::numeric_limits<float>::epsilon()));
    numbers = std::vector<Real>(numbers);
    {
      const Real::Precision longer_than_there_is(1000);
      EXPECT_EQ(Real(third), third);
    }
    EXPECT_NE(Real(third), third);
  }
  EXPECT_EQ(numbers[0].convert_to<double>(), double(1.0F / 3.0F));
  numbers[0] = third;
  EXPECT_EQ(numbers[0], third);
  EXPECT_EQ(Real(1) / 3, third);
}

}  // namespace
}  // namespace flatdyn::reference
