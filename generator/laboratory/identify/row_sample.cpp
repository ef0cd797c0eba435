// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/row_sample.hpp"

#include <algorithm>
#include <cmath>

#include "laboratory/identify/identification.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

VectorXd roots_of_weights(const Observations& observations, const std::vector<JointFit>& fits) {
  constexpr double kLeastNoise = 1e-3;  // share of the torque: sharper rows would follow the filter's errors
  VectorXd roots(fits.size());
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const double torque = observations.joints[i].rms_torque();
    roots[static_cast<Index>(i)] = 1 / std::max({fits[i].expected, kLeastNoise * torque, 1e-9});
  }
  return roots;
}

// Calls `visit` with each column of friction, the instant's entry for it in viscous or coulomb, and its equation. With
// coupled joints, friction is part of the motion's regressor.
template <class Instant, class Visit>
void for_friction(const TorqueModel& model, Instant& instant, const Visit& visit) {
  if (model.mechanism().is_coupled()) return;
  for (int k = 0; k < model.parameters(); ++k) {
    const int index = model.base().columns[static_cast<std::size_t>(k)];
    const Parameter kind = parameter_of(index);
    const int joint = joint_of(index);
    if (kind == Parameter::Fv) visit(k, instant.viscous[joint], joint);
    if (kind == Parameter::Fs) visit(k, instant.coulomb[joint], joint);
  }
}

}  // namespace

RowSample::RowSample(const TorqueModel& model, const Measurement& measurement, const std::vector<JointFit>& fits,
                     std::size_t most_instants)
    : model_(model), roots_(roots_of_weights(measurement.observations, fits)) {
  const std::vector<EquationInstant>& instants = measurement.observations.instants;
  for (const EquationInstant& each : instants) {
    readings_.push_back({each.log, each.index, each.time, as_vector(each.right), as_vector(each.measured_rates)});
  }
  const std::size_t step = std::max<std::size_t>(1, (instants.size() + most_instants - 1) / most_instants);
  for (std::size_t t = 0; t < instants.size(); t += step) {
    instants_.push_back(instant_of(instants[t], measurement.observations));
    instants_.back().reading = t;
  }
}

RowSample::Instant RowSample::instant_of(const EquationInstant& from, const Observations& observations) const {
  const Index n = model_.equations();
  Instant instant{.time = from.time,
                  .q = as_vector(from.q),
                  .qd = as_vector(from.qd),
                  .qdd = as_vector(from.qdd),
                  .viscous = VectorXd::Zero(n),
                  .coulomb = VectorXd::Zero(n),
                  .tau = as_vector(from.right),
                  .weights = roots_,
                  .Y = MatrixXd::Zero(n, observations.parameters)};
  for_equations(from, observations.joints, [&](std::size_t i, std::size_t, const auto& row) {
    instant.Y(static_cast<Index>(i), observations.joints[i].columns) = row;
    if (from.used[i] == 0) instant.weights[static_cast<Index>(i)] = 0;
  });
  for_friction(model_, instant, [&](int k, double& entry, int joint) { entry = instant.Y(joint, k); });
  return instant;
}

double RowSample::count() const {
  double count = 0;
  for (const Instant& instant : instants_) count += static_cast<double>((instant.weights.array() > 0).count());
  return count;
}

bool RowSample::has_rows(int equation) const {
  return std::any_of(instants_.begin(), instants_.end(), [&](const Instant& t) { return t.weights[equation] > 0; });
}

bool RowSample::has_rates() const {
  return std::any_of(readings_.begin(), readings_.end(), [](const Reading& each) { return !each.rate.isZero(); });
}

WeightedEquations RowSample::rows(const Change& change) const {
  const Index n = model_.equations();
  WeightedEquations rows;
  for (std::size_t t = 0; t < instants_.size(); ++t) {
    Instant instant = instants_[t];
    change(instant);
    if (t == 0) {
      const Index size = n * static_cast<Index>(instants_.size());
      rows = {MatrixXd(size, instant.Y.cols()), VectorXd(size)};
    }
    const Index first = n * static_cast<Index>(t);
    rows.A.middleRows(first, n) = instant.weights.asDiagonal() * instant.Y;
    rows.b.segment(first, n) = instant.weights.cwiseProduct(instant.tau);
  }
  return rows;
}

void RowSample::follow_motion(Instant& instant) const {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Y(model_.equations(), model_.parameters());
  model_.regressor(instant.q.data(), instant.qd.data(), instant.qdd.data(), Y.data());
  instant.Y.leftCols(model_.parameters()) = Y;
  for_friction(model_, instant, [&](int k, double entry, int joint) { instant.Y(joint, k) = entry; });
}

// Cubic polynomials between neighbours that have rates.
std::optional<VectorXd> RowSample::torques_at(std::size_t place, double time) const {
  const auto follows = [&](std::size_t k) {
    return k + 1 < readings_.size() && readings_[k].log == readings_[k + 1].log &&
           readings_[k].index + 1 == readings_[k + 1].index;
  };
  while (readings_[place].time > time) {
    if (place == 0 || !follows(place - 1)) return std::nullopt;
    --place;
  }
  for (; follows(place); ++place) {
    const Reading &from = readings_[place], &to = readings_[place + 1];
    if (to.time < time) continue;
    const double step = to.time - from.time, u = (time - from.time) / step, v = 1 - u;
    return v * v * ((1 + 2 * u) * from.tau + step * u * from.rate) +
           u * u * ((1 + 2 * v) * to.tau - step * v * to.rate);
  }
  return std::nullopt;
}

// Torques that are late by δ are τ(t - δ), so that Y π = τ(t + δ).
void RowSample::undo_delay(Instant& instant, double delay, int first, int end) const {
  const std::optional<VectorXd> later = torques_at(instant.reading, instant.time + delay);
  if (later) {
    instant.tau.segment(first, end - first) = later->segment(first, end - first);
  } else {
    instant.weights.setZero();
  }
}

RowSample sample_of(const TorqueEquations& equations, const Measurement& measurement, std::size_t most_instants) {
  const VectorXd values = estimate_of(equations, measurement, {}).values;
  return {equations.model(), measurement,
          fit_quality(measurement.observations, measurement.logs, values, equations.acceleration_rows()),
          most_instants};
}

}  // namespace flatdyn
