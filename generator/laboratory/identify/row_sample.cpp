// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/row_sample.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowByRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t kMostInstants = 256;

bool is_friction(const TorqueModel& model, int column) {
  const Parameter parameter = parameter_of(model.base().columns[static_cast<std::size_t>(column)]);
  return parameter == Parameter::Fv || parameter == Parameter::Fs;
}

VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

}  // namespace

RowSample::RowSample(const TorqueModel& model, const Measurement& measurement, const std::vector<JointFit>& fits)
    : model_(model), parameters_(measurement.observations.parameters) {
  constexpr double kLeastNoise = 1e-3;  // share of the torque: sharper rows would follow the filter's errors
  const Observations& observations = measurement.observations;
  const std::vector<EquationInstant>& instants = observations.instants;
  step_ = std::max<std::size_t>(1, (instants.size() + kMostInstants - 1) / kMostInstants);
  for (const EquationInstant& each : instants) {
    readings_.push_back({each.log, each.index, each.time, as_vector(each.right), as_vector(each.measured_rates)});
  }
  for (std::size_t t = 0; t < instants.size(); t += step_) {
    const EquationInstant& from = instants[t];
    Instant instant{as_vector(from.q),
                    as_vector(from.qd),
                    as_vector(from.qdd),
                    as_vector(from.right),
                    as_vector(from.measured_rates),
                    MatrixXd::Zero(model.equations(), observations.parameters)};
    const double* entries = from.entries.data();
    for (int i = 0; i < model.equations(); ++i) {
      for (const int column : observations.joints[static_cast<std::size_t>(i)].columns) {
        instant.Y(i, column) = *entries++;
      }
      instant.used.push_back(from.used[static_cast<std::size_t>(i)] != 0);
    }
    instants_.push_back(std::move(instant));
  }
  for (int i = 0; i < model.equations(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double torque = observations.joints[at].rms_torque();
    const double sigma = std::max({fits[at].expected, kLeastNoise * torque, 1e-9});
    weights_.push_back(1 / (sigma * sigma));
  }
  for (int i = 0; i < model.equations(); ++i) normals_.push_back(joint_normal(i, i));
}

void RowSample::Normal::add(const Eigen::RowVectorXd& row, double tau, double weight) {
  H.selfadjointView<Eigen::Lower>().rankUpdate(row.transpose(), weight);
  h += weight * tau * row.transpose();
  s += weight * tau * tau;
}

// The least cost, with columns scaled to unit length; directions that the rows do not determine stay at 0.
double RowSample::least(const Normal& normal, VectorXd* solution) {
  constexpr double kRidge = 1e-10;
  const VectorXd scale = normal.H.diagonal().cwiseSqrt().cwiseMax(1e-150).cwiseInverse();
  MatrixXd H = scale.asDiagonal() * MatrixXd(normal.H.selfadjointView<Eigen::Lower>()) * scale.asDiagonal();
  H.diagonal().array() += kRidge;
  const VectorXd h = scale.cwiseProduct(normal.h);
  const VectorXd x = Eigen::LLT<MatrixXd>(H).solve(h);
  if (solution != nullptr) *solution = scale.cwiseProduct(x);
  return std::max(normal.s - h.dot(x), 0.0);
}

RowSample::Normal RowSample::joint_normal(int joint, int torques_of) const {
  const Index b = parameters_;
  Normal normal{MatrixXd::Zero(b, b), VectorXd::Zero(b)};
  for (const Instant& instant : instants_) {
    if (!instant.used[static_cast<std::size_t>(joint)]) continue;
    normal.add(instant.Y.row(joint), instant.tau[torques_of], weights_[static_cast<std::size_t>(joint)]);
  }
  return normal;
}

RowSample::Normal RowSample::sum_without(int joint, int other) const {
  const Index b = parameters_;
  Normal sum{MatrixXd::Zero(b, b), VectorXd::Zero(b)};
  for (int i = 0; i < model_.equations(); ++i) {
    if (i == joint || i == other) continue;
    const Normal& each = normals_[static_cast<std::size_t>(i)];
    sum.H += each.H;
    sum.h += each.h;
    sum.s += each.s;
  }
  return sum;
}

double RowSample::cost(VectorXd* parameters) const { return least(sum_without(-1), parameters); }

double RowSample::count() const {
  double count = 0;
  for (const Instant& instant : instants_) {
    count += static_cast<double>(std::count(instant.used.begin(), instant.used.end(), true));
  }
  return count;
}

double RowSample::cost_with_gain(int joint, double gain, VectorXd* parameters) const {
  Normal sum = sum_without(joint);
  const Normal& own = normals_[static_cast<std::size_t>(joint)];
  sum.H += gain * gain * own.H;
  sum.h += gain * own.h;
  sum.s += own.s;
  return least(sum, parameters);
}

double RowSample::cost_with_exchanged_torques(int joint, int other) const {
  Normal sum = sum_without(joint, other);
  for (const auto& [row, tau] : {std::pair(joint, other), std::pair(other, joint)}) {
    const Normal exchanged = joint_normal(row, tau);
    sum.H += exchanged.H;
    sum.h += exchanged.h;
    sum.s += exchanged.s;
  }
  return least(sum);
}

double RowSample::cost_with_torque_offset(int joint, double& offset) const {
  const Index b = parameters_;
  const Normal rest = sum_without(joint);
  Normal sum{MatrixXd::Zero(b + 1, b + 1), VectorXd::Zero(b + 1), rest.s};
  sum.H.topLeftCorner(b, b) = rest.H;
  sum.h.head(b) = rest.h;
  for (const Instant& instant : instants_) {
    if (!instant.used[static_cast<std::size_t>(joint)]) continue;
    Eigen::RowVectorXd row(b + 1);
    row << instant.Y.row(joint), 1;
    sum.add(row, instant.tau[joint], weights_[static_cast<std::size_t>(joint)]);
  }
  VectorXd solution;
  const double cost = least(sum, &solution);
  offset = solution[b];
  return cost;
}

double RowSample::cost_with_reaction() const {
  Normal sum = sum_without(-1);
  for (int i = 0; i < model_.first_joint(); ++i) sum.h -= 2 * normals_[static_cast<std::size_t>(i)].h;
  return least(sum);
}

// Cubic polynomials between neighbours that have rates.
std::optional<RowSample::Reading> RowSample::reading_at(std::size_t place, double time) const {
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
    return Reading{
        from.log, from.index, time,
        v * v * ((1 + 2 * u) * from.tau + step * u * from.rate) + u * u * ((1 + 2 * v) * to.tau - step * v * to.rate),
        6 * u * v / step * (to.tau - from.tau) + v * (v - 2 * u) * from.rate + u * (u - 2 * v) * to.rate};
  }
  return std::nullopt;
}

