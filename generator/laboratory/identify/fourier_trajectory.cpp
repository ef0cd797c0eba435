// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/fourier_trajectory.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace flatdyn {
namespace {

// A periodic motion has the same position p, speed v and acceleration c at both ends. The polynomial with just these
// has an even part for p and c and an odd part for v. In x = 2t/T − 1, h = T/2:
//   even: p + c h²/8 (1 − x²)²      odd: −v h/8 x (1 − x²)(7 − 3x²)
Deflection quintic(double duration, double t, double p, double v, double c) {
  const double h = duration / 2, x = 2 * t / duration - 1, u = 1 - x * x;
  return {p + c * h * h / 8 * u * u - v * h / 8 * x * u * (7 - 3 * x * x),
          -c * h / 2 * x * u + v / 8 * (-7 + x * x * (30 - 15 * x * x)),
          -c / 2 * (1 - 3 * x * x) + v / h * 7.5 * x * u};
}

Deflection operator+(const Deflection& a, const Deflection& b) { return {a.q + b.q, a.qd + b.qd, a.qdd + b.qdd}; }
Deflection operator*(double s, const Deflection& a) { return {s * a.q, s * a.qd, s * a.qdd}; }

}  // namespace

Deflection sine_term(double duration, int l, double t) {
  const double frequency = 2 * std::numbers::pi * l / duration, angle = 2 * std::numbers::pi * l * (t / duration);
  const Deflection wave{std::sin(angle) / frequency, std::cos(angle), -frequency * std::sin(angle)};
  return wave + quintic(duration, t, 0, -1, 0);
}

Deflection cosine_term(double duration, int l, double t) {
  const double frequency = 2 * std::numbers::pi * l / duration, angle = 2 * std::numbers::pi * l * (t / duration);
  const Deflection wave{-std::cos(angle) / frequency, std::sin(angle), frequency * std::cos(angle)};
  return wave + quintic(duration, t, 1 / frequency, 0, -frequency);
}

FourierTrajectory::FourierTrajectory(double duration, std::vector<double> rest, std::vector<FourierSeries> series)
    : duration_(duration), rest_(std::move(rest)), series_(std::move(series)) {}

FourierMotion FourierTrajectory::at(double t) const {
  FourierMotion motion;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    Deflection sum;
    for (std::size_t k = 0; k < series_[i].a.size(); ++k) {
      const int l = static_cast<int>(k) + 1;
      sum = sum + series_[i].a[k] * sine_term(duration_, l, t) + series_[i].b[k] * cosine_term(duration_, l, t);
    }
    motion.q.push_back(rest_[i] + sum.q);
    motion.qd.push_back(sum.qd);
    motion.qdd.push_back(sum.qdd);
  }
  return motion;
}

FourierTrajectory FourierTrajectory::scaled(const std::vector<double>& factors) const {
  FourierTrajectory result = *this;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    for (double& a : result.series_[i].a) a *= factors[i];
    for (double& b : result.series_[i].b) b *= factors[i];
  }
  return result;
}

std::vector<FourierMotion> sampled(const FourierTrajectory& trajectory, int intervals) {
  std::vector<FourierMotion> motions;
  for (int k = 0; k <= intervals; ++k) motions.push_back(trajectory.at(trajectory.duration() * k / intervals));
  return motions;
}

}  // namespace flatdyn
