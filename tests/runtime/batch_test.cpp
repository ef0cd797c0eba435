// SPDX-License-Identifier: GPL-2.0-or-later
// Generated code over SIMD lanes. Compiled for any machine, and again with wider registers and OpenMP (CMakeLists.txt).
#include "flatdyn/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "flatdyn/reference/real50.hpp"
#include "panda.hpp"
#include "puma560.hpp"

namespace flatdyn {
namespace {

using Batch = xsimd::batch<double>;
using reference::Real50;

constexpr double kPi = 3.141592653589793;

bool can_run() {
#ifdef __AVX2__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

class BatchTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!can_run()) GTEST_SKIP() << "this machine has no AVX2";
  }
};

template <class T, class Function>
std::vector<T> evaluated(const std::vector<T>& x, Function function) {
  using Lane = xsimd::batch<T>;
  std::vector<T> y(x.size());
  for (std::size_t k = 0; k + Lane::size <= x.size(); k += Lane::size) {
    function(Lane::load_unaligned(&x[k])).store_unaligned(&y[k]);
  }
  return y;
}

template <class T>
double ulps(T value, const Real50& exact) {
  using Limits = std::numeric_limits<T>;
  const int exponent = std::max(Limits::min_exponent - 1, std::ilogb(exact.convert_to<double>()));
  return Real50(abs(value - exact)).convert_to<double>() / std::ldexp(1.0, exponent - (Limits::digits - 1));
}

template <class T>
void expect_sines_and_cosines(double most_ulps) {
  std::mt19937_64 engine(1);
  for (const double range : {1e-8, 1.0, 4.0, 60.0, 1e3, kReducedAngles}) {
    std::uniform_real_distribution<double> uniform(-range, range);
    std::vector<T> x(2048);
    for (std::size_t k = 0; k < x.size(); ++k) {
      double angle = uniform(engine);
      // Angles near zeros and maxima, and near the places where one polynomial replaces the other.
      if (k % 2 == 1) angle = std::clamp(std::nearbyint(angle / (kPi / 4)) * (kPi / 4), -range, range);
      x[k] = static_cast<T>(angle);
    }
    const auto s = evaluated(x, [](const auto& a) { return sine(a); });
    const auto c = evaluated(x, [](const auto& a) { return cosine(a); });
    for (std::size_t k = 0; k < x.size(); ++k) {
      EXPECT_LT(ulps(s[k], sin(Real50(x[k]))), most_ulps) << "sin " << x[k];
      EXPECT_LT(ulps(c[k], cos(Real50(x[k]))), most_ulps) << "cos " << x[k];
    }
  }
}

TEST_F(BatchTest, SinesAndCosinesAreRightToOneUlp) { expect_sines_and_cosines<double>(1); }

TEST_F(BatchTest, SinesAndCosinesInFloatAreRightToTwoUlps) { expect_sines_and_cosines<float>(2); }

TEST_F(BatchTest, SquareRootsAreThoseOfEachState) {
  const std::vector<double> x = {0, 0.01, 2, 1e300, 4, 1e-300, 0.5, 3};
  std::vector<double> roots(x.size());
  const auto take_root = [](const auto* from, auto* to) { *to = sqrt(*from); };
  for_each_state<double>(x.size(), take_root, in<1>(x.data(), x.size()), out<1>(roots.data(), x.size()));
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_EQ(roots[k], std::sqrt(x[k])) << x[k];
}

TEST_F(BatchTest, LargeAnglesAreLeftToTheLibraryAndSpoilNoOthers) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double large : {1.1e5, -1e15, 1e300}) {
    const auto s = evaluated(std::vector<double>(Batch::size, large), [](const Batch& a) { return sine(a); });
    EXPECT_EQ(s[0], std::sin(large));
  }
  for (const double special : {inf, -inf, std::nan("")}) {
    std::vector<double> x(Batch::size, 0.5);
    const auto alone = evaluated(x, [](const Batch& a) { return cosine(a); });
    x[0] = special;
    const auto mixed = evaluated(x, [](const Batch& a) { return cosine(a); });
    EXPECT_TRUE(std::isnan(mixed[0]));
    EXPECT_EQ(mixed[1], alone[1]);
  }
  const auto zero = evaluated(std::vector<double>(Batch::size, -0.0), [](const Batch& a) { return sine(a); });
  EXPECT_EQ(zero[0], 0);
  EXPECT_TRUE(std::signbit(zero[0]));
}

// Random entries: entry i of state k is at [i * states + k].
std::vector<double> random_entries(std::size_t entries, std::size_t states, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> uniform(-3, 3);
  std::vector<double> x(entries * states);
  for (double& value : x) value = uniform(engine);
  return x;
}

std::vector<double> panda_torques(std::size_t n, const std::vector<double>& q, const std::vector<double>& qd,
                                  const std::vector<double>& qdd) {
  std::vector<double> tau(7 * n);
  EXPECT_TRUE(for_each_state<double>(
      n, [](auto... of) { panda::inverse_dynamics(of...); }, in<7>(q.data(), n), in<7>(qd.data(), n),
      in<7>(qdd.data(), n), out<7>(tau.data(), n)));
  return tau;
}