// Torques that are late by δ are τ(t - δ), so that Y π = τ(t + δ); by the method of Gauss and Newton.
double RowSample::cost_with_delay(double& delay, int first, int end) const {
  constexpr int kMostRounds = 20;
  constexpr double kLargestStep = 0.02, kSmall = 1e-6;  // s
  const Index b = parameters_;
  delay = 0;
  double least_cost = cost();
  const bool has_rates =
      std::any_of(instants_.begin(), instants_.end(), [](const Instant& each) { return !each.tau_rate.isZero(); });
  for (int round = 0; round < kMostRounds && has_rates; ++round) {
    Normal sum{MatrixXd::Zero(b + 1, b + 1), VectorXd::Zero(b + 1)};
    double rows = 0;
    for (std::size_t t = 0; t < instants_.size(); ++t) {
      const std::optional<Reading> reading = reading_at(t * step_, readings_[t * step_].time + delay);
      for (int i = 0; i < model_.equations() && reading; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!instants_[t].used[at]) continue;
        Eigen::RowVectorXd row(b + 1);
        const bool is_late = i >= first && i < end;
        row << instants_[t].Y.row(i), is_late ? -reading->rate[i] : 0;
        sum.add(row, is_late ? reading->tau[i] : instants_[t].tau[i], weights_[at]);
        ++rows;
      }
    }
    if (2 * rows < count()) break;
    VectorXd solution;
    least_cost = least(sum, &solution) * count() / rows;
    const double step = std::clamp(solution[b], -kLargestStep, kLargestStep);
    delay += step;
    if (std::abs(step) < kSmall) break;
  }
  return least_cost;
}

