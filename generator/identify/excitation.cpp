// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/excitation.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>

#include "diagnostics/diagnostics.hpp"
#include "identify/excitation_objective.hpp"

namespace flatdyn {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Half of the evaluations try as many random starts; the best one gets the other half.
constexpr int kStarts = 6;
// Far beyond the limits the scaled motion hardly depends on the coefficients.
constexpr double kLargestCoefficient = 4;
constexpr int kSamplesPerPeriod = 10;
// All joints at a time until the torques fit: after the last one next to nothing moves.
constexpr double kShrink = 0.98;
constexpr int kMostShrinks = 400;
// Scaling to a limit must not end beyond it by rounding.
constexpr double kInside = 1 - 1e-12;

// std::uniform_real_distribution differs between libraries; this does not.
std::vector<double> random_coefficients(std::mt19937_64& engine, int count) {
  std::vector<double> x;
  for (int k = 0; k < count; ++k) x.push_back(static_cast<double>(engine() >> 11) * 0x1p-52 - 1);
  return x;
}

class ShapeSearch {
 public:
  ShapeSearch(const ExcitationObjective& objective, std::optional<double> seconds)
      : objective_(objective), start_(std::chrono::steady_clock::now()), seconds_(seconds) {}

  // Goes on from x, in place, to the best of this many evaluations. Returns its value.
  double improve(std::vector<double>& x, int evaluations) {
    best_value_ = HUGE_VAL;
    best_ = x;
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
        nlopt_create(NLOPT_LD_LBFGS, static_cast<unsigned>(x.size())), &nlopt_destroy);
    nlopt_set_min_objective(optimiser.get(), &ShapeSearch::evaluate, this);
    nlopt_set_lower_bounds1(optimiser.get(), -kLargestCoefficient);
    nlopt_set_upper_bounds1(optimiser.get(), kLargestCoefficient);
    nlopt_set_maxeval(optimiser.get(), evaluations);
    if (seconds_) nlopt_set_maxtime(optimiser.get(), std::max(*seconds_ - seconds(), 1e-3));
    double value = 0;
    // However it ends, also where a line search fails because limits make kinks: the best motion seen counts.
    if (nlopt_optimize(optimiser.get(), x.data(), &value) == NLOPT_MAXTIME_REACHED) out_of_time_ = true;
    x = best_;
    return best_value_;
  }

  int evaluations() const { return evaluations_; }
  bool out_of_time() const { return out_of_time_; }

 private:
  static double evaluate(unsigned size, const double* x, double* gradient, void* search) {
    auto& self = *static_cast<ShapeSearch*>(search);
    ++self.evaluations_;
    const double value = self.objective_(x, gradient);
    if (value < self.best_value_) {
      self.best_value_ = value;
      self.best_.assign(x, x + size);
    }
    return value;
  }
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  const ExcitationObjective& objective_;
  std::chrono::steady_clock::time_point start_;
  std::optional<double> seconds_;
  double best_value_ = HUGE_VAL;
  std::vector<double> best_;
  int evaluations_ = 0;
  bool out_of_time_ = false;
};

MatrixXd stacked_regressor(const TorqueModel& model, const std::vector<FourierMotion>& samples) {
  const int n = model.joints();
  MatrixXd stacked(static_cast<Eigen::Index>(samples.size()) * n, model.parameters());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> y(n, model.parameters());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    model.regressor(samples[k].q.data(), samples[k].qd.data(), samples[k].qdd.data(), y.data());
    stacked.middleRows(static_cast<Eigen::Index>(k) * n, n) = y;
  }
  return stacked;
}

std::vector<std::vector<double>> torques_of(const TorqueModel& model, const MatrixXd& stacked) {
  const VectorXd tau = stacked * Eigen::Map<const VectorXd>(model.file_values().data(), model.parameters());
  std::vector<std::vector<double>> rows;
  for (const double* row = tau.data(); row != tau.data() + tau.size(); row += model.joints()) {
    rows.emplace_back(row, row + model.joints());
  }
  return rows;
}

std::vector<LimitUse> use_of(const std::vector<JointLimits>& limits, const std::vector<FourierMotion>& samples,
                             const std::vector<std::vector<double>>& torques) {
  std::vector<LimitUse> use(limits.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      raise(use[i], limits[i], samples[k].q[i], samples[k].qd[i], samples[k].qdd[i], torques[k][i]);
    }
  }
  return use;
}

