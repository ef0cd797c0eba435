// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/fit_hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "laboratory/identify/gravity_search.hpp"
#include "laboratory/identify/row_sample.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDegree = std::numbers::pi / 180;

// The place of the lowest value between two places, by thirds.
double lowest(double low, double high, const std::function<double(double)>& value) {
  constexpr int kThirds = 14;
  for (int round = 0; round < kThirds; ++round) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    const bool is_lower = value(a) < value(b);
    (is_lower ? high : low) = is_lower ? b : a;
  }
  return (low + high) / 2;
}

class HypothesisSearch {
 public:
  HypothesisSearch(const TorqueModel& model, const Measurement& measurement, const std::vector<JointFit>& fits)
      : model_(model), rows_(model, measurement, fits) {
    for (int i = 0; i < model.equations(); ++i) names_.push_back(model.subject_of(i));
    has_rows_.assign(names_.size(), false);
    for (const RowSample::Instant& instant : rows_.instants()) {
      for (std::size_t i = 0; i < has_rows_.size(); ++i) has_rows_[i] = has_rows_[i] || instant.used[i];
    }
    noise_ = rows_.count();
    before_ = rows_.cost();
  }

  std::optional<FitHypothesis> best(const LoadedRobot& robot) {
    const bool is_open = !model_.mechanism().has_loops();
    torques();
    delay();
    if (is_open) missing_terms();
    const bool has_positions = is_open && !model_.mechanism().has_spherical_joints();
    if (has_positions) positions();
    if (has_positions) joints();
    if (has_own_gravity()) gravity(robot);
    if (has_positions) offsets();
    if (model_.first_joint() > 0) sensors_of_base();
    if (has_own_gravity()) gravity_left_out(robot);
    if (has_own_gravity() && !best_) no_trace_of_gravity();
    return best_;
  }

  // Whether the torques look as if gravity were not in them.
  std::optional<FitHypothesis> without_gravity(const LoadedRobot& robot) {
    if (!has_own_gravity()) return best_;
    gravity_left_out(robot);
    if (!best_) no_trace_of_gravity();
    return best_;
  }

 private:
  // Remembers the hypothesis if it explains more than those before it, which are as simple or simpler: clearly more, or
  // most of what the best one leaves. If it explains about as much, the one is right whose parameters less speaks
  // against (`odd`).
  void consider(double cost, const std::function<std::string()>& text, double odd = 0) {
    constexpr double kHalf = 0.5, kMore = 0.02, kMuch = 1.5, kAboutAsMuch = 0.05;
    const double explained = (before_ - cost) / std::max(before_ - noise_, 1e-300);
    if (explained < kHalf || before_ - cost < std::max(kChance, kShareOfChance * noise_)) return;
    const bool is_alike = best_ && std::abs(explained - best_->explained) < kAboutAsMuch;
    if (is_alike && odd > odd_ + kClearlyOdder) return;
    const bool is_less_odd = is_alike && odd < odd_ - kClearlyOdder;
    if (best_ && explained < best_->explained + kMore && !is_less_odd) {
      const double left = least_ - noise_, gain = least_ - cost;
      if (least_ < kMuch * noise_ || gain < kChance || gain < kHalf * left) return;
    }
    least_ = cost;
    odd_ = odd;
    is_gain_ = false;
    best_ = FitHypothesis{text(), std::min(explained, 1.0)};
  }

  // The weighted squares of the torques that one parameter makes.
  double squares_of(int parameter, double value) const {
    double squares = 0;
    for (const RowSample::Instant& instant : rows_.instants()) {
      for (std::size_t i = 0; i < instant.used.size(); ++i) {
        const double torque = instant.Y(static_cast<Index>(i), parameter) * value;
        if (instant.used[i]) squares += rows_.weights()[i] * torque * torque;
      }
    }
    return squares;
  }

