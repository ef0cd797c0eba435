// SPDX-License-Identifier: GPL-2.0-or-later
// Where batches read and write: tiles, columns, and outputs without zeros. Compiled for any machine, and again with
// wider registers and OpenMP (CMakeLists.txt).
#include "flatdyn/states.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "flatdyn/batch.hpp"
#include "panda.hpp"
#include "quadruped12.hpp"

namespace flatdyn {
namespace {

constexpr bool kTable[9] = {1, 0, 1,  //
                            0, 1, 0,  //
                            1, 0, 1};
using Kept = NonzeroEntries<kTable>;
using Half = SymmetricEntries<kTable>;

static_assert(Kept::count == 5 && Kept::entry_at(1) == 2 && Kept::place(8) == 4 && Kept::place(5) == -1);
static_assert(Half::count == 4 && Half::entry_at(2) == 4 && Half::length == 9);
static_assert(Half::place(6) == Half::place(2) && Half::place(2) == 1 && Half::place(3) == -1);
static_assert(tiles_length<double, 7>(9) == 7 * 16 && tiles_length<float, 7>(9) == 7 * 16);
static_assert(tiles_length<double, Kept, 64>(65) == 5 * 128);
static_assert(padded_stride<double>(1024) == 129 * 8 && padded_stride<double>(1) == 8);
static_assert(padded_stride<float>(1024) == 65 * 16 && padded_stride<float>(17) == 3 * 16);

constexpr double kUntouched = 1234.5;

class StatesTest : public ::testing::Test {
 protected:
  void SetUp() override {
#ifdef __AVX2__
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "this machine has no AVX2";
#endif
  }
};

std::vector<double> entries_at_random(std::size_t length) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(-3, 3);
  std::vector<double> rows(length);
  for (double& x : rows) x = uniform(engine);
  return rows;
}

// The arguments of n states in a layout, from rows of one state after the other.
template <int entries, class Array>
void fill(const Array& array, const std::vector<double>& rows, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    for (int i = 0; i < entries; ++i) array.at(i, k) = rows[k * entries + static_cast<std::size_t>(i)];
  }
}

template <class Array>
void expect_inertia(const std::vector<double>& q, std::size_t n, const Array& B) {
  for (std::size_t k = 0; k < n; ++k) {
    double of_k[49];
    panda::inertia_matrix(&q[7 * k], of_k);
    for (int entry = 0; entry < 49; ++entry) EXPECT_NEAR(B.at(entry, k), of_k[entry], 1e-13) << entry << " of " << k;
  }
}

TEST_F(StatesTest, EveryLayoutHasTheEntriesOfSingleCalls) {
  using Upper = SymmetricEntries<panda::inertia_matrix_nonzero>;
  const auto inertia = [](auto... of) { panda::inertia_matrix(of...); };
  for (const std::size_t n : {1u, 8u, 13u, 70u}) {
    const std::vector<double> rows = entries_at_random(7 * n);
    const std::size_t stride = padded_stride<double>(n);
    std::vector<double> columns(7 * stride), tiles(tiles_length<double, 7>(n)), B_columns(49 * stride);
    std::vector<double> B(tiles_length<double, 49, 64>(n)), upper(tiles_length<double, Upper>(n));
    fill<7>(out<7>(columns.data(), stride), rows, n);
    fill<7>(out_tiles<7>(tiles.data()), rows, n);
    for_each_state<double>(n, inertia, in<7>(columns.data(), stride), out_tiles<49, 64>(B.data()));
    for_each_state<double>(n, inertia, in_tiles<7>(tiles.data()), out<49>(B_columns.data(), stride));
    for (std::size_t first = 0; first < n; first += 8) {
      for_each_state<double>(std::min<std::size_t>(8, n - first), inertia, in_tiles<7>(tiles.data()).from(first),
                             out_tiles<Upper>(upper.data()).from(first));
    }
    expect_inertia(rows, n, out_tiles<49, 64>(B.data()));
    expect_inertia(rows, n, out<49>(B_columns.data(), stride));
    expect_inertia(rows, n, out_tiles<Upper>(upper.data()));
  }
}

