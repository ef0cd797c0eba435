// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/drive_gains.hpp"

#include <Eigen/QR>
#include <numeric>

#include "laboratory/identify/torque_equations.hpp"
#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// The equations k_i τ̂_i = Y_i x of the logged torques τ̂ in the payload's ten parameters and π_b, x, with the factors k.
// The unknowns z are x without the mass, and by joint the relative change κ of 1/k: to first order in it
// k_i τ̂_i - m (Y_i)_m = (Y_i x)_{x ≠ m} + (Y_i x₀) κ_i, where x₀ are the values so far.
class GainProblem {
 public:
  GainProblem(const TorqueModel& model, const PayloadProblem& payload, double mass)
      : model_(model), payload_(payload), mass_(mass) {}

  int joints() const { return model_.equations() - model_.first_joint(); }
  // The unknowns without the changes of factors.
  int constants() const { return payload_.observations.parameters - 1; }
  int unknowns() const { return constants() + joints(); }
  // The joint of an equation, with the payload or without it; nullopt of a floating base's force.
  std::optional<int> joint_of(std::size_t equation) const {
    const int joint = static_cast<int>(equation) % model_.equations() - model_.first_joint();
    return joint < 0 ? std::nullopt : std::optional(joint);
  }

  // The factors that come from equations in which the torques stand among the regressors: noise makes them too small.
  VectorXd first_factors() const {
    const Observations& given = payload_.observations;
    Index rows = 0;
    for (const JointObservations& each : given.joints) rows += each.R.rows();
    MatrixXd A = MatrixXd::Zero(rows, unknowns());
    VectorXd b = VectorXd::Zero(rows);
    Index row = 0;
    for (std::size_t i = 0; i < given.joints.size(); ++i) {
      const JointObservations& own = given.joints[i];
      const std::optional<int> joint = joint_of(i);
      const Index count = own.R.rows();
      for (std::size_t k = 0; k < own.columns.size(); ++k) {
        const auto column = own.R.col(static_cast<Index>(k));
        if (own.columns[k] == 0) {
          b.segment(row, count) -= mass_ * column;
        } else {
          A.col(own.columns[k] - 1).segment(row, count) = column;
        }
      }
      if (joint) {
        A.col(constants() + *joint).segment(row, count) = -own.b();
      } else {
        b.segment(row, count) += own.b();
      }
      row += count;
    }
    const VectorXd lengths = (A.colwise().norm().array() > 0).select(A.colwise().norm(), 1);
    const MatrixXd scaled = A * lengths.cwiseInverse().asDiagonal();
    const VectorXd z = scaled.completeOrthogonalDecomposition().solve(b).cwiseQuotient(lengths);
    VectorXd factors = z.tail(joints());
    for (double& each : factors) each = std::abs(each) > 0 && std::isfinite(each) ? each : 1;
    return factors;
  }

  // x of the unknowns z.
  VectorXd values_of(const VectorXd& z) const {
    VectorXd x(constants() + 1);
    x << mass_, z.head(constants());
    return x;
  }

  Observations observations(const VectorXd& factors, const VectorXd& x) const {
    const Observations& given = payload_.observations;
    Observations result{unknowns(), {}, {}, given.stride, given.shapes};
    for (std::size_t i = 0; i < given.joints.size(); ++i) {
      const JointObservations& own = given.joints[i];
      MatrixXd rows(own.R.rows(), static_cast<Index>(columns_of(i).size()) + 1);
      for (Index row = 0; row < rows.rows(); ++row) {
        const Row changed = row_of(i, own.A().row(row), own.b()(row), factors, x);
        rows.row(row) << changed.entries, changed.right;
      }
      result.joints.push_back({columns_of(i), triangular_factor_of(rows), own.rows, own.correlation, own.left_out});
    }
    for (const EquationInstant& instant : given.instants) {
      EquationInstant changed = instant;
      changed.entries.clear();
      for_equations(instant, given.joints, [&](std::size_t equation, std::size_t place, const auto& row) {
        const Row own = row_of(equation, row, instant.right[place], factors, x);
        changed.entries.insert(changed.entries.end(), own.entries.begin(), own.entries.end());
        changed.right[place] = own.right;
      });
      result.instants.push_back(std::move(changed));
    }
    // The noise above the band is that of the logged torques.
    for (NoiseShape& shape : result.shapes) {
      for (std::size_t i = 0; i < shape.measured_deviations.size(); ++i) {
        const std::optional<int> joint = joint_of(i);
        if (joint) shape.measured_deviations[i] *= std::abs(factors(*joint));
      }
    }
    return result;
  }

  // The rows of accelerations in the unknowns; the mass is known.
  AccelerationRows acceleration_rows() const {
    return [this](const EquationInstant& instant) {
      std::vector<MatrixXd> result;
      for (const MatrixXd& rows : payload_.acceleration_rows(instant)) {
        MatrixXd changed = MatrixXd::Zero(rows.rows(), unknowns() + 1);
        changed.leftCols(constants()) = rows.rightCols(constants());
        changed.rightCols(1) = mass_ * rows.col(0);
        result.push_back(std::move(changed));
      }
      return result;
    };
  }