  // The number of parameters of friction and rotors that are negative by more than chance, and how far masses are from
  // the file's, as the logarithm of their ratio: that speaks against the parameters.
  double oddness(const VectorXd& parameters) const {
    constexpr double kLeastRatio = 1e-3;
    double count = 0, of_file = 0, of_both = 0;
    for (int k = 0; k < model_.parameters(); ++k) {
      const Parameter kind = parameter_of(model_.base().columns[at(k)]);
      if (kind == Parameter::Im || kind == Parameter::Fv || kind == Parameter::Fs) {
        count += parameters[k] < 0 && squares_of(k, parameters[k]) > kChance ? 1 : 0;
      } else {
        of_file += std::pow(model_.file_values()[at(k)], 2);
        of_both += model_.file_values()[at(k)] * parameters[k];
      }
    }
    return of_file > 0 ? count + std::abs(std::log(std::max(of_both / of_file, kLeastRatio))) : count;
  }

  // A gain of one joint's torques, or a change of their sign, with what it costs.
  struct Gain {
    double cost = 0, odd = 0;
    std::string text;
  };

  void consider_gain(int i, double gain, const std::function<std::string()>& text) {
    VectorXd parameters;
    const double cost = rows_.cost_with_gain(i, gain, &parameters), odd = oddness(parameters);
    gains_.push_back({cost, odd, text()});
    consider(cost, text, odd);
    is_gain_ = is_gain_ || (best_ && least_ == cost);
  }

  // Torques of one joint that are too large are the same as those of another that are too small, where these two joints
  // have nearly all parameters in common: all such joints are named then.
  void name_equal_gains() {
    constexpr double kAlike = 0.02;  // share of what is explained
    if (!best_ || !is_gain_) return;
    const double most = least_ + std::max(kAlike * (before_ - noise_), kChance);
    std::vector<std::string> texts;
    for (const Gain& each : gains_) {
      if (each.cost < most && each.odd < odd_ + kClearlyOdder) texts.push_back(each.text);
    }
    if (texts.size() > 1) best_->text = fmt::format("{}", fmt::join(texts, ", or "));
  }

  // The equations that have rows: those of a floating base's force have none where the log lacks it.
  std::vector<int> equations_with_rows() const {
    std::vector<int> result;
    for (int i = 0; i < model_.equations(); ++i) {
      if (has_rows_[at(i)]) result.push_back(i);
    }
    return result;
  }

  void torques() {
    const std::vector<int> all = equations_with_rows();
    for (const int i : all) {
      consider_gain(i, -1, [&] {
        return fmt::format("{}: its {} look as if their sign were reversed", names_[at(i)], readings_of(i));
      });
    }
    for (const int i : all) {
      for (const int k : all) {
        if (k <= i || is_of_base(i) != is_of_base(k)) continue;
        consider(rows_.cost_with_exchanged_torques(i, k), [&] {
          return fmt::format("{} and {}: their {} look exchanged", names_[at(i)], names_[at(k)], readings_of(i));
        });
      }
    }
    for (const int i : all) {
      double offset = 0;
      const double cost = rows_.cost_with_torque_offset(i, offset);
      consider(cost, [&] {
        return fmt::format("{}: its {} look as if {:.3g} {} were added to all of them{}", names_[at(i)], readings_of(i),
                           offset, model_.unit_of(i), is_of_base(i) ? "" : " (--offsets estimates it)");
      });
      gain(i);
    }
    name_equal_gains();
    if (model_.first_joint() > 0 && has_rows_.front()) {
      consider(rows_.cost_with_reaction(), [] {
        return "the force on the base, and its moment, look as if their signs were reversed: they are what something "
               "exerts on the base, the weight of a robot that hangs still upwards";
      });
    }
  }

  // The gain with least cost, first among powers of 1.25 up to 10^4, then by thirds of the interval about it.
  void gain(int i) {
    constexpr int kMostPowers = 41;
    double best = 1, least = before_;
    for (int power = -kMostPowers; power <= kMostPowers; ++power) {
      const double gain = std::pow(1.25, power), cost = rows_.cost_with_gain(i, gain);
      if (cost < least) std::tie(best, least) = std::pair(gain, cost);
    }
    const double found = lowest(best / 1.25, best * 1.25, [&](double gain) { return rows_.cost_with_gain(i, gain); });
    consider_gain(i, found, [&] {
      return fmt::format("{}: its {} look {:.3g} times too {}", names_[at(i)], readings_of(i),
                         found > 1 ? found : 1 / found, found > 1 ? "large" : "small");
    });
  }

