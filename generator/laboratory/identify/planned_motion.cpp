// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/planned_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/diagnostics/diagnostics.hpp"
#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Points per period of the highest harmonic at which limits are checked; a sine rises by 0.3 % at most between them.
constexpr int kCheckedPerPeriod = 40;
// The factor by which all joints shrink at a time until the torques fit; after the last one almost nothing moves.
constexpr double kShrink = 0.98;
constexpr int kMostShrinks = 400;
// A factor that keeps rounding from exceeding a limit.
constexpr double kInside = 1 - 1e-12;

// The triangular factor of Y_b stacked over all samples, and of further rows.
MatrixXd folded_regressor(const MotionEquations& equations, const std::vector<FourierMotion>& samples,
                          const MatrixXd& known) {
  TriangularFactor factor(equations.parameters() - 1);  // the last column is passed as b
  for (const FourierMotion& sample : samples) {
    const MatrixXd y = equations.regressor(sample.q.data(), sample.qd.data(), sample.qdd.data());
    for (const auto& row : y.rowwise()) factor.next_row() = row;
  }
  for (const auto& row : known.rowwise()) factor.next_row() = row;
  return factor.factor();
}

std::vector<std::vector<double>> torques_of(const MotionEquations& equations,
                                            const std::vector<FourierMotion>& samples) {
  std::vector<std::vector<double>> torques;
  for (const FourierMotion& sample : samples) {
    const VectorXd each = equations.torques(sample.q.data(), sample.qd.data(), sample.qdd.data());
    torques.emplace_back(each.begin(), each.end());
  }
  return torques;
}

// The motion with the velocities of spherical joints and of a floating base, and their derivatives, in the place of the
// coordinates' rates: they are what is limited.
FourierMotion as_limited(const MotionEquations& equations, FourierMotion motion) {
  if (!equations.model().mechanism().has_quasi_velocities()) return motion;
  const PlannedState state = equations.state(motion.q.data(), motion.qd.data(), motion.qdd.data());
  std::copy(state.v.begin(), state.v.end(), motion.qd.begin());
  std::copy(state.a.begin(), state.a.end(), motion.qdd.begin());
  return motion;
}

// The use of limits at as many points between samples as the highest harmonic needs.
std::vector<LimitUse> use_of(const MotionEquations& equations, const std::vector<JointLimits>& limits,
                             const FourierTrajectory& trajectory, int intervals) {
  const int wanted = kCheckedPerPeriod * static_cast<int>(trajectory.series().front().a.size());
  const std::vector<FourierMotion> samples = sampled(trajectory, intervals * (1 + (wanted - 1) / intervals));
  const std::vector<std::vector<double>> torques = torques_of(equations, samples);
  std::vector<LimitUse> use(limits.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const FourierMotion limited = as_limited(equations, samples[k]);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      update_use(use[i], limits[i], limited.q[i], limited.qd[i], limited.qdd[i], torques[k][i]);
    }
  }
  return use;
}

// The largest share that is used of all limits but those of positions.
double largest_share(const std::vector<LimitUse>& use) {
  double largest = 0;
  for (const LimitUse& each : use) largest = std::max({largest, each.speed, each.acceleration, each.torque});
  return largest;
}

// The joint that uses the largest share of its torque.
std::size_t most_loaded(const std::vector<LimitUse>& use) {
  const auto by_torque = [](const LimitUse& a, const LimitUse& b) { return a.torque < b.torque; };
  return static_cast<std::size_t>(std::max_element(use.begin(), use.end(), by_torque) - use.begin());
}

[[noreturn]] void refuse_load(const TorqueModel& model, const std::vector<JointLimits>& limits,
                              const std::vector<LimitUse>& use, double margin) {
  const std::size_t i = most_loaded(use);
  const auto equation = static_cast<int>(i);
  throw Failure(
      FailureKind::unsupported,
      fmt::format(
          "{}: {} alone takes {:.4g} {} in the middle of the position limits, where motions begin; {:.4g} may be used",
          model.subject_of(equation),
          model.mechanism().has_springs() ? "gravity, friction or a spring" : "gravity or friction",
          use[i].torque * limits[i].torque, model.unit_of(equation), margin * limits[i].torque),
      "a larger --margin, or a --scene with position limits about a posture that takes less");
}

}  // namespace

FittedTrajectory fitted(const MotionEquations& equations, const std::vector<JointLimits>& limits, double margin,
                        const FourierTrajectory& trajectory, int intervals) {
  std::vector<double> factors;
  for (const LimitUse& use : use_of(equations, limits, trajectory, intervals)) {
    factors.push_back(kInside * margin / std::max({margin, use.position, use.speed, use.acceleration}));
  }
  FittedTrajectory fitted{trajectory.scaled(factors), {}};
  const std::vector<double> all_together(limits.size(), kShrink);
  for (int step = 0;; ++step) {
    const std::vector<LimitUse> use = use_of(equations, limits, fitted.trajectory, intervals);
    if (step == 0) std::ranges::transform(use, std::back_inserter(fitted.torque), &LimitUse::torque);
    if (largest_share(use) <= margin) return fitted;
    if (step == kMostShrinks) refuse_load(equations.model(), limits, use, margin);
    fitted.trajectory = fitted.trajectory.scaled(all_together);
  }
}

PlannedMotion planned(const MotionEquations& equations, const std::vector<JointLimits>& limits, double margin,
                      const FourierTrajectory& trajectory, int intervals, const VectorXd& lengths,
                      const MatrixXd& known) {
  FourierTrajectory fit = fitted(equations, limits, margin, trajectory, intervals).trajectory;
  std::vector<FourierMotion> samples = sampled(fit, intervals);
  std::vector<std::vector<double>> torques = torques_of(equations, samples);
  std::vector<LimitUse> use = use_of(equations, limits, fit, intervals);
  const MatrixXd factor = folded_regressor(equations, samples, known);
  const double cost = excitation_cost(factor * lengths.cwiseInverse().asDiagonal(), nullptr);
  return {
      std::move(fit), std::move(samples), std::move(torques), std::move(use), conditioning(factor, lengths), cost,
  };
}

}  // namespace flatdyn
