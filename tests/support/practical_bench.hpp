// SPDX-License-Identifier: GPL-2.0-or-later
// An arm with its practical logs, and what identification makes of them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include "laboratory/identify/huber.hpp"
#include "laboratory/identify/least_squares.hpp"
#include "laboratory/identify/measurement.hpp"
#include "laboratory/identify/torque_equations.hpp"
#include "support/practical_log.hpp"

namespace flatdyn::testing {

constexpr double kEncoderStep = 1e-4;  // rad

// An arm, what it really is, and what identification is told of it.
class PracticalBench {
 public:
  explicit PracticalBench(PracticalArm arm)
      : arm_(std::move(arm)),
        real_(arm_.truth()),
        plain_(arm_.plain()),
        model_(plain_, ParameterSet::full, quiet_),
        equations_(model_) {
    for (const Number& value : base_values(real_.mechanism, model_.base())) truth_.push_back(nearest_double(value));
  }

  const PracticalArm& arm() const { return arm_; }
  const LoadedRobot& plain() const { return plain_; }
  const TorqueModel& model() const { return model_; }
  const TorqueEquations& equations() const { return equations_; }
  double truth(int k) const { return truth_[static_cast<std::size_t>(k)]; }
  double truth(const std::string& name) const { return truth(place_of(name)); }
  int place_of(const std::string& name) const {
    for (int k = 0; k < model_.parameters(); ++k) {
      if (parameter_name(model_.base().columns[static_cast<std::size_t>(k)]) == name) return k;
    }
    throw std::invalid_argument(name);
  }
  std::vector<SimulatedSample> motion(const PracticalOptions& options) const {
    return practical_motion(arm_, real_, options);
  }

  Measurement measured(const std::vector<SimulatedSample>& samples, double step, double noise, unsigned seed = 1,
                       const StreamOptions& options = {}, const TorqueEquations* other = nullptr,
                       const RowWeight& weight = nullptr, const LogSink& also = nullptr) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("flatdyn-practical-{}.csv", ::getpid());
    write_practical_log(path, arm_, samples, step, noise, seed);
    Diagnostics found;
    Measurement measurement =
        measure(other != nullptr ? *other : equations_, plain_.mechanism, {path}, options, quiet_, found, weight, also);
    std::filesystem::remove(path);
    EXPECT_FALSE(found.has_errors());
    warnings.clear();
    warning_lines.clear();
    for (const Diagnostic& each : found.all()) {
      warnings.push_back(each.message);
      warning_lines.push_back(each.place.line);
    }
    return measurement;
  }
  AccelerationRows acceleration_rows() const { return equations_.acceleration_rows(); }
  Estimate estimated(const Measurement& measurement, double damping = EstimateOptions().damping) const {
    EstimateOptions options;
    options.damping = damping;
    options.acceleration_rows = acceleration_rows();
    return estimate(measurement.observations, equations_.file_values(), options);
  }

  // With Huber's weights, three times.
  Estimate robustly_estimated(const std::vector<SimulatedSample>& samples, double step, double noise) {
    Measurement measurement = measured(samples, step, noise);
    for (int round = 0; round < 3; ++round) {
      const RowWeight weight = huber_weights(equations_, measurement, estimated(measurement).values);
      measurement = measured(samples, step, noise, 1, {}, nullptr, weight);
    }
    return estimated(measurement);
  }

  std::vector<std::string> warnings;  // of the log that was measured last
  std::vector<int> warning_lines;

 private:
  PracticalArm arm_;
  Progress quiet_{true};
  LoadedRobot real_, plain_;
  TorqueModel model_;
  TorqueEquations equations_;
  std::vector<double> truth_;
};

inline PracticalBench& ur5() {
  static PracticalBench bench(practical_ur5());
  return bench;
}

inline PracticalBench& panda() {
  static PracticalBench bench(practical_panda());
  return bench;
}

}  // namespace flatdyn::testing
