// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/excitation_objective.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "laboratory/identify/conditioning.hpp"

namespace flatdyn {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Samples per period of the highest harmonic, and equations per parameter.
constexpr int kObjectiveSamplesPerPeriod = 10, kEquationsPerParameter = 3;
// The power of the norm that approximates the largest value along the motion.
constexpr double kPower = 24;
// The penalty of torques: p % too large in all samples adds p²/10 % to the condition number.
constexpr double kTorqueWeight = 1000;
// The step of a forward difference; q̈ enters linearly, so any step is exact for it.
constexpr double kStep = 1e-7, kAccelerationStep = 1;

int samples_for(const MotionEquations& equations, int harmonics) {
  const int wanted = kEquationsPerParameter * equations.parameters();
  return std::max(kObjectiveSamplesPerPeriod * harmonics, (wanted + equations.equations() - 1) / equations.equations());
}

// Y_b stacked over all samples; state(k) returns q, q̇ and q̈ of sample k.
template <typename State>
MatrixXd stacked(const MotionEquations& equations, int samples, const State& state) {
  const int n = equations.equations();
  MatrixXd all(samples * n, equations.parameters());
  for (int k = 0; k < samples; ++k) {
    const auto [q, qd, qdd] = state(k);
    all.middleRows(k * n, n) = equations.regressor(q.data(), qd.data(), qdd.data());
  }
  return all;
}

}  // namespace

// A motion of the search. `shape` is the series before it is scaled to the limits: column i by scale(i).
struct ExcitationObjective::Motion {
  MatrixXd coefficients;         // terms × coordinates
  MatrixXd shape[3];             // samples × coordinates
  VectorXd scale;                // by coordinate
  std::vector<VectorXd> shrink;  // d scale / d coefficient, one per coordinate
};

ExcitationObjective::ExcitationObjective(const MotionEquations& equations, std::vector<JointLimits> limits,
                                         double duration, int harmonics)
    : equations_(equations),
      limits_(std::move(limits)),
      duration_(duration),
      units_(2 * harmonics, equations.coordinates()),
      lengths_(VectorXd::Ones(equations.parameters())) {
  for (const JointLimits& joint : limits_) rest_.push_back(joint.middle());
  const VectorXd at_rest = torques_at_rest();
  for (int i = 0; i < equations.coordinates(); ++i) {
    least_torques_.push_back((std::abs(at_rest(i)) + limits_[static_cast<std::size_t>(i)].torque) / 2);
  }
  const int count = samples_for(equations, harmonics);
  for (MatrixXd& basis : basis_) basis.resize(count, 2 * harmonics);
  for (int l = 1; l <= harmonics; ++l) {
    for (int k = 0; k < count; ++k) {
      const Deflection terms[] = {sine_term(duration, l, time(k)), cosine_term(duration, l, time(k))};
      for (int j = 0; j < 2; ++j) {
        const int column = 2 * (l - 1) + j;
        basis_[0](k, column) = terms[j].q;
        basis_[1](k, column) = terms[j].qd;
        basis_[2](k, column) = terms[j].qdd;
      }
    }
    const double frequency = 2 * std::numbers::pi * l / duration;
    for (int i = 0; i < equations.coordinates(); ++i) {
      const JointLimits& joint = limits_[static_cast<std::size_t>(i)];
      units_.col(i)
          .segment(2 * (l - 1), 2)
          .setConstant(std::min({joint.reach() * frequency, joint.speed, joint.acceleration / frequency}));
    }
  }
}

void ExcitationObjective::scale_by(const std::vector<std::vector<double>>& motions) {
  VectorXd squares = VectorXd::Zero(equations_.parameters());
  for (const std::vector<double>& x : motions)
    squares += regressor(motion(x.data())).colwise().squaredNorm().transpose();
  lengths_ = (squares / static_cast<double>(motions.size())).cwiseSqrt().cwiseMax(std::numeric_limits<double>::min());
}

VectorXd ExcitationObjective::torques_at_rest() const {
  const std::vector<double> zero(rest_.size());
  return equations_.torques(rest_.data(), zero.data(), zero.data());
}

void ExcitationObjective::lower_torques(const std::vector<double>& factors) {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    limits_[i].torque = std::max(factors[i] * limits_[i].torque, std::min(least_torques_[i], limits_[i].torque));
  }
}

