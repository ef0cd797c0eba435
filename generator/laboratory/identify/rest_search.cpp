// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/rest_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "laboratory/identify/fit_quality.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;

// The mean square of some residuals.
struct Squares {
  double sum = 0, count = 0;

  void add(double residual) {
    sum += residual * residual;
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0; }
};

// Whether the joint is slower than a speed at an instant or at one beside it, or turns around between them.
bool is_slow_about(const std::vector<EquationInstant>& instants, std::size_t at, std::size_t equation, double slow) {
  const EquationInstant& here = instants[at];
  const double speed = here.qd[equation];
  const auto follow = [](const EquationInstant& a, const EquationInstant& b) {
    return a.log == b.log && a.index + 1 == b.index;
  };
  const auto is_slow = [&](double other) { return std::abs(other) < slow || (other < 0) != (speed < 0); };
  return std::abs(speed) < slow ||
         (at > 0 && follow(instants[at - 1], here) && is_slow(instants[at - 1].qd[equation])) ||
         (at + 1 < instants.size() && follow(here, instants[at + 1]) && is_slow(instants[at + 1].qd[equation]));
}

// The rest speed that leaves a joint's slow rows out; nullopt if they fit as well as others, but for chance.
std::optional<double> speed_of_creep(const std::vector<EquationInstant>& instants, const Eigen::VectorXd& left,
                                     std::size_t equation) {
  constexpr double kSlow = 0.05, kRests = 0.03;              // shares of the largest speed
  constexpr double kWorse = 4, kChance = 6, kLeastRows = 5;  // times the mean square; standard deviations
  double fastest = 0;
  for (const EquationInstant& instant : instants) fastest = std::max(fastest, std::abs(instant.qd[equation]));
  Squares slow, fast;
  for (std::size_t t = 0; t < instants.size(); ++t) {
    const double residual = left[static_cast<Index>(t)];
    if (std::isnan(residual)) continue;
    (is_slow_about(instants, t, equation, kSlow * fastest) ? slow : fast).add(residual);
  }
  if (std::min(slow.count, fast.count) < kLeastRows) return std::nullopt;
  const double most = std::max(kWorse, 1 + kChance * std::sqrt(2 / slow.count)) * fast.mean();
  return slow.mean() < most ? std::nullopt : std::optional(kRests * fastest);
}

}  // namespace

std::vector<double> better_rest_speeds(const TorqueEquations& equations, const Measurement& measurement,
                                       const Eigen::VectorXd& values) {
  const int first = equations.model().first_joint();
  const std::vector<double> before = measurement.rest_speeds();
  const Eigen::MatrixXd left = residuals(measurement.observations, values);
  std::vector<double> speeds(before.begin() + first, before.end());
  bool is_better = false;
  for (int i = first; i < equations.equations(); ++i) {
    if (equations.model().mechanism().joint(i).spherical != 0 || !equations.has_friction(i)) continue;
    double& speed = speeds[static_cast<std::size_t>(i - first)];
    const auto found = speed_of_creep(measurement.observations.instants, left.col(i), static_cast<std::size_t>(i));
    if (!found || *found <= speed) continue;
    speed = *found;
    is_better = true;
  }
  if (!is_better) speeds.clear();
  return speeds;
}

}  // namespace flatdyn
