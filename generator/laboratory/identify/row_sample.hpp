// SPDX-License-Identifier: GPL-2.0-or-later
// Some rows of a log, weighted by its noise, with which other readings of the log can be tried quickly: hypotheses say
// how the rows change. The least cost of a sound log is near count().
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/hypothesis.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

class RowSample {
 public:
  static constexpr std::size_t kFew = 256;  // instants that tell enough of whatever is common to all of them

  RowSample(const TorqueModel& model, const Measurement& measurement, const std::vector<JointFit>& fits,
            std::size_t most_instants = kFew);

  // By equation, but for q.
  struct Instant {
    double time = 0;
    std::size_t reading = 0;  // place among all readings
    Eigen::VectorXd q, qd, qdd;
    Eigen::VectorXd viscous, coulomb;  // the joint's columns of F_v and F_s, filtered
    Eigen::VectorXd tau;
    Eigen::VectorXd weights;  // 1/σ_i; 0 where the equation is not used
    Eigen::MatrixXd Y;        // n × all parameters, filtered

    // All that is by joint, and belongs to the motion.
    std::array<Eigen::VectorXd*, 5> motion() { return {&q, &qd, &qdd, &viscous, &coulomb}; }
  };
  const TorqueModel& model() const { return model_; }
  const std::vector<Instant>& instants() const { return instants_; }
  // The number of rows.
  double count() const;
  // Whether the equation has rows: those of a floating base's force have none where the log lacks it.
  bool has_rows(int equation) const;

  // Whether the log says how fast torques change.
  bool has_rates() const;

  // The rows, each instant changed.
  using Change = std::function<void(Instant&)>;
  WeightedEquations rows(const Change& change = [](Instant&) {}) const;
  // Sets Y to that of the motion.
  void follow_motion(Instant& instant) const;
  // Takes torques of the equations `first` up to `end` as late by a time, s. An instant at which the log has no torques
  // at the later time gets no weight.
  void undo_delay(Instant& instant, double delay, int first, int end) const;

 private:
  // The torques of one row of the log, and their rates.
  struct Reading {
    int log = 0;
    long index = 0;
    double time = 0;
    Eigen::VectorXd tau, rate;
  };
  // The torques at another time, from the readings on both sides; none where there is one on one side alone.
  std::optional<Eigen::VectorXd> torques_at(std::size_t place, double time) const;
  Instant instant_of(const EquationInstant& from, const Observations& observations) const;

  const TorqueModel& model_;
  Eigen::VectorXd roots_;  // by equation, 1/σ_i
  std::vector<Instant> instants_;
  std::vector<Reading> readings_;  // in the order of logs and times
};

// Weighted by the noise about the least-squares fit of the equations.
RowSample sample_of(const TorqueEquations& equations, const Measurement& measurement,
                    std::size_t most_instants = RowSample::kFew);

}  // namespace flatdyn
