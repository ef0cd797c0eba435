// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/nonlinear_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "laboratory/identify/friction_search.hpp"
#include "laboratory/identify/gravity_search.hpp"
#include "laboratory/identify/identification.hpp"
#include "laboratory/identify/log_hypotheses.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The place of a parameter by its name; -1 if there is none.
Index place_of(const TorqueEquations& equations, const std::string& name) {
  const auto at = std::find(equations.names().begin(), equations.names().end(), name);
  return at == equations.names().end() ? -1 : at - equations.names().begin();
}

// Whether the log does not determine the speed that is corrected.
bool is_open(const NonlinearUnknowns& unknowns, const Correction& correction) {
  const auto index = static_cast<std::size_t>(correction.index);
  return correction.kind == Correction::Kind::speed && !unknowns.friction_told[index];
}

class NonlinearSearch {
 public:
  NonlinearSearch(LoadedRobot robot, ParameterSet set, const NonlinearOptions& options, const NonlinearAccess& logs,
                  Progress& progress)
      : set_(set), options_(options), logs_(logs), progress_(progress) {
    fit_.robot = std::move(robot);
    load_model();
    fit_.further.law = options.law;
    fit_.further.offsets = options.offsets;
    fit_.further.springs = options.springs;
    fit_.further.temperature = options.temperature;
    fit_.further.even_temperatures = options.even_temperatures;
  }

  NonlinearFit run() {
    if (options_.gravity) start_gravity();
    if (options_.delay) start_delay();
    if (has_speed(options_.law)) start_speeds();
    progress_.step("improving all of them together");
    correct();
    return std::move(fit_);
  }

 private:
  // With Coulomb friction while the law has no speeds yet.
  FurtherParameters plain() const {
    FurtherParameters further = fit_.further;
    if (has_speed(further.law) && further.speeds.empty()) further.law = FrictionLaw::coulomb;
    return further;
  }

  Measurement measured(const TorqueEquations& equations) const {
    return logs_.measured(equations, fit_.unknowns.delay);
  }

  void load_model() { fit_.model = std::make_unique<TorqueModel>(fit_.robot, set_, progress_); }

  void set_gravity(const Vector3d& gravity) {
    if ((fit_.unknowns.gravity->gravity - gravity).isZero()) return;
    fit_.unknowns.gravity->gravity = gravity;
    fit_.robot = logs_.robot_with(gravity);
    load_model();
  }

  void start_gravity() {
    const Vec3& file = fit_.robot.mechanism.gravity;
    fit_.unknowns.gravity =
        FoundGravity{Vector3d(nearest_double(file[0]), nearest_double(file[1]), nearest_double(file[2]))};
    const TorqueEquations equations(*fit_.model, plain());
    const Measurement measurement = measured(equations);
    progress_.step("finding gravity's direction");
    const GravityFit found = gravity_direction(fit_.robot, sample_of(equations, measurement));
    fit_.unknowns.gravity->told = found.told;
    set_gravity(found.gravity);
  }

  void start_delay() {
    const TorqueEquations equations(*fit_.model, plain());
    const Measurement measurement = measured(equations);
    if (measurement.logs.front().filter.band == 0) {
      throw Failure(FailureKind::usage, "--delay needs the filter: the log has all derivatives, and is used as it is",
                    "give --band HZ");
    }
    progress_.step("finding the delay");
    const RowSample sample = sample_of(equations, measurement);
    fit_.unknowns.delay = best_fit(delay_hypothesis(sample, 0, equations.equations())).x[0];
  }

  void start_speeds() {
    const TorqueEquations linear(*fit_.model, plain());
    FurtherParameters further = fit_.further;
    further.dictionary = friction_dictionary(linear, measured(linear));
    const TorqueEquations equations(*fit_.model, std::move(further));
    const Measurement measurement = measured(equations);
    progress_.step("finding the speeds of the friction law");
    FrictionSpeeds found = friction_speeds(equations, measurement);
    fit_.further.speeds = first_speeds_ = found.speeds;
    fit_.unknowns.friction_told = std::move(found.are_told);
  }