  void delay() {
    double delay = 0;
    const double cost = rows_.cost_with_delay(delay);
    consider(cost, [&] {
      return fmt::format("all torques look {:.2g} ms {} (--delay estimates it)", 1000 * std::abs(delay),
                         delay > 0 ? "late" : "early");
    });
    for (const int i : equations_with_rows()) {
      if (names_.size() == 1) break;
      const double cost_of_one = rows_.cost_with_delay_of(i, delay);
      consider(cost_of_one, [&] {
        return fmt::format("{}: its {} look {:.2g} ms {}, or {} {}", names_[at(i)], readings_of(i),
                           1000 * std::abs(delay), delay > 0 ? "late" : "early",
                           is_of_base(i) ? "the base's motion" : "its positions", delay > 0 ? "early" : "late");
      });
    }
  }

  // The name of a joint that is counted from 0, without a floating base.
  const std::string& joint_name(int joint) const { return names_[at(model_.first_joint() + joint)]; }

  void positions() {
    const int n = model_.joints();
    for (int i = 0; i < n; ++i) {
      consider(rows_.cost_with_positions([&](Eigen::Ref<VectorXd> q) { q[i] = -q[i]; }),
               [&] { return joint_name(i) + ": its positions look as if their sign were reversed"; });
    }
    for (int i = 0; i < n; ++i) {
      for (int k = i + 1; k < n; ++k) {
        consider(rows_.cost_with_positions([&](Eigen::Ref<VectorXd> q) { std::swap(q[i], q[k]); }), [&] {
          return fmt::format("{} and {}: their positions look exchanged", joint_name(i), joint_name(k));
        });
      }
    }
  }

  void joints() {
    const int n = model_.joints();
    for (int i = 0; i < n; ++i) {
      for (int k = i + 1; k < n; ++k) {
        consider(rows_.cost_with_exchanged_joints(i, k), [&] {
          return fmt::format("{} and {} look exchanged: the positions and the torques of both", joint_name(i),
                             joint_name(k));
        });
      }
    }
  }

  // By joint: whether the model has a parameter.
  bool has(int joint, Parameter parameter) const {
    const std::vector<int>& columns = model_.base().columns;
    return std::find(columns.begin(), columns.end(), index_of(joint, parameter)) != columns.end();
  }

  // The sign of a joint's speed as the filter smears it, from the speed at the middle of its window and the
  // acceleration.
  static double smeared_sign(const RowSample::Instant& instant, int joint) {
    constexpr double kHalfWidth = 0.025;  // s, at a band of 10 Hz
    return std::tanh(instant.qd[joint] / std::max(std::abs(instant.qdd[joint]) * kHalfWidth, 1e-9));
  }

  // Friction and rotors that the model lacks, or friction that is larger near rest.
  void missing_terms() {
    const auto n = static_cast<int>(names_.size());
    if (model_.mechanism().is_coupled()) return;
    const auto lacks = [&](int i) { return !has(i, Parameter::Fs) || !has(i, Parameter::Fv); };
    std::vector<int> without, with;
    for (int i = model_.first_joint(); i < n; ++i) (lacks(i) ? without : with).push_back(i);
    if (!without.empty()) {
      const double cost = rows_.cost_with_more([&](const RowSample::Instant& instant) {
        MatrixXd columns = MatrixXd::Zero(n, 3 * static_cast<Index>(without.size()));
        Index column = 0;
        for (const int i : without) {
          columns(i, column++) = instant.qd[i];
          columns(i, column++) = smeared_sign(instant, i);
          columns(i, column++) = instant.qdd[i];
        }
        return columns;
      });
      consider(cost, [] { return "friction, perhaps rotors, look left out (--parameters full estimates them)"; });
    }
    if (!with.empty()) friction_near_rest(with);
  }