ExcitationObjective::Motion ExcitationObjective::motion(const double* x) const {
  Motion motion;
  motion.coefficients = units_.cwiseProduct(Eigen::Map<const MatrixXd>(x, terms(), equations_.coordinates()));
  for (int d = 0; d < 3; ++d) motion.shape[d] = basis_[d] * motion.coefficients;
  motion.scale.resize(equations_.coordinates());
  // This weight makes the norm of a sine wave equal its amplitude.
  const double weight = std::sqrt(2 * std::numbers::pi * kPower) / 2 / samples();
  for (int i = 0; i < equations_.coordinates(); ++i) {
    const JointLimits& limits = limits_[static_cast<std::size_t>(i)];
    const double largest[] = {limits.reach(), limits.speed, limits.acceleration};
    double sum = 1;
    VectorXd slope = VectorXd::Zero(terms());
    for (int d = 0; d < 3; ++d) {
      const ArrayXd shape = motion.shape[d].col(i).array();
      const ArrayXd powers = weight * (shape / largest[d]).abs().pow(kPower);
      sum += powers.sum();
      const ArrayXd by_shape = powers / (shape == 0).select(1, shape);
      slope += basis_[d].transpose() * by_shape.matrix();
    }
    motion.scale(i) = std::pow(sum, -1 / kPower);
    motion.shrink.push_back(-motion.scale(i) / sum * slope);
  }
  return motion;
}

FourierTrajectory ExcitationObjective::trajectory(const double* x) const {
  const Motion found = motion(x);
  std::vector<FourierSeries> series(rest_.size());
  for (int i = 0; i < equations_.coordinates(); ++i) {
    for (int k = 0; k < terms(); ++k) {
      FourierSeries& joint = series[static_cast<std::size_t>(i)];
      (k % 2 == 0 ? joint.a : joint.b).push_back(found.scale(i) * found.coefficients(k, i));
    }
  }
  return {duration_, rest_, series};
}

std::vector<double> ExcitationObjective::coefficients(const FourierTrajectory& trajectory) const {
  std::vector<double> x;
  for (int i = 0; i < equations_.coordinates(); ++i) {
    const FourierSeries& joint = trajectory.series()[static_cast<std::size_t>(i)];
    for (int k = 0; k < terms(); ++k) {
      x.push_back((k % 2 == 0 ? joint.a : joint.b)[static_cast<std::size_t>(k / 2)] / units_(k, i));
    }
  }
  return x;
}

VectorXd ExcitationObjective::state(const Motion& motion, int derivative, int sample) const {
  VectorXd values = motion.scale.cwiseProduct(motion.shape[derivative].row(sample).transpose());
  if (derivative == 0) values += Eigen::Map<const VectorXd>(rest_.data(), equations_.coordinates());
  return values;
}

MatrixXd ExcitationObjective::regressor(const Motion& motion) const {
  return stacked(equations_, samples(), [&](int k) {
    return std::array{state(motion, 0, k), state(motion, 1, k), state(motion, 2, k)};
  });
}

MatrixXd ExcitationObjective::with_known(const MatrixXd& regressor) const {
  if (known_.size() == 0) return regressor;
  return (MatrixXd(regressor.rows() + known_.rows(), regressor.cols()) << regressor, known_).finished();
}

double ExcitationObjective::torque_penalty(const Motion& motion, const MatrixXd& regressor, MatrixXd* slope,
                                           VectorXd* by_torque) const {
  const VectorXd& values = equations_.file_values();
  VectorXd tau = regressor * values;
  for (int k = 0; k < samples(); ++k) add_springs_to(tau, motion, k);
  if (by_torque != nullptr) *by_torque = VectorXd::Zero(tau.size());
  const double weight = torque_weight_ * kTorqueWeight / samples();
  double penalty = 0;
  for (Eigen::Index row = 0; row < tau.size(); ++row) {
    const Eigen::Index coordinate = equations_.first_equation() + row % equations_.equations();
    const double limit = limits_[static_cast<std::size_t>(coordinate)].torque;
    const double excess = std::abs(tau(row)) / limit - 1;
    if (excess <= 0) continue;
    penalty += weight * excess * excess;
    if (by_torque == nullptr) continue;
    (*by_torque)(row) = std::copysign(2 * weight * excess / limit, tau(row));
    slope->row(row) += (*by_torque)(row)*values.transpose();
  }
  return penalty;
}