TEST_F(StatesTest, NothingElseIsWritten) {
  using Upper = SymmetricEntries<quadruped12::inertia_matrix_nonzero>;
  static_assert(Upper::count == 24 && Upper::length == 144, "four legs do not know of each other");
  const std::size_t n = 3, stride = 8;
  const std::vector<double> q(12 * stride, 0.5);
  std::vector<double> B(tiles_length<double, Upper>(n), kUntouched), in_columns(Upper::count * stride, kUntouched);
  const auto inertia = [](auto... of) { quadruped12::inertia_matrix(of...); };
  for_each_state<double>(n, inertia, in<12>(q.data(), stride), out_tiles<Upper>(B.data()));
  for_each_state<double>(n, inertia, in<12>(q.data(), stride), out<Upper>(in_columns.data(), stride));
  EXPECT_EQ(std::count(B.begin(), B.end(), kUntouched), static_cast<long>((stride - n) * Upper::count));
  EXPECT_EQ(B, in_columns);
}

TEST_F(StatesTest, OneFalseAnswerSpoilsItsPackedStateOnly) {
  const auto all_below = [](const Lanes<double>* x, Lanes<double>* y) -> bool {
    for (int i = 0; i < 9; ++i) y[i] = x[0];
    return x[0] < Lanes<double>(0.5);
  };
  const std::size_t n = 11, wrong = 9;
  std::vector<double> x(tiles_length<double, 1>(n), 0.0), y(tiles_length<double, Half>(n));
  out_tiles<1>(x.data()).at(0, wrong) = 1;
  const auto packed = out_tiles<Half>(y.data());
  EXPECT_FALSE(for_each_state<double>(n, all_below, in_tiles<1>(x.data()), packed));
  for (std::size_t k = 0; k < n; ++k) {
    for (const int entry : {0, 2, 4, 6, 8}) EXPECT_EQ(std::isnan(packed.at(entry, k)), k == wrong) << k;
  }
}

// Sines and cosines of angles, one per state, over lanes and by single calls of the generated code's own.
template <class T>
void expect_same_sines(const std::vector<T>& angles) {
  using Eight = panda::Joints<0, 1, 2, 3, 4, 5, 6, 7>;
  const std::size_t n = angles.size() / 8;
  std::vector<T> q(tiles_length<T, 8>(n)), s(q.size()), c(q.size());
  for (std::size_t at = 0; at < angles.size(); ++at) {
    out_tiles<8>(q.data()).at(static_cast<int>(at % 8), at / 8) = angles[at];
  }
  const auto of_lanes = [](auto x, auto sine, auto cosine) { AsWrittenSinCos()(x, Eight(), sine, cosine); };
  for_each_state<T>(n, of_lanes, in_tiles<8>(q.data()), out_tiles<8>(s.data()), out_tiles<8>(c.data()));
  for (std::size_t k = 0; k < n; ++k) {
    T sine[8], cosine[8];
    panda::PolynomialSinCos()(&angles[8 * k], Eight(), sine, cosine);
    for (int i = 0; i < 8; ++i) {
      const T of_sine = out_tiles<8>(s.data()).at(i, k);
      EXPECT_EQ(of_sine, sine[i]) << angles[8 * k + static_cast<std::size_t>(i)];
      EXPECT_EQ(std::signbit(of_sine), std::signbit(sine[i])) << angles[8 * k + static_cast<std::size_t>(i)];
      EXPECT_EQ(out_tiles<8>(c.data()).at(i, k), cosine[i]) << angles[8 * k + static_cast<std::size_t>(i)];
    }
  }
}

TEST_F(StatesTest, SinesAsWrittenHaveTheBitsOfSingleCalls) {
  std::vector<double> angles = entries_at_random(8 * 1000);
  for (std::size_t k = 0; k < angles.size(); k += 3) angles[k] *= 1000;
  angles[0] = -0.0;
  angles[1] = 2e5;
  expect_same_sines(angles);
  expect_same_sines(std::vector<float>(angles.begin(), angles.end()));
}

}  // namespace
}  // namespace flatdyn