double RowSample::cost_of(const std::vector<MatrixXd>& Y, VectorXd* parameters) const {
  std::vector<int> same(static_cast<std::size_t>(model_.equations()));
  std::iota(same.begin(), same.end(), 0);
  return cost_of(Y, same, parameters);
}

double RowSample::cost_of(const std::vector<MatrixXd>& Y, const std::vector<int>& of, VectorXd* parameters) const {
  const Index columns = Y.front().cols();
  Normal sum{MatrixXd::Zero(columns, columns), VectorXd::Zero(columns)};
  for (std::size_t t = 0; t < instants_.size(); ++t) {
    for (int i = 0; i < model_.equations(); ++i) {
      const int from = of[static_cast<std::size_t>(i)];
      const auto at = static_cast<std::size_t>(from);
      if (instants_[t].used[at]) sum.add(Y[t].row(i), instants_[t].tau[from], weights_[at]);
    }
  }
  return least(sum, parameters);
}

double RowSample::cost_with_more(const std::function<MatrixXd(const Instant&)>& columns) const {
  std::vector<MatrixXd> rows;
  for (const Instant& instant : instants_) {
    const MatrixXd more = columns(instant);
    rows.emplace_back(instant.Y.rows(), instant.Y.cols() + more.cols());
    rows.back() << instant.Y, more;
  }
  return cost_of(rows);
}

// Y at changed motions. `map` is the same change of a vector of the joints: friction is filtered, and moves with it.
std::vector<MatrixXd> RowSample::changed_rows(const std::function<void(Instant&)>& change, const JointMap& map) const {
  std::vector<MatrixXd> rows;
  RowByRow y(model_.equations(), model_.parameters());
  for (const Instant& instant : instants_) {
    Instant changed = instant;
    change(changed);
    model_.regressor(changed.q.data(), changed.qd.data(), changed.qdd.data(), y.data());
    for (const Parameter kind : {Parameter::Fv, Parameter::Fs}) {
      VectorXd friction = VectorXd::Zero(model_.equations());
      for (int k = 0; k < model_.parameters(); ++k) {
        const int index = model_.base().columns[static_cast<std::size_t>(k)];
        if (parameter_of(index) == kind) friction[joint_of(index)] = instant.Y(joint_of(index), k);
      }
      map(friction.tail(model_.joints()));
      for (int k = 0; k < model_.parameters(); ++k) {
        const int index = model_.base().columns[static_cast<std::size_t>(k)];
        if (is_friction(model_, k) && parameter_of(index) == kind) y(joint_of(index), k) = friction[joint_of(index)];
      }
    }
    MatrixXd all = instant.Y;
    all.leftCols(model_.parameters()) = y;
    rows.push_back(std::move(all));
  }
  return rows;
}

double RowSample::cost_with_positions(const JointMap& map) const {
  return cost_of(changed_rows(
      [&](Instant& instant) {
        for (VectorXd* each : {&instant.q, &instant.qd, &instant.qdd}) map(each->tail(model_.joints()));
      },
      map));
}

double RowSample::cost_with_exchanged_joints(int joint, int other) const {
  const auto exchange = [&](Eigen::Ref<VectorXd> of_joints) { std::swap(of_joints[joint], of_joints[other]); };
  std::vector<int> of(static_cast<std::size_t>(model_.equations()));
  std::iota(of.begin(), of.end(), 0);
  std::swap(of[static_cast<std::size_t>(model_.first_joint() + joint)],
            of[static_cast<std::size_t>(model_.first_joint() + other)]);
  return cost_of(changed_rows(
                     [&](Instant& instant) {
                       for (VectorXd* each : {&instant.q, &instant.qd, &instant.qdd}) {
                         exchange(each->tail(model_.joints()));
                       }
                     },
                     exchange),
                 of);
}

double RowSample::cost_with_offset(int joint, double offset) const {
  return cost_of(changed_rows([&](Instant& instant) { instant.q[joint] += offset; }, [](const auto&) {}));
}

double RowSample::cost_with_base(const std::function<void(VectorXd& qd, VectorXd& qdd)>& change) const {
  return cost_of(changed_rows([&](Instant& instant) { change(instant.qd, instant.qdd); }, [](const auto&) {}));
}

}  // namespace flatdyn
