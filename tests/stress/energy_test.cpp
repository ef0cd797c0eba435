// SPDX-License-Identifier: GPL-2.0-or-later
// The Panda falling freely, by its generated code: its energy is kept as accurately as the integrator allows, and Ḃ -
// 2C stays skew-symmetric.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "flatdyn/reference/tangent.hpp"
#include "panda.hpp"
#include "support/robot_models.hpp"
#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn::testing {
namespace {

constexpr std::size_t kJoints = 7;
using Vector = std::array<double, kJoints>;

struct FreeMotion {
  Vector q, qd;
};

Vector along(const Vector& x, double h, const Vector& slope) {
  Vector result;
  for (std::size_t i = 0; i < kJoints; ++i) result[i] = x[i] + h * slope[i];
  return result;
}

FreeMotion slope(const FreeMotion& state) {
  const Vector tau = {};
  FreeMotion result{state.qd, {}};
  EXPECT_TRUE(panda::forward_dynamics(state.q.data(), state.qd.data(), tau.data(), result.qd.data()));
  return result;
}

// The classical Runge–Kutta method of order 4.
FreeMotion stepped(const FreeMotion& s, double h) {
  const auto moved = [&s](double part, const FreeMotion& by) {
    return FreeMotion{along(s.q, part, by.q), along(s.qd, part, by.qd)};
  };
  const FreeMotion k1 = slope(s), k2 = slope(moved(h / 2, k1)), k3 = slope(moved(h / 2, k2)), k4 = slope(moved(h, k3));
  FreeMotion next = s;
  for (std::size_t i = 0; i < kJoints; ++i) {
    next.q[i] += h / 6 * (k1.q[i] + 2 * k2.q[i] + 2 * k3.q[i] + k4.q[i]);
    next.qd[i] += h / 6 * (k1.qd[i] + 2 * k2.qd[i] + 2 * k3.qd[i] + k4.qd[i]);
  }
  return next;
}

double energy(const FreeMotion& s) {
  return panda::kinetic_energy(s.q.data(), s.qd.data()) + panda::potential_energy(s.q.data());
}

// Ḃ, by the chain rule through the generated inertia matrix, in long double.
using Wide = long double;
std::array<Wide, kJoints * kJoints> inertia_rate(const FreeMotion& s) {
  using Tangent = reference::Tangent<Wide>;
  std::array<Tangent, kJoints> q;
  for (std::size_t i = 0; i < kJoints; ++i) q[i] = Tangent(Wide(s.q[i]), Wide(s.qd[i]));
  std::array<Tangent, kJoints * kJoints> B;
  panda::inertia_matrix(q.data(), B.data());
  std::array<Wide, kJoints * kJoints> rate;
  for (std::size_t k = 0; k < rate.size(); ++k) rate[k] = B[k].slope;
  return rate;
}

// The largest entry of the symmetric part of Ḃ - 2C, in units of the last place of the size of C's terms.
double asymmetry(const FreeMotion& s, const reference::Robot<double>& robot) {
  const auto dB = inertia_rate(s);
  std::array<double, kJoints * kJoints> C;
  panda::coriolis_matrix(s.q.data(), s.qd.data(), C.data());
  const auto vector = [](const Vector& v) {
    return reference::VectorX<double>(Eigen::Map<const Eigen::VectorXd>(v.data(), kJoints));
  };
  const reference::MatrixX<double> scale = reference::coriolis_magnitude(robot, vector(s.q), vector(s.qd));
  double worst = 0;
  for (std::size_t i = 0; i < kJoints; ++i) {
    for (std::size_t j = 0; j < kJoints; ++j) {
      const std::size_t k = kJoints * i + j, l = kJoints * j + i;
      const Wide sum = 2 * (dB[k] - Wide(C[k]) - Wide(C[l]));
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      const double size = 2 * (scale(row, column) + scale(column, row));
      worst = std::max(worst, std::abs(static_cast<double>(sum)) / (std::numeric_limits<double>::epsilon() * size));
    }
  }
  return worst;
}

constexpr double kSeconds = 60;

FreeMotion start() { return {{0.3, -0.6, 0.2, -1.8, 0.4, 1.2, -0.5}, {0.5, -0.3, 0.4, 0.2, -0.6, 0.3, 0.8}}; }

FreeMotion after(FreeMotion s, int steps, double h) {
  for (int k = 0; k < steps; ++k) s = stepped(s, h);
  return s;
}

// Free motion is chaotic: with another step it soon differs completely. So the two steps are compared over a quarter of
// a second at a time, from the same intermediate states.
TEST(FreeMotionOfThePanda, KeepsItsEnergyAsWellAsTheIntegratorAllows) {
  constexpr double kStep = 1e-3;
  constexpr int kSteps = 250;
  FreeMotion s = start();
  const double first = energy(s);
  double coarse = 0, fine = 0;
  const int parts = static_cast<int>(kSeconds / (kSteps * kStep));
  for (int k = 0; k < parts; ++k) {
    const double here = energy(s);
    coarse += std::abs(energy(after(s, kSteps, kStep)) - here);
    s = after(s, 2 * kSteps, kStep / 2);
    fine += std::abs(energy(s) - here);
  }
  const double total = energy(s) - first;
  std::printf(
      "%g s: energy %.6g J, at the end %.3g J more; changes per quarter of a second %.3g J, at half the step "
      "%.3g J: %.3g times less\n",
      kSeconds, first, total, coarse / parts, fine / parts, coarse / fine);
  // The method has order 4, so half the step gives a sixteenth of the error.
  EXPECT_GT(coarse / fine, 14);
  EXPECT_LT(coarse / fine, 36);
  EXPECT_LT(std::abs(total), 1e-3);
}

TEST(FreeMotionOfThePanda, KeepsInertiaRateLessTwiceCoriolisSkew) {
  const reference::Robot<double> robot = reference_robot<double>(model_of("panda.urdf").robot, {});
  FreeMotion s = start();
  double worst = 0;
  const int steps = static_cast<int>(1000 * kSeconds);
  for (int k = 0; k < steps; ++k) {
    s = stepped(s, 1e-3);
    if (k % 10 == 0) worst = std::max(worst, asymmetry(s, robot));
  }
  std::printf("largest scaled asymmetry: %.3g\n", worst);
  EXPECT_LT(worst, 16);
}

}  // namespace
}  // namespace flatdyn::testing