bool keeps_torques(const std::vector<LimitUse>& use, double margin) {
  return std::all_of(use.begin(), use.end(), [margin](const LimitUse& joint) { return joint.torque <= margin; });
}

PlannedMotion planned(const TorqueModel& model, const std::vector<JointLimits>& limits, FourierTrajectory trajectory,
                      int intervals) {
  std::vector<FourierMotion> samples = sampled(trajectory, intervals);
  const MatrixXd stacked = stacked_regressor(model, samples);
  std::vector<std::vector<double>> torques = torques_of(model, stacked);
  std::vector<LimitUse> use = use_of(limits, samples, torques);
  return {std::move(trajectory), std::move(samples), std::move(torques), std::move(use), {}};
}

// Makes the motion smaller until all of its samples keep the limits: each joint by itself for position, speed and
// acceleration, which are proportional to its series; then all joints together for the torques.
PlannedMotion fitted(const TorqueModel& model, const std::vector<JointLimits>& limits, double margin,
                     const FourierTrajectory& trajectory, int intervals) {
  PlannedMotion motion = planned(model, limits, trajectory, intervals);
  std::vector<double> factors;
  for (const LimitUse& use : motion.use) {
    factors.push_back(kInside * margin / std::max({margin, use.position, use.speed, use.acceleration}));
  }
  motion = planned(model, limits, trajectory.scaled(factors), intervals);
  for (int step = 0; !keeps_torques(motion.use, margin); ++step) {
    if (step == kMostShrinks) {
      throw Failure(ExitCode::unsupported, "no motion about the middle of the position limits keeps the torque limits",
                    "gravity or friction alone exceeds them: check the limits, or --margin");
    }
    const std::vector<double> smaller(limits.size(), kShrink);
    motion = planned(model, limits, motion.trajectory.scaled(smaller), intervals);
  }
  motion.conditioning = conditioning(stacked_regressor(model, motion.samples));
  return motion;
}

// Between the samples of a motion.
int intervals_of(const ExcitationOptions& options, const TorqueModel& model) {
  const int least = std::max(kSamplesPerPeriod * options.harmonics, 2 * model.parameters());
  const double intervals = std::round(options.duration * options.rate);
  if (intervals >= least) return static_cast<int>(intervals);
  throw Failure(ExitCode::usage,
                fmt::format("--duration {} and --rate {} make {} samples; {} harmonics and {} parameters need {}",
                            options.duration, options.rate, intervals, options.harmonics, model.parameters(), least));
}

void refuse_what_cannot_move(const TorqueModel& model, const std::vector<JointLimits>& limits) {
  if (model.parameters() == 0) {
    throw Failure(ExitCode::unsupported, "no torque of the robot depends on any of its parameters");
  }
  for (int i = 0; i < model.joints(); ++i) {
    const JointLimits& joint = limits[static_cast<std::size_t>(i)];
    if (joint.lower < joint.upper) continue;
    const std::string& name = model.mechanism().joints()[static_cast<std::size_t>(i)].joint;
    throw Failure(ExitCode::unsupported, fmt::format("joint \"{}\": its position limits leave no room", name),
                  fmt::format("hold it: --fix {}", name));
  }
}

}  // namespace

Excitation make_excitation(const TorqueModel& model, const ExcitationOptions& options, Progress& progress) {
  const std::vector<JointLimits> limits = motion_limits(model.mechanism());
  refuse_what_cannot_move(model, limits);
  const int intervals = intervals_of(options, model);
  const ExcitationObjective objective(model, within_margin(limits, options.margin), options.duration,
                                      options.harmonics);
  std::mt19937_64 engine(options.seed);
  ShapeSearch search(objective, options.time);
  std::vector<double> first, best;
  double best_value = HUGE_VAL;
  for (int start = 0; start < kStarts; ++start) {
    progress.step(fmt::format("random start {} of {}", start + 1, kStarts));
    std::vector<double> x = random_coefficients(engine, objective.size());
    if (start == 0) first = best = x;
    const double value = search.improve(x, std::max(options.evaluations / (2 * kStarts), 1));
    if (value >= best_value) continue;
    best_value = value;
    best = std::move(x);
  }
  progress.step("improving the best start");
  search.improve(best, std::max(options.evaluations - search.evaluations(), 1));
  const auto motion_of = [&](const std::vector<double>& x) {
    return fitted(model, limits, options.margin, objective.trajectory(x.data()), intervals);
  };
  return {motion_of(first), motion_of(best), search.evaluations(), search.out_of_time()};
}

}  // namespace flatdyn