TEST_F(BatchTest, EveryStateHasTheValueOfAScalarCall) {
  for (const std::size_t n : {1u, 2u, 3u, 5u, 8u, 9u, 64u, 1001u}) {
    const auto q = random_entries(7, n, 1), qd = random_entries(7, n, 2), qdd = random_entries(7, n, 3);
    const auto tau = panda_torques(n, q, qd, qdd);
    for (std::size_t k = 0; k < n; ++k) {
      double of_q[7], of_qd[7], of_qdd[7], of_tau[7];
      for (std::size_t i = 0; i < 7; ++i) {
        of_q[i] = q[i * n + k];
        of_qd[i] = qd[i * n + k];
        of_qdd[i] = qdd[i * n + k];
      }
      panda::inverse_dynamics(of_q, of_qd, of_qdd, of_tau);
      for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(tau[i * n + k], of_tau[i], 1e-12) << "state " << k;
    }
  }
}

TEST_F(BatchTest, StatesDoNotDependOnThoseBesideThem) {
  constexpr std::size_t n = 29;
  const auto q = random_entries(7, n, 1), qd = random_entries(7, n, 2), qdd = random_entries(7, n, 3);
  const auto tau = panda_torques(n, q, qd, qdd);
  const auto reversed = [](const std::vector<double>& x) {
    std::vector<double> y(x.size());
    for (std::size_t at = 0; at < x.size(); ++at) y[at] = x[at / n * n + n - 1 - at % n];
    return y;
  };
  EXPECT_EQ(reversed(panda_torques(n, reversed(q), reversed(qd), reversed(qdd))), tau);
}

TEST_F(BatchTest, FrictionHasTheSignOfEachStatesOwnSpeed) {
  const std::size_t n = 3;
  const std::vector<double> zero(6 * n, 0.0);
  std::vector<double> qd(6 * n, 0.0), tau(6 * n);
  qd[0] = 1e-9;
  qd[2] = -1e-9;
  for_each_state<double>(
      n, [](auto... of) { puma560::inverse_dynamics(of...); }, in<6>(zero.data(), n), in<6>(qd.data(), n),
      in<6>(zero.data(), n), out<6>(tau.data(), n));
  EXPECT_GT(tau[0], 1);
  EXPECT_EQ(tau[1], 0);
  EXPECT_LT(tau[2], -1);
}

TEST_F(BatchTest, ForwardDynamicsUndoesInverseDynamicsAndSaysSo) {
  const std::size_t n = 100;
  const auto q = random_entries(7, n, 1), qd = random_entries(7, n, 2), qdd = random_entries(7, n, 3);
  const auto tau = panda_torques(n, q, qd, qdd);
  std::vector<double> found(7 * n);
  const auto forward = [](auto... of) { return panda::forward_dynamics(of...); };
  EXPECT_TRUE(for_each_state<double>(n, forward, in<7>(q.data(), n), in<7>(qd.data(), n), in<7>(tau.data(), n),
                                     out<7>(found.data(), n)));
  for (std::size_t at = 0; at < found.size(); ++at) EXPECT_NEAR(found[at], qdd[at], 1e-8);
}

TEST_F(BatchTest, OneFalseAnswerIsSeenAndSpoilsItsStateOnly) {
  const auto all_below = [](const Lanes<double>* x, Lanes<double>* y) -> bool {
    y[0] = x[0];
    return x[0] < Lanes<double>(0.5);
  };
  for (const std::size_t wrong : {0u, 7u, 16u}) {
    std::vector<double> x(17, 0.0), y(17);
    EXPECT_TRUE(for_each_state<double>(x.size(), all_below, in<1>(x.data(), 17), out<1>(y.data(), 17)));
    x[wrong] = 1;
    EXPECT_FALSE(for_each_state<double>(x.size(), all_below, in<1>(x.data(), 17), out<1>(y.data(), 17)));
    for (std::size_t k = 0; k < y.size(); ++k) EXPECT_TRUE(k == wrong ? std::isnan(y[k]) : y[k] == x[k]) << k;
  }
}

TEST_F(BatchTest, ServesFloatsToo) {
  const std::size_t n = 21;
  const auto q = random_entries(7, n, 1);
  const std::vector<float> q_float(q.begin(), q.end());
  std::vector<float> g(7 * n);
  for_each_state<float>(
      n, [](auto... of) { panda::gravity(of...); }, in<7>(q_float.data(), n), out<7>(g.data(), n));
  for (std::size_t k = 0; k < n; ++k) {
    double of_q[7], of_g[7];
    for (std::size_t i = 0; i < 7; ++i) of_q[i] = static_cast<double>(q_float[i * n + k]);
    panda::gravity(of_q, of_g);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(static_cast<double>(g[i * n + k]), of_g[i], 1e-4);
  }
}

}  // namespace
}  // namespace flatdyn
