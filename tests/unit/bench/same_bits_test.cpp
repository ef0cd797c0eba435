// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/diagnostics/diagnostics.hpp"
#include "laboratory/bench/variants.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::ElementsAre;

TEST(SameBits, AreThoseOfThePlainForms) {
  std::vector<std::string> plain;
  for (const BenchVariant& variant : bench_variants()) {
    if (has_plain_bits(variant)) plain.emplace_back(variant.name);
  }
  EXPECT_THAT(plain, ElementsAre("double", "double-native", "float", "cuda-double", "cuda-float"));
}

TEST(SameBits, DifferInTheLastPlaceAndTheSignOfZero) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const VariantResult like{"double", {1, 0, none}};
  EXPECT_NO_THROW(check_same_bits("gravity", like, {"cuda-double", {1, 0, -none}}));
  EXPECT_THROW(check_same_bits("gravity", like, {"cuda-double", {std::nextafter(1.0, 2), 0, none}}), Failure);
  EXPECT_THROW(check_same_bits("gravity", like, {"cuda-double", {1, -0.0, none}}), Failure);
  EXPECT_THROW(check_same_bits("gravity", like, {"cuda-double", {1, 0, 0}}), Failure);
}

TEST(SameBits, AreWhatFunctionsReturnAndTheirEntriesThere) {
  const VariantResult fails{"double", {1}, false};
  EXPECT_NO_THROW(check_same_bits("gravity", fails, {"cuda-double", {2}, false}));
  EXPECT_THROW(check_same_bits("gravity", fails, {"cuda-double", {1}, true}), Failure);
}

}  // namespace
}  // namespace flatdyn::testing
