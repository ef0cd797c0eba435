// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/excitation.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>

#include "base/diagnostics/diagnostics.hpp"
#include "laboratory/identify/excitation_objective.hpp"

namespace flatdyn {
namespace {

// Half of the evaluations try kStarts random starts. The other half goes to the best of them: a third of it as it is,
// the rest in kRounds rounds, each of which begins with a motion that keeps the limits.
constexpr int kStarts = 6, kRounds = 4;
// A bound on the coefficients; beyond it the scaled motion hardly depends on them.
constexpr double kLargestCoefficient = 4;
// The least number of samples per period of the highest harmonic.
constexpr int kSamplesPerPeriod = 10;
// The weight of torques beyond their limits in these rounds.
constexpr double kFirmly = 100;
// The largest number of intervals; each takes some hundred bytes for an arm.
constexpr int kMostIntervals = 500'000;

// Uniform numbers in [-1, 1). std::uniform_real_distribution differs between libraries; this does not.
std::vector<double> random_coefficients(std::mt19937_64& engine, int count) {
  std::vector<double> x;
  for (int k = 0; k < count; ++k) x.push_back(static_cast<double>(engine() >> 11) * 0x1p-52 - 1);
  return x;
}

class ShapeSearch {
 public:
  ShapeSearch(const ExcitationObjective& objective, std::optional<double> seconds, const std::function<bool()>& stop)
      : objective_(objective), start_(std::chrono::steady_clock::now()), seconds_(seconds), stop_(stop) {}

  // Replaces x by the best of this many evaluations that start from it. Returns its value.
  double improve(std::vector<double>& x, int evaluations) {
    best_value_ = HUGE_VAL;
    best_ = x;
    last_ = evaluations_ + evaluations;
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
        nlopt_create(NLOPT_LD_LBFGS, static_cast<unsigned>(x.size())), &nlopt_destroy);
    optimiser_ = optimiser.get();
    nlopt_set_min_objective(optimiser.get(), &ShapeSearch::evaluate, this);
    nlopt_set_lower_bounds1(optimiser.get(), -kLargestCoefficient);
    nlopt_set_upper_bounds1(optimiser.get(), kLargestCoefficient);
    if (seconds_) nlopt_set_maxtime(optimiser.get(), std::max(*seconds_ - seconds(), 1e-3));
    double value = 0;
    // The best motion seen counts, however the search ends: a line search may fail at kinks that the limits make.
    if (nlopt_optimize(optimiser.get(), x.data(), &value) == NLOPT_MAXTIME_REACHED) out_of_time_ = true;
    x = best_;
    return best_value_;
  }

  int evaluations() const { return evaluations_; }
  bool out_of_time() const { return out_of_time_; }