  void correct() {
    constexpr int kMostRounds = 15;
    const TorqueEquations start(*fit_.model, plain());
    const Estimate first = estimate_of(start, measured(start), {});
    VectorXd pi = whole(first);
    set_speed_factors(start, first);
    set_carried(start, first);
    for (int round = 0; round < kMostRounds; ++round) {
      set_columns(pi);
      const TorqueEquations equations(*fit_.model, fit_.further);
      fit_.unknowns.converged = equations.corrections() == 0 && options_.law != FrictionLaw::load;
      if (fit_.unknowns.converged) return;
      const Estimate found = estimate_of(equations, measured(equations), {});
      const bool has_same_load = set_carried(equations, found);
      fit_.unknowns.converged = has_same_load && are_small(equations, found);
      if (fit_.unknowns.converged) {
        fit_.unknowns.converged = is_possible(found);
        return;
      }
      pi = whole(found);
      set_speed_factors(equations, found);
      apply(equations, found);
    }
  }

  // π, by which gravity's columns are made; empty if there are no such columns.
  VectorXd whole(const Estimate& found) const {
    return options_.gravity ? whole_parameters(*fit_.model, fit_.robot, found.values) : VectorXd();
  }

  // The columns of gravity and of the delay, about the parameters that were found last.
  void set_columns(const VectorXd& pi) {
    fit_.further.delay = options_.delay;
    if (!options_.gravity) return;
    const auto& [gravity, told, covariance] = *fit_.unknowns.gravity;
    fit_.further.gravity =
        std::make_shared<GravityColumns>(*fit_.model, fit_.robot, pi, turns_of_gravity(gravity, told));
  }

  // Sets the factors of the law's term, with which a change of the speed acts on the torques. A speed that the log does
  // not determine keeps its first value; its column stays, so that the intervals of others have its uncertainty in
  // them.
  void set_speed_factors(const TorqueEquations& equations, const Estimate& found) {
    constexpr double kMostUnsure = 0.5;  // standard deviation of v, a share of v
    if (!has_speed(options_.law)) return;
    for (const Correction& each : equations.corrected()) {
      if (each.kind != Correction::Kind::speed) continue;
      const auto i = static_cast<std::size_t>(each.index);
      const bool is_unsure = found.standard_deviations[each.column] > kMostUnsure * fit_.further.speeds[i];
      if (is_unsure) fit_.unknowns.friction_told[i] = false;
    }
    std::vector<double> factors;
    for (std::size_t i = 0; i < fit_.further.speeds.size(); ++i) {
      const char* const of_law = options_.law == FrictionLaw::smooth ? "Fs" : "Fb";
      const Index term = place_of(equations, equations.name_of(of_law, static_cast<int>(i)));
      const bool is_told = fit_.unknowns.friction_told[i];
      factors.push_back(term < 0 ? 0 : is_told ? found.values[term] : 1);
      if (!is_told) fit_.further.speeds[i] = first_speeds_[i];
    }
    fit_.further.speed_factors = std::move(factors);
  }

  // Sets the parameters that make the torques which drives carry; returns whether they hardly change.
  bool set_carried(const TorqueEquations& equations, const Estimate& found) {
    constexpr double kShare = 0.1;  // of a standard deviation
    if (options_.law != FrictionLaw::load) return true;
    const std::map<std::string, double> before = std::exchange(fit_.further.carried, {});
    bool is_same = true;
    for (Index k = 0; k < found.values.size(); ++k) {
      const std::string& name = equations.names()[static_cast<std::size_t>(k)];
      const double value = fit_.further.carried[name] = found.values[k];
      const auto last = before.find(name);
      const double change = last == before.end() ? std::numeric_limits<double>::infinity() : value - last->second;
      is_same &= std::abs(change) <= std::max(kShare * std::sqrt(found.covariance(k, k)), 1e-9 * std::abs(value));
    }
    return is_same;
  }

  // Whether all corrections are small parts of their standard deviations, or of what counts in practice.
  bool are_small(const TorqueEquations& equations, const Estimate& found) const {
    constexpr double kShare = 0.1, kLeast = 1e-6;  // of a standard deviation; s, rad, rad/s or m/s
    return std::ranges::all_of(equations.corrected(), [&](const Correction& each) {
      const double size = std::abs(found.values[each.column]), deviation = found.standard_deviations[each.column];
      return is_open(fit_.unknowns, each) || size <= std::max(kShare * deviation, kLeast);
    });
  }

  // Whether the parameters are those of a robot: a component of gravity that comes out as good as zero makes masses
  // without bound.
  bool is_possible(const Estimate& found) const {
    constexpr double kFar = 1000;  // times the largest base parameter of the robot file
    const std::vector<double>& file = fit_.model->file_values();
    const Eigen::Map<const VectorXd> of_file(file.data(), static_cast<Index>(file.size()));
    const double largest = found.values.head(of_file.size()).cwiseAbs().maxCoeff();
    return !options_.gravity || largest <= kFar * of_file.cwiseAbs().maxCoeff();
  }

