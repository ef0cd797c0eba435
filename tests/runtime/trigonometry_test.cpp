// SPDX-License-Identifier: GPL-2.0-or-later
// The sources of sines and cosines for generated code. Compiled for any machine, and again with AVX2 (CMakeLists.txt).
#include "flatdyn/trigonometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "panda.hpp"
#include "scara.hpp"

namespace flatdyn {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class TrigonometryTest : public ::testing::Test {
 protected:
  void SetUp() override {
#ifdef __AVX2__
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "this machine has no AVX2";
#endif
  }
};

// A state of the Panda.
const double kPositions[7] = {0.3, -0.7, 1.1, -2.2, 0.05, 3.1, -1.6};
const double kVelocities[7] = {0.5, -1.5, 2.0, 0.1, -0.2, 0.7, 2.6};
const double kAccelerations[7] = {7, -5, 3, 1, 0, -2, 20};

template <template <int...> class Joints, int... joint, class T>
void expect_sines(const T (&q)[10], T tolerance) {
  T s[10], c[10];
  std::fill_n(s, 10, T(5));
  std::fill_n(c, 10, T(5));
  TogetherSinCos()(q, Joints<joint...>(), s, c);
  std::vector<bool> asked(10, false);
  for (const int i : {joint...}) asked[static_cast<std::size_t>(i)] = true;
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(s[i], asked[i] ? std::sin(q[i]) : T(5), tolerance) << "joint " << i << " of " << sizeof...(joint);
    EXPECT_NEAR(c[i], asked[i] ? std::cos(q[i]) : T(5), tolerance) << "joint " << i << " of " << sizeof...(joint);
  }
}

template <class T>
void expect_sines_of_any_joints(T tolerance) {
  const T q[10] = {T(0.3), T(-9), T(1e4), T(0), T(2), T(-3), T(4), T(-5e4), T(6), T(7)};
  expect_sines<panda::Joints, 0>(q, tolerance);
  expect_sines<panda::Joints, 9>(q, tolerance);
  expect_sines<panda::Joints, 3, 4>(q, tolerance);
  expect_sines<panda::Joints, 1, 2, 3>(q, tolerance);
  expect_sines<panda::Joints, 2, 9, 4>(q, tolerance);
  expect_sines<panda::Joints, 0, 1, 2, 3, 4>(q, tolerance);
  expect_sines<panda::Joints, 0, 1, 3, 5, 6, 8, 9>(q, tolerance);
  expect_sines<panda::Joints, 1, 2, 3, 4, 5, 6, 7, 8, 9>(q, tolerance);
}

TEST_F(TrigonometryTest, TogetherWritesTheJointsAskedForAndNoOthers) {
  expect_sines_of_any_joints<double>(2e-16);
  expect_sines_of_any_joints<float>(2e-7F);
}

TEST_F(TrigonometryTest, TogetherLeavesLargeAnglesToTheLibrary) {
  const double q[3] = {1e12, 0.5, -1e300};
  double s[3], c[3];
  TogetherSinCos()(q, panda::Joints<0, 1, 2>(), s, c);
  EXPECT_EQ(s[0], std::sin(1e12));
  EXPECT_EQ(c[2], std::cos(-1e300));
  EXPECT_NEAR(s[1], std::sin(0.5), 1e-16);
}

TEST_F(TrigonometryTest, AllSourcesGiveTheSameTorques) {
  double expected[7], together[7], given[7], sine[7], cosine[7], unread[7];
  panda::PolynomialSinCos()(kPositions, panda::Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  std::fill_n(unread, 7, kNaN);
  panda::inverse_dynamics(kPositions, kVelocities, kAccelerations, expected);
  panda::inverse_dynamics(kPositions, kVelocities, kAccelerations, together, TogetherSinCos());
  panda::inverse_dynamics(unread, kVelocities, kAccelerations, given, panda::GivenSinCos<double>{sine, cosine});
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(together[i], expected[i], 1e-13 * 87);
    EXPECT_EQ(given[i], expected[i]);
  }
}

TEST_F(TrigonometryTest, PrismaticPositionsAreReadBesideGivenSines) {
  double computed[12], given[12], p[3], p_given[3], sine[4], cosine[4];
  double q[4] = {0.4, -1.2, 0.1, 2.0};
  scara::PolynomialSinCos()(q, scara::Joints<0, 1, 2, 3>(), sine, cosine);
  scara::forward_kinematics(scara::Parameters<double>{}, q, computed, p);
  q[0] = q[1] = q[3] = kNaN;
  scara::forward_kinematics(scara::Parameters<double>{}, q, given, p_given, scara::GivenSinCos<double>{sine, cosine});
  for (int i = 0; i < 9; ++i) EXPECT_EQ(given[i], computed[i]);
  EXPECT_EQ(p_given[2], p[2]);
}

// A policy of the user's own: this one counts.
struct Counting {
  int* calls;
  int* joints;

  template <class T, int... joint>
  void operator()(const T* q, panda::Joints<joint...> all, T* s, T* c) const {
    ++*calls;
    *joints += static_cast<int>(sizeof...(joint));
    panda::LibrarySinCos()(q, all, s, c);
  }
};

TEST_F(TrigonometryTest, IsAskedOnceForTheJointsThatCount) {
  int calls = 0, joints = 0;
  double g[7], expected[7];
  panda::gravity(kPositions, g, Counting{&calls, &joints});
  panda::gravity(kPositions, expected, panda::LibrarySinCos());
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(joints, 6);  // gravity is along the first axis
  for (int i = 0; i < 7; ++i) EXPECT_EQ(g[i], expected[i]);
}

}  // namespace
}  // namespace flatdyn