  // The logs with the noise of the torques that the factors make of the logged ones.
  std::vector<MeasuredLog> scaled(std::vector<MeasuredLog> logs, const VectorXd& factors) const {
    for (MeasuredLog& log : logs) {
      for (std::size_t i = 0; i < log.tau_noise.size(); ++i) {
        const std::optional<int> joint = joint_of(i);
        if (!joint) continue;
        log.tau_noise[i].step *= std::abs(factors(*joint));
        log.tau_noise[i].deviation *= std::abs(factors(*joint));
      }
    }
    return logs;
  }

  VectorXd prior() const {
    VectorXd result = VectorXd::Zero(unknowns());
    result.head(constants()) = payload_.prior.tail(constants());
    return result;
  }

 private:
  struct Row {
    RowVectorXd entries;
    double right = 0;
  };

  std::vector<int> columns_of(std::size_t equation) const {
    std::vector<int> result;
    for (const int column : payload_.observations.joints[equation].columns) {
      if (column > 0) result.push_back(column - 1);
    }
    if (const std::optional<int> joint = joint_of(equation)) result.push_back(constants() + *joint);
    return result;
  }

  Row row_of(std::size_t equation, const RowVectorXd& entries, double right, const VectorXd& factors,
             const VectorXd& x) const {
    const std::vector<int>& columns = payload_.observations.joints[equation].columns;
    const std::optional<int> joint = joint_of(equation);
    const bool has_mass = !columns.empty() && columns.front() == 0;
    const Index kept = entries.size() - (has_mass ? 1 : 0);
    Row result{RowVectorXd(kept + (joint ? 1 : 0)), joint ? factors(*joint) * right : right};
    result.entries.head(kept) = entries.tail(kept);
    if (joint) result.entries(kept) = entries * x(columns);
    if (has_mass) result.right -= mass_ * entries(0);
    return result;
  }

  const TorqueModel& model_;
  const PayloadProblem& payload_;
  double mass_;
};

// The payload of an estimate whose unknowns lack its mass.
PayloadEstimate payload_with(const Estimate& estimate, double mass) {
  constexpr double kExact = 1e-9;  // relative deviation of a mass that counts as exact
  Estimate with_mass = estimate;
  const Index b = estimate.values.size();
  with_mass.values.resize(b + 1);
  with_mass.values << mass, estimate.values;
  with_mass.standard_deviations.resize(b + 1);
  with_mass.standard_deviations << 0, estimate.standard_deviations;
  with_mass.root_information = MatrixXd::Zero(estimate.root_information.rows() + 1, b + 1);
  with_mass.root_information(0, 0) = 1 / (kExact * mass);
  with_mass.root_information.bottomRightCorner(estimate.root_information.rows(), b) = estimate.root_information;
  PayloadEstimate result = payload_of(with_mass);
  result.unknowns = estimate.values;
  return result;
}

}  // namespace

DriveGains drive_gains(const TorqueModel& model, std::vector<Measurement> measurements, double mass) {
  constexpr int kMostRounds = 60;
  constexpr double kSmall = 1e-3;  // standard deviations
  const PayloadProblem payload = payload_problem(
      model, measurements.front().observations, measurements.back().observations, TorqueEquations(model).file_values());
  const GainProblem problem(model, payload, mass);
  EstimateOptions options;
  options.acceleration_rows = problem.acceleration_rows();
  DriveGains result;
  result.factors = problem.first_factors();
  Estimate found =
      estimate(problem.observations(result.factors, VectorXd::Zero(problem.constants() + 1)), problem.prior(), options);
  VectorXd x = problem.values_of(found.values);
  for (int round = 0; round < kMostRounds && !result.converged; ++round) {
    found = estimate(problem.observations(result.factors, x), problem.prior(), options);
    const VectorXd changes = found.values.tail(problem.joints());
    const auto deviations = found.standard_deviations.tail(problem.joints()).array();
    result.converged = round > 0 && ((changes.array().abs() <= kSmall * deviations) || !deviations.isFinite()).all();
    // Half of the way where a factor would change its sign.
    result.factors = result.factors.cwiseQuotient((1 + changes.array()).max(0.5).matrix());
    x = problem.values_of(found.values);
  }
  result.standard_deviations = result.factors.cwiseAbs().cwiseProduct(found.standard_deviations.tail(problem.joints()));
  result.fit.payload = payload_with(found, mass);
  result.fit.observations = problem.observations(result.factors, x);
  result.fit.fits = fit_quality(result.fit.observations, problem.scaled(all_logs(measurements), result.factors),
                                found.values, options.acceleration_rows);
  result.fit.measurements = std::move(measurements);
  return result;
}

}  // namespace flatdyn