// The torques of springs in sample k, behind those of a floating base.
void ExcitationObjective::add_springs_to(VectorXd& tau, const Motion& motion, int k) const {
  if (!equations_.model().mechanism().has_springs()) return;
  const VectorXd now[] = {state(motion, 0, k), state(motion, 1, k), state(motion, 2, k)};
  const PlannedState at = equations_.state(now[0].data(), now[1].data(), now[2].data());
  equations_.model().add_springs(at.q.data(), tau.data() + k * equations_.equations() - equations_.first_equation());
}

void ExcitationObjective::add_springs(const VectorXd& by_torque, MatrixXd& by_position) const {
  const int n = equations_.equations(), joints = equations_.model().joints();
  for (int k = 0; k < samples(); ++k) {
    by_position.row(k).tail(joints) +=
        (equations_.model().stiffness() * by_torque.segment(k * n + n - joints, joints)).transpose();
  }
}

// Turns the slope by entries of the regressor into that by q, q̇ and q̈ of each joint in each sample.
void ExcitationObjective::by_motion(const Motion& motion, const MatrixXd& regressor, const MatrixXd& slope,
                                    MatrixXd* by) const {
  const int n = equations_.equations(), coordinates = equations_.coordinates();
  for (int d = 0; d < 3; ++d) by[d].resize(samples(), coordinates);
  for (int k = 0; k < samples(); ++k) {
    VectorXd now[] = {state(motion, 0, k), state(motion, 1, k), state(motion, 2, k)};
    for (int d = 0; d < 3; ++d) {
      const double step = d == 2 ? kAccelerationStep : kStep;
      for (int i = 0; i < coordinates; ++i) {
        const double here = now[d](i);
        now[d](i) += step;
        const MotionEquations::RowByRow y = equations_.regressor(now[0].data(), now[1].data(), now[2].data());
        const auto rows = Eigen::seqN(k * n, n);
        by[d](k, i) =
            (y - regressor(rows, Eigen::all)).cwiseProduct(slope(rows, Eigen::all)).sum() / (now[d](i) - here);
        now[d](i) = here;
      }
    }
  }
}

void ExcitationObjective::by_coefficients(const Motion& motion, const MatrixXd* by, double* gradient) const {
  Eigen::Map<MatrixXd> result(gradient, terms(), equations_.coordinates());
  for (int i = 0; i < equations_.coordinates(); ++i) {
    double by_scale = 0;
    VectorXd column = VectorXd::Zero(terms());
    for (int d = 0; d < 3; ++d) {
      column += motion.scale(i) * (basis_[d].transpose() * by[d].col(i));
      by_scale += by[d].col(i).dot(motion.shape[d].col(i));
    }
    column += by_scale * motion.shrink[static_cast<std::size_t>(i)];
    result.col(i) = column.cwiseProduct(units_.col(i));
  }
}

double ExcitationObjective::operator()(const double* x, double* gradient) const {
  const Motion found = motion(x);
  const MatrixXd y = regressor(found);
  const VectorXd inverse = lengths_.cwiseInverse();
  MatrixXd slope;
  double value = excitation_cost(with_known(y) * inverse.asDiagonal(), gradient != nullptr ? &slope : nullptr);
  if (gradient != nullptr) slope = (slope.topRows(y.rows()) * inverse.asDiagonal()).eval();
  VectorXd by_torque;
  value +=
      gradient != nullptr ? torque_penalty(found, y, &slope, &by_torque) : torque_penalty(found, y, nullptr, nullptr);
  if (gradient != nullptr) {
    MatrixXd by[3];
    by_motion(found, y, slope, by);
    add_springs(by_torque, by[0]);
    by_coefficients(found, by, gradient);
  }
  return value;
}

double ExcitationObjective::cost(const FourierTrajectory& trajectory) const {
  const MatrixXd y = stacked(equations_, samples(), [&](int k) { return trajectory.at(time(k)); });
  return excitation_cost(with_known(y) * lengths_.cwiseInverse().asDiagonal(), nullptr);
}

}  // namespace flatdyn
