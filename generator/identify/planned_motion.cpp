// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/planned_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "diagnostics/diagnostics.hpp"
#include "identify/triangular_factor.hpp"

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
MatrixXd folded_regressor(const TorqueModel& model, const std::vector<FourierMotion>& samples, const MatrixXd& known) {
  const int n = model.joints();
  TriangularFactor factor(model.parameters() - 1);  // the last column is passed as b
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> y(n, model.parameters());
  for (const FourierMotion& sample : samples) {
    model.regressor(sample.q.data(), sample.qd.data(), sample.qdd.data(), y.data());
    for (int i = 0; i < n; ++i) factor.next_row() = y.row(i);
  }
  for (const auto& row : known.rowwise()) factor.next_row() = row;
  return factor.factor();
}

std::vector<std::vector<double>> torques_of(const TorqueModel& model, const std::vector<FourierMotion>& samples) {
  const Eigen::Map<const VectorXd> values(model.file_values().data(), model.parameters());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> y(model.joints(), model.parameters());
  std::vector<std::vector<double>> torques;
  for (const FourierMotion& sample : samples) {
    model.regressor(sample.q.data(), sample.qd.data(), sample.qdd.data(), y.data());
    torques.emplace_back(static_cast<std::size_t>(model.joints()));
    Eigen::Map<VectorXd>(torques.back().data(), model.joints()) = y * values;
    model.add_springs(sample.q.data(), torques.back().data());
  }
  return torques;
}

// The use of limits at as many points between samples as the highest harmonic needs.
std::vector<LimitUse> use_of(const TorqueModel& model, const std::vector<JointLimits>& limits,
                             const FourierTrajectory& trajectory, int intervals) {
  const int wanted = kCheckedPerPeriod * static_cast<int>(trajectory.series().front().a.size());
  const std::vector<FourierMotion> samples = sampled(trajectory, intervals * (1 + (wanted - 1) / intervals));
  const std::vector<std::vector<double>> torques = torques_of(model, samples);
  std::vector<LimitUse> use(limits.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      update_use(use[i], limits[i], samples[k].q[i], samples[k].qd[i], samples[k].qdd[i], torques[k][i]);
    }
  }
  return use;
}

// The joint that uses the largest share of its torque.
std::size_t most_loaded(const std::vector<LimitUse>& use) {
  const auto by_torque = [](const LimitUse& a, const LimitUse& b) { return a.torque < b.torque; };
  return static_cast<std::size_t>(std::max_element(use.begin(), use.end(), by_torque) - use.begin());
}

[[noreturn]] void refuse_load(const Mechanism& mechanism, const std::vector<JointLimits>& limits,
                              const std::vector<LimitUse>& use, double margin) {
  const std::size_t i = most_loaded(use);
  const Body& joint = mechanism.joints()[i];
  throw Failure(
      ExitCode::unsupported,
      fmt::format(
          "joint \"{}\": {} alone takes {:.4g} {} in the middle of the position limits, where motions begin; {:.4g} "
          "may be used",
          joint.joint, mechanism.has_springs() ? "gravity, friction or a spring" : "gravity or friction",
          use[i].torque * limits[i].torque, torque_unit(joint), margin * limits[i].torque),
      "a larger --margin, or a --scene with position limits about a posture that takes less");
}

}  // namespace

FittedTrajectory fitted(const TorqueModel& model, const std::vector<JointLimits>& limits, double margin,
                        const FourierTrajectory& trajectory, int intervals) {
  std::vector<double> factors;
  for (const LimitUse& use : use_of(model, limits, trajectory, intervals)) {
    factors.push_back(kInside * margin / std::max({margin, use.position, use.speed, use.acceleration}));
  }
  FittedTrajectory fitted{trajectory.scaled(factors), {}};
  const std::vector<double> all_together(limits.size(), kShrink);
  for (int step = 0;; ++step) {
    const std::vector<LimitUse> use = use_of(model, limits, fitted.trajectory, intervals);
    if (step == 0) std::ranges::transform(use, std::back_inserter(fitted.torque), &LimitUse::torque);
    if (use[most_loaded(use)].torque <= margin) return fitted;
    if (step == kMostShrinks) refuse_load(model.mechanism(), limits, use, margin);
    fitted.trajectory = fitted.trajectory.scaled(all_together);
  }
}

PlannedMotion planned(const TorqueModel& model, const std::vector<JointLimits>& limits, double margin,
                      const FourierTrajectory& trajectory, int intervals, const VectorXd& lengths,
                      const MatrixXd& known) {
  FourierTrajectory fit = fitted(model, limits, margin, trajectory, intervals).trajectory;
  std::vector<FourierMotion> samples = sampled(fit, intervals);
  std::vector<std::vector<double>> torques = torques_of(model, samples);
  std::vector<LimitUse> use = use_of(model, limits, fit, intervals);
  const MatrixXd factor = folded_regressor(model, samples, known);
  const double cost = excitation_cost(factor * lengths.cwiseInverse().asDiagonal(), nullptr);
  return {
      std::move(fit), std::move(samples), std::move(torques), std::move(use), conditioning(factor, lengths), cost,
  };
}

}  // namespace flatdyn