 private:
  static double evaluate(unsigned size, const double* x, double* gradient, void* search) {
    auto& self = *static_cast<ShapeSearch*>(search);
    // nlopt_set_maxeval would not do: this method exceeds it by one or two.
    if (self.evaluations_ == self.last_ || self.stop_()) {
      nlopt_force_stop(self.optimiser_);
      return HUGE_VAL;
    }
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
  const std::function<bool()>& stop_;
  double best_value_ = HUGE_VAL;
  std::vector<double> best_;
  nlopt_opt optimiser_ = nullptr;
  int evaluations_ = 0, last_ = 0;
  bool out_of_time_ = false;
};

// The number of intervals between the samples of a motion.
int intervals_of(const ExcitationOptions& options, const MotionEquations& equations) {
  const int least = std::max(kSamplesPerPeriod * options.harmonics, 2 * equations.parameters());
  const double intervals = std::round(options.duration * options.rate);
  if (intervals > kMostIntervals) {
    throw Failure(FailureKind::usage, fmt::format("--duration {} and --rate {} make {} samples; at most {} are planned",
                                                  options.duration, options.rate, intervals, kMostIntervals));
  }
  if (intervals >= least) return static_cast<int>(intervals);
  throw Failure(
      FailureKind::usage,
      fmt::format("--duration {} and --rate {} make {} samples; {} harmonics and {} parameters need {}",
                  options.duration, options.rate, intervals, options.harmonics, equations.parameters(), least));
}

void refuse_what_cannot_move(const MotionEquations& equations, const std::vector<JointLimits>& limits) {
  if (equations.parameters() == 0) {
    throw Failure(FailureKind::unsupported, "no torque of the robot depends on any of its parameters");
  }
  const TorqueModel& model = equations.model();
  for (int i = 0; i < model.equations(); ++i) {
    const JointLimits& joint = limits[static_cast<std::size_t>(i)];
    if (joint.lower < joint.upper) continue;
    throw Failure(FailureKind::unsupported, model.subject_of(i) + ": its position limits leave no room",
                  fmt::format("hold it: --fix {}", model.name_of(i)));
  }
}

// Searches on from each start and returns the best result.
std::vector<double> best_of(const std::vector<std::vector<double>>& starts, ShapeSearch& search, int evaluations,
                            Progress& progress) {
  std::vector<double> best = starts.front();
  double best_value = HUGE_VAL;
  for (std::size_t start = 0; start < starts.size(); ++start) {
    progress.step(fmt::format("random start {} of {}", start + 1, starts.size()));
    std::vector<double> x = starts[start];
    const double value = search.improve(x, evaluations);
    if (value >= best_value) continue;
    best_value = value;
    best = std::move(x);
  }
  return best;
}

// Factors by which torques beyond the margin have to become smaller.
std::vector<double> factors_of(const std::vector<double>& torque, double margin) {
  std::vector<double> factors;
  for (const double use : torque) factors.push_back(margin / std::max(use, margin));
  return factors;
}

// Searches on from `shape` in rounds and returns the best motion that keeps the limits. Each round begins with the best
// so far, since beyond the limits nothing shows which joints have to move less. Torques that are too large between the
// criterion's few samples are lowered at these samples in the next round.
FourierTrajectory within_limits(const MotionEquations& equations, const std::vector<JointLimits>& limits,
                                const ExcitationOptions& options, std::vector<double> shape,
                                ExcitationObjective& objective, ShapeSearch& search) {
  const auto fit = [&] { return fitted(equations, limits, options.margin, objective.trajectory(shape.data())); };
  FourierTrajectory best = fit().trajectory;
  double best_cost = objective.cost(best);
  objective.weigh_torques(kFirmly);
  for (int round = 0; round < kRounds; ++round) {
    shape = objective.coefficients(best);
    search.improve(shape, (options.evaluations - search.evaluations()) / (kRounds - round));
    const FittedTrajectory found = fit();
    objective.lower_torques(factors_of(found.torque, options.margin));
    const double cost = objective.cost(found.trajectory);
    if (cost >= best_cost) continue;
    best_cost = cost;
    best = found.trajectory;
  }
  return best;
}

}  // namespace

Excitation make_excitation(const MotionEquations& equations, const ExcitationOptions& options, Progress& progress,
                           const std::function<bool()>& stop) {
  const std::vector<JointLimits> limits = motion_limits(equations.model().mechanism());
  refuse_what_cannot_move(equations, limits);
  const int intervals = intervals_of(options, equations);
  ExcitationObjective objective(equations, within_margin(limits, options.margin), options.duration, options.harmonics);
  // The logs' information, in proportion to samples at the motion's rate, and to those of the criterion.
  const Eigen::MatrixXd logged = std::sqrt(options.rate) * equations.information_on_columns(options.logged);
  objective.add_known(std::sqrt(static_cast<double>(objective.samples()) / intervals) * logged);
  std::mt19937_64 engine(options.seed);
  std::vector<std::vector<double>> starts;
  for (int start = 0; start < kStarts; ++start) starts.push_back(random_coefficients(engine, objective.size()));
  objective.scale_by(starts);
  ShapeSearch search(objective, options.time, stop);
  std::vector<double> best = best_of(starts, search, options.evaluations / (2 * kStarts), progress);
  progress.step("improving the best start");
  search.improve(best, (options.evaluations - search.evaluations()) / 3);
  const FourierTrajectory found = within_limits(equations, limits, options, std::move(best), objective, search);
  const auto plan = [&](const FourierTrajectory& trajectory) {
    return planned(equations, limits, options.margin, trajectory, intervals, objective.lengths(), logged);
  };
  progress.step("planning the motion");
  PlannedMotion start = plan(objective.trajectory(starts.front().data()));
  PlannedMotion motion = plan(found);
  if (motion.cost > start.cost) motion = start;
  std::optional<Conditioning> logs;
  if (logged.size() > 0) logs = conditioning(logged, objective.lengths());
  return {std::move(start), std::move(motion), std::move(logs), search.evaluations(), search.out_of_time()};
}

}  // namespace flatdyn