  // Corrects the unknowns, each by no more than its derivative is good for.
  void apply(const TorqueEquations& equations, const Estimate& found) {
    constexpr double kMostDelay = 0.02, kMostTurn = 0.3, kMostOfSpeed = 0.4;  // s, rad, share
    VectorXd angles(options_.gravity ? equations.further().gravity->size() : 0);
    for (const Correction& each : equations.corrected()) {
      const double value = found.values[each.column];
      if (each.kind == Correction::Kind::gravity) angles[each.index] = value;
      if (each.kind == Correction::Kind::delay) fit_.unknowns.delay += std::clamp(value, -kMostDelay, kMostDelay);
      if (each.kind != Correction::Kind::speed || is_open(fit_.unknowns, each)) continue;
      double& speed = fit_.further.speeds[static_cast<std::size_t>(each.index)];
      speed += std::clamp(value, -kMostOfSpeed * speed, kMostOfSpeed * speed);
    }
    if (angles.size() == 0) return;
    const double much = std::max(1.0, angles.norm() / kMostTurn);
    set_gravity(turned_gravity(fit_.unknowns.gravity->gravity, fit_.unknowns.gravity->told, angles / much));
  }

  ParameterSet set_;
  NonlinearOptions options_;
  const NonlinearAccess& logs_;
  Progress& progress_;
  NonlinearFit fit_;
  std::vector<double> first_speeds_;
};

}  // namespace

NonlinearFit nonlinear_fit(LoadedRobot robot, ParameterSet set, const NonlinearOptions& options,
                           const NonlinearAccess& logs, Progress& progress) {
  return NonlinearSearch(std::move(robot), set, options, logs, progress).run();
}

namespace {

// The standard deviation, s, by which samples leave open when friction jumps: about a tenth of their step, as logs of
// delays that are no whole steps show. Without Coulomb friction there are no jumps.
double deviation_of_jumps(const TorqueEquations& equations, const Measurement& measurement) {
  constexpr double kShare = 0.1;
  double dt = 0;
  for (const MeasuredLog& log : measurement.logs) dt = std::max(dt, log.filter.dt);
  for (int i = equations.model().first_joint(); i < equations.equations(); ++i) {
    if (place_of(equations, equations.name_of("Fs", i)) >= 0) return kShare * dt;
  }
  return 0;
}

}  // namespace

void set_deviations(NonlinearUnknowns& unknowns, const TorqueEquations& equations, const Estimate& estimate,
                    const Measurement& measurement) {
  constexpr double kExact = std::numeric_limits<double>::quiet_NaN();
  unknowns.speed_deviations.assign(equations.further().speeds.size(), kExact);
  std::vector<int> turns;
  for (const Correction& each : equations.corrected()) {
    const double deviation = std::sqrt(estimate.covariance(each.column, each.column));
    if (each.kind == Correction::Kind::gravity) turns.push_back(each.column);
    if (each.kind == Correction::Kind::delay) {
      unknowns.delay_deviation = std::hypot(deviation, deviation_of_jumps(equations, measurement));
    }
    if (each.kind != Correction::Kind::speed || is_open(unknowns, each)) continue;
    unknowns.speed_deviations[static_cast<std::size_t>(each.index)] = deviation;
  }
  if (!unknowns.gravity) return;
  unknowns.gravity->covariance.setConstant(kExact);
  if (turns.empty()) return;
  const Eigen::Matrix3Xd& slopes = equations.further().gravity->slopes();
  unknowns.gravity->covariance = slopes * estimate.covariance(turns, turns) * slopes.transpose();
}

void leave_friction_open(Estimate& estimate, const NonlinearUnknowns& unknowns, const TorqueEquations& equations) {
  for (std::size_t i = 0; i < unknowns.friction_told.size(); ++i) {
    if (unknowns.friction_told[i]) continue;
    for (const char* stem : {"Fv", "Fs", "Fb"}) {
      const Index place = place_of(equations, equations.name_of(stem, static_cast<int>(i)));
      if (place >= 0) estimate.standard_deviations[place] = std::numeric_limits<double>::infinity();
    }
  }
}

}  // namespace flatdyn
