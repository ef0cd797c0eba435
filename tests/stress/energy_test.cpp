// SPDX-License-Identifier: GPL-2.0-or-later
// The Panda falling freely, by its generated code: its energy is kept as well as the integrator allows, and Ḃ - 2C
// stays skew-symmetric. FLATDYN_ENERGY_SECONDS=60 is the long form.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "flatdyn/reference/magnitude.hpp"
#include "panda.hpp"
#include "support/robot_models.hpp"
#include "verify/reference_model.hpp"

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

// The classical method of Runge and Kutta, of order 4.
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

// Σ_k ∂B/∂q_k q̇_k is Σ_k (c_ijk + c_jik) q̇_k: exact, from the Christoffel symbols that B has of itself; here from B by
// differences in long double, whose step loses half the digits of that.
using Wide = long double;
std::array<Wide, kJoints * kJoints> inertia(const FreeMotion& s, Wide t) {
  std::array<Wide, kJoints> q;
  for (std::size_t i = 0; i < kJoints; ++i) q[i] = Wide(s.q[i]) + t * Wide(s.qd[i]);
  std::array<Wide, kJoints * kJoints> B;
  panda::inertia_matrix(q.data(), B.data());
  return B;
}

// The largest entry of the symmetric part of Ḃ - 2C, in units of the last place of the size of C's terms.
double asymmetry(const FreeMotion& s, const reference::Robot<double>& robot) {
  constexpr Wide kStep = 1e-5L;
  const auto ahead = inertia(s, kStep), behind = inertia(s, -kStep), far = inertia(s, 2 * kStep),
             back = inertia(s, -2 * kStep);
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
      const Wide dB = (8 * (ahead[k] - behind[k]) - (far[k] - back[k])) / (12 * kStep);
      const Wide sum = 2 * (dB - Wide(C[k]) - Wide(C[l]));
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      const double size = 2 * (scale(row, column) + scale(column, row));
      worst = std::max(worst, std::abs(static_cast<double>(sum)) / (std::numeric_limits<double>::epsilon() * size));
    }
  }
  return worst;
}

double seconds() {
  const char* const wanted = std::getenv("FLATDYN_ENERGY_SECONDS");
  return wanted == nullptr ? 2 : std::atof(wanted);
}

FreeMotion start() { return {{0.3, -0.6, 0.2, -1.8, 0.4, 1.2, -0.5}, {0.5, -0.3, 0.4, 0.2, -0.6, 0.3, 0.8}}; }

// The largest drift on the way, J.
double drift(int steps, double duration) {
  FreeMotion s = start();
  const double first = energy(s);
  double worst = 0;
  for (int k = 0; k < steps; ++k) {
    s = stepped(s, duration / steps);
    worst = std::max(worst, std::abs(energy(s) - first));
  }
  return worst;
}

TEST(FreeMotionOfThePanda, KeepsItsEnergyAsWellAsTheIntegratorAllows) {
  const double duration = seconds();
  const int steps = static_cast<int>(2000 * duration);
  const double coarse = drift(steps, duration), fine = drift(2 * steps, duration);
  RecordProperty("drift_J", std::to_string(coarse));
  std::printf("%g s: drift %.3g J at %d steps, %.3g J at %d: %.3g times less\n", duration, coarse, steps, fine,
              2 * steps, coarse / fine);
  // Of order 4: sixteen times less, and the energy's own error of fifth order still more; a wrong model would not care.
  EXPECT_GT(coarse / fine, 12);
  EXPECT_LT(coarse, 1e-3);
}

TEST(FreeMotionOfThePanda, KeepsInertiaRateLessTwiceCoriolisSkew) {
  const reference::Robot<double> robot = reference_robot<double>(model_of("panda.urdf").robot, {});
  FreeMotion s = start();
  double worst = 0;
  const int steps = static_cast<int>(1000 * seconds());
  for (int k = 0; k < steps; ++k) {
    s = stepped(s, 1e-3);
    if (k % 10 == 0) worst = std::max(worst, asymmetry(s, robot));
  }
  std::printf("largest scaled asymmetry: %.3g\n", worst);
  EXPECT_LT(worst, 16);
}

}  // namespace
}  // namespace flatdyn::testing