  void friction_near_rest(const std::vector<int>& joints) {
    constexpr double kSlowest = 0.01, kFactor = 2;  // of each joint's largest speed; factor
    VectorXd fastest = VectorXd::Zero(static_cast<Index>(names_.size()));
    for (const RowSample::Instant& instant : rows_.instants()) fastest = fastest.cwiseMax(instant.qd.cwiseAbs());
    double least = before_;
    for (double share = kSlowest; share < 1; share *= kFactor) {
      least = std::min(least, rows_.cost_with_more([&](const RowSample::Instant& instant) {
        MatrixXd columns = MatrixXd::Zero(fastest.size(), static_cast<Index>(joints.size()));
        for (std::size_t k = 0; k < joints.size(); ++k) {
          const int i = joints[k];
          const double part = instant.qd[i] / std::max(share * fastest[i], 1e-9);
          columns(i, static_cast<Index>(k)) = std::exp(-part * part) * smeared_sign(instant, i);
        }
        return columns;
      }));
    }
    consider(least, [] { return "friction looks larger near rest (--friction stribeck estimates by how much)"; });
  }

  void offsets() {
    for (int i = 0; i < model_.joints(); ++i) {
      if (!model_.mechanism().joints()[at(i)].prismatic) offset(i);
    }
  }

  // The offset of a joint's zero with least cost: all around by 15 degrees, then finer.
  void offset(int i) {
    const auto cost_of = [&](double offset) { return rows_.cost_with_offset(i, offset); };
    double best = 0, least = before_;
    for (int step = -11; step <= 12; ++step) {
      const double cost = step == 0 ? before_ : cost_of(15 * step * kDegree);
      if (cost < least) std::tie(best, least) = std::pair(15 * step * kDegree, cost);
    }
    const double found = lowest(best - 15 * kDegree, best + 15 * kDegree, cost_of);
    consider(cost_of(found), [&] {
      return fmt::format("{}: its zero looks {:.3g} degrees off: as if {:.4g} rad were missing in its positions",
                         joint_name(i), std::abs(found) / kDegree, found);
    });
  }

  // The sensors of a floating base may have the other sign: an accelerometer that shows gravity instead of what
  // holds against it, or a gyroscope that turns the other way.
  void sensors_of_base() {
    constexpr int kTurns = 3;
    consider(rows_.cost_with_base([](VectorXd&, VectorXd& qdd) { qdd.head(kTurns) *= -1; }), [] {
      return "the base's specific force looks as if its sign were reversed: at rest an accelerometer shows 9.81 m/s^2 "
             "upwards, and gravity in base axes points down";
    });
    consider(rows_.cost_with_base([](VectorXd& qd, VectorXd& qdd) {
      qd.segment(kTurns, kTurns) *= -1;
      qdd.segment(kTurns, kTurns) *= -1;
    }),
             [] { return "the base's angular velocity looks as if its sign were reversed"; });
  }

  void gravity(const LoadedRobot& robot) {
    constexpr double kLeast = kDegree;  // a smaller angle is chance, or the fault of something else
    const GravityFit fit = gravity_direction(model_, robot, rows_);
    if (fit.angle < kLeast) return;
    consider(fit.cost, [&] {
      return fmt::format(
          "gravity looks as if it came from another direction: [{:.3g}, {:.3g}, {:.3g}] m/s^2 in the "
          "base frame, {:.3g} degrees from the robot file's (--gravity-direction estimates it)",
          fit.gravity.x(), fit.gravity.y(), fit.gravity.z(), fit.angle / kDegree);
    });
  }

  // Clearly less cost without gravity than with it: chance does not do that.
  void gravity_left_out(const LoadedRobot& robot) {
    const Vec3& g = model_.mechanism().gravity;
    if (std::all_of(g.begin(), g.end(), vanishes)) return;
    const double cost = cost_without_gravity(model_, robot, rows_);
    const bool is_clear = before_ - cost > std::max(kChance, (before_ - noise_) / 2);
    if (!is_clear || (best_ && cost > least_ + kChance)) return;
    const std::string other = best_ && cost > least_ - kChance ? ", or " + best_->text : "";
    least_ = cost;
    best_ = FitHypothesis{
        "gravity looks left out of the torques, as if it were compensated (--gravity off fits better)" + other,
        std::min(1.0, (before_ - cost) / std::max(before_ - noise_, 1e-300))};
  }

