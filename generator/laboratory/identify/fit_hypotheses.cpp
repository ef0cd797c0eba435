// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/fit_hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "laboratory/identify/gravity_search.hpp"
#include "laboratory/identify/log_hypotheses.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class BestReason {
 public:
  BestReason(const TorqueModel& model, const LoadedRobot& robot, const Measurement& measurement,
             const std::vector<JointFit>& fits, FrictionLaw law)
      : model_(model),
        robot_(robot),
        sample_(model, measurement, fits),
        rows_(sample_.rows()),
        plain_(fit_of(rows_)),
        noise_(sample_.count()),
        law_(law) {
    best_.cost = plain_.cost;
  }

  std::optional<FitHypothesis> of_all() {
    for (const LogHypothesis& each : log_hypotheses(robot_, sample_, law_)) {
      const HypothesisFit fit = each.fit();
      consider({fit.cost, each.is_gain ? oddness(fit.pi) : 0, each.text(fit), each.is_gain});
    }
    if (best_.is_gain) name_equal_gains();
    return of_gravity();
  }

  // Whether the torques look as if gravity were not in them; else the best reason so far.
  std::optional<FitHypothesis> of_gravity() {
    if (has_own_gravity(model_.mechanism())) gravity_left_out();
    if (!best_.text.empty()) return FitHypothesis{best_.text, std::min(explained(best_.cost), 1.0)};
    if (!has_own_gravity(model_.mechanism()) || has_trace_of_gravity()) return std::nullopt;
    return FitHypothesis{
        "gravity looks left out of the torques, as if it were compensated: they have no trace of what it does with the "
        "robot file's masses (--gravity off says so)",
        0};
  }

 private:
  struct Reason {
    double cost = 0;
    double odd = 0;  // how much speaks against its parameters
    std::string text;
    bool is_gain = false;
  };

  // Remembers the reason if it explains more than those before it, which are as simple or simpler: clearly more, or
  // most of what the best one leaves. If it explains about as much, the one is right whose parameters less speaks
  // against.
  void consider(Reason next) {
    constexpr double kHalf = 0.5, kMore = 0.02, kMuch = 1.5, kAboutAsMuch = 0.05;
    if (next.is_gain) gains_.push_back(next);
    const double share = explained(next.cost), gain = best_.cost - next.cost;
    if (share < kHalf || plain_.cost - next.cost < std::max(kChance, kShareOfChance * noise_)) return;
    if (!best_.text.empty()) {
      const double more = share - explained(best_.cost);
      const bool is_alike = std::abs(more) < kAboutAsMuch;
      if (is_alike && next.odd > best_.odd + kClearlyOdder) return;
      const bool is_less_odd = is_alike && next.odd < best_.odd - kClearlyOdder;
      const bool is_most_of_the_rest =
          best_.cost >= kMuch * noise_ && gain >= std::max(kChance, kHalf * (best_.cost - noise_));
      if (more < kMore && !is_less_odd && !is_most_of_the_rest) return;
    }
    best_ = std::move(next);
  }

  // The share of what the noise does not explain.
  double explained(double cost) const { return (plain_.cost - cost) / std::max(plain_.cost - noise_, 1e-300); }

  // The number of parameters of friction and rotors that are negative by more than chance, and how far masses are from
  // the file's, as the logarithm of their ratio: that speaks against the parameters.
  double oddness(const VectorXd& parameters) const {
    constexpr double kLeastRatio = 1e-3;
    double count = 0, of_file = 0, of_both = 0;
    for (int k = 0; k < model_.parameters(); ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Parameter kind = parameter_of(model_.base().columns[at]);
      if (kind == Parameter::Im || kind == Parameter::Fv || kind == Parameter::Fs) {
        const double squares = (rows_.A.col(k) * parameters[k]).squaredNorm();
        count += parameters[k] < 0 && squares > kChance ? 1 : 0;
      } else {
        of_file += std::pow(model_.file_values()[at], 2);
        of_both += model_.file_values()[at] * parameters[k];
      }
    }
    return of_file > 0 ? count + std::abs(std::log(std::max(of_both / of_file, kLeastRatio))) : count;
  }

  // Torques of one joint that are too large are the same as those of another that are too small, where these two joints
  // have nearly all parameters in common: all such joints are named then.
  void name_equal_gains() {
    constexpr double kAlike = 0.02;  // share of what is explained
    const double most = best_.cost + std::max(kAlike * (plain_.cost - noise_), kChance);
    std::vector<std::string> texts;
    for (const Reason& each : gains_) {
      if (each.cost < most && each.odd < best_.odd + kClearlyOdder) texts.push_back(each.text);
    }
    best_.text = fmt::format("{}", fmt::join(texts, ", or "));
  }

  // Clearly less cost without gravity than with it: chance does not do that.
  void gravity_left_out() {
    const Vec3& g = model_.mechanism().gravity;
    if (std::all_of(g.begin(), g.end(), vanishes)) return;
    const double cost = cost_without_gravity(robot_, sample_);
    const bool has_other = !best_.text.empty();
    const bool is_clear = plain_.cost - cost > std::max(kChance, (plain_.cost - noise_) / 2);
    if (!is_clear || (has_other && cost > best_.cost + kChance)) return;
    const std::string other = has_other && cost > best_.cost - kChance ? ", or " + best_.text : "";
    best_ = {cost, 0,
             "gravity looks left out of the torques, as if it were compensated (--gravity off fits better)" + other};
  }

  // Masses that only gravity shows come out as good as zero if it is not in the torques, and the fit is as good. Where
  // all torques are smaller, their unit is another one.
  bool has_trace_of_gravity() const {
    constexpr double kTrace = 0.05;  // share of the robot file's torques of gravity
    const Index size = model_.parameters();
    const WeightedEquations at_rest = sample_.rows([&](RowSample::Instant& t) {
      for (VectorXd* each : {&t.qd, &t.qdd, &t.viscous, &t.coulomb}) each->setZero();
      sample_.follow_motion(t);
    });
    const MatrixXd gravity = at_rest.A.leftCols(size), motion = rows_.A.leftCols(size) - gravity;
    const Eigen::Map<const VectorXd> file(model_.file_values().data(), size);
    const VectorXd found = plain_.pi.head(size);
    const double least = kTrace * kTrace * (gravity * file).squaredNorm(), of_motion = (motion * file).squaredNorm();
    const double scale = of_motion > 0 ? std::min(1.0, (motion * found).squaredNorm() / of_motion) : 1;
    return least < kChance || (gravity * found).squaredNorm() > scale * least;
  }

  static constexpr double kChance = 60, kShareOfChance = 0.05;  // of the cost; of the noise
  static constexpr double kClearlyOdder = 0.5;

  const TorqueModel& model_;
  const LoadedRobot& robot_;
  RowSample sample_;
  WeightedEquations rows_;
  HypothesisFit plain_;
  double noise_;
  FrictionLaw law_;
  Reason best_;  // without a text while there is none
  std::vector<Reason> gains_;
};

}  // namespace

std::optional<FitHypothesis> best_hypothesis(const TorqueModel& model, const LoadedRobot& robot,
                                             const Measurement& measurement, const std::vector<JointFit>& fits,
                                             FrictionLaw law) {
  constexpr double kMuch = 0.6;
  BestReason search(model, robot, measurement, fits, law);
  const bool is_suspicious =
      std::any_of(fits.begin(), fits.end(), [](const JointFit& fit) { return fit.is_suspicious(); });
  if (!is_suspicious) return search.of_gravity();
  const bool is_sound = std::all_of(fits.begin(), fits.end(), [](const JointFit& fit) { return fit.is_sound(); });
  const std::optional<FitHypothesis> found = search.of_all();
  // Chance explains some of the little that a sound log leaves.
  const bool is_chance = found && is_sound && found->explained > 0 && found->explained < kMuch;
  return is_chance ? std::nullopt : found;
}

}  // namespace flatdyn