  // Weighted squares of torques.
  struct Squares {
    double of_gravity = 0, of_motion = 0;
  };

  // The squares of the torques that these parameters make: of gravity, and of all the rest.
  Squares squares_with(const VectorXd& parameters) const {
    const auto n = static_cast<Index>(names_.size());
    const VectorXd rest = VectorXd::Zero(n);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Y(n, model_.parameters());
    Squares squares;
    for (const RowSample::Instant& instant : rows_.instants()) {
      model_.regressor(instant.q.data(), rest.data(), rest.data(), Y.data());
      const VectorXd of_gravity = Y * parameters;
      const VectorXd of_motion = instant.Y.leftCols(parameters.size()) * parameters - of_gravity;
      for (Index i = 0; i < n; ++i) {
        const auto joint = static_cast<std::size_t>(i);
        if (!instant.used[joint]) continue;
        squares.of_gravity += rows_.weights()[joint] * of_gravity[i] * of_gravity[i];
        squares.of_motion += rows_.weights()[joint] * of_motion[i] * of_motion[i];
      }
    }
    return squares;
  }

  // Masses that only gravity shows come out as good as zero if it is not in the torques, and the fit is as good. Where
  // all torques are smaller, their unit is another one.
  void no_trace_of_gravity() {
    constexpr double kTrace = 0.05;  // share of the robot file's torques of gravity
    const Eigen::Map<const VectorXd> file(model_.file_values().data(), model_.parameters());
    VectorXd found;
    rows_.cost(&found);
    const Squares expected = squares_with(file), there = squares_with(found.head(model_.parameters()));
    if (kTrace * kTrace * expected.of_gravity < kChance) return;
    const double size = expected.of_motion > 0 ? std::min(1.0, there.of_motion / expected.of_motion) : 1;
    if (there.of_gravity > kTrace * kTrace * size * expected.of_gravity) return;
    best_ = FitHypothesis{
        "gravity looks left out of the torques, as if it were compensated: they have no trace of what it does with the "
        "robot file's masses (--gravity off says so)",
        0};
  }

  // Whether gravity is separate from the motion, and looked for: with a floating base, it is part of the acceleration.
  bool has_own_gravity() const { return !model_.mechanism().has_loops() && !model_.mechanism().has_quasi_velocities(); }

  bool is_of_base(int equation) const { return equation < model_.first_joint(); }
  const char* readings_of(int equation) const { return is_of_base(equation) ? "readings" : "torques"; }

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  static constexpr double kChance = 60, kShareOfChance = 0.05;  // of the cost; of the noise
  static constexpr double kClearlyOdder = 0.5;

  const TorqueModel& model_;
  RowSample rows_;
  std::vector<std::string> names_;
  std::vector<bool> has_rows_;  // by equation
  double before_ = 0, noise_ = 0, least_ = 0;
  double odd_ = 0;        // of the best one
  bool is_gain_ = false;  // whether the best one is a gain
  std::vector<Gain> gains_;
  std::optional<FitHypothesis> best_;
};

}  // namespace

std::optional<FitHypothesis> best_hypothesis(const TorqueModel& model, const LoadedRobot& robot,
                                             const Measurement& measurement, const std::vector<JointFit>& fits) {
  constexpr double kMuch = 0.6;
  HypothesisSearch search(model, measurement, fits);
  const bool is_suspicious =
      std::any_of(fits.begin(), fits.end(), [](const JointFit& fit) { return fit.is_suspicious(); });
  if (!is_suspicious) return search.without_gravity(robot);
  const bool is_sound = std::all_of(fits.begin(), fits.end(), [](const JointFit& fit) { return fit.is_sound(); });
  const std::optional<FitHypothesis> found = search.best(robot);
  // Chance explains some of the little that a sound log leaves.
  const bool is_chance = found && is_sound && found->explained > 0 && found->explained < kMuch;
  return is_chance ? std::nullopt : found;
}

}  // namespace flatdyn
