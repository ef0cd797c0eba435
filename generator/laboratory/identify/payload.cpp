// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/payload.hpp"

#include <algorithm>
#include <numeric>

#include "laboratory/identify/physical_parameters.hpp"
#include "laboratory/identify/singular_values.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The change of the base parameters by each of the ten parameters of a body on the tip's link, in that link's frame:
// one column per parameter.
MatrixXd base_change(const TorqueModel& model) {
  const Mechanism& mechanism = model.mechanism();
  const LinkFrame& tip = *std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                       [&](const LinkFrame& link) { return link.link == mechanism.tip.link; });
  MatrixXd change = MatrixXd::Zero(model.parameters(), kInertialPerBody);
  for (int k = 0; k < kInertialPerBody; ++k) {
    const InertialParameters body = transformed(single_parameter(static_cast<Parameter>(k)), tip.R, tip.p);
    const std::vector<Number> entries = entries_of(body);
    for (int row = 0; row < model.parameters(); ++row) {
      for (const auto& [index, coefficient] : model.base().combination[static_cast<std::size_t>(row)]) {
        const int entry = static_cast<int>(parameter_of(index));
        if (joint_of(index) != tip.body || entry >= kInertialPerBody) continue;
        change(row, k) += nearest_double(coefficient * entries[static_cast<std::size_t>(entry)]);
      }
    }
  }
  return change;
}

// The change of the base parameters by each rotor and friction parameter that the robot file lacks: one column each.
MatrixXd change_by_lacking(const TorqueModel& model, const LoadedRobot& robot) {
  const std::vector<bool> given = parameters_in(robot.mechanism, ParameterSet::given);
  std::vector<VectorXd> columns;
  for (int index = 0; index < static_cast<int>(given.size()); ++index) {
    if (given[static_cast<std::size_t>(index)]) continue;
    VectorXd column = VectorXd::Zero(model.parameters());
    for (int row = 0; row < model.parameters(); ++row) {
      const ParameterForm& form = model.base().combination[static_cast<std::size_t>(row)];
      if (const auto entry = form.find(index); entry != form.end()) column(row) = nearest_double(entry->second);
    }
    if (!column.isZero(0)) columns.push_back(std::move(column));
  }
  MatrixXd change(model.parameters(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) change.col(static_cast<Index>(k)) = columns[k];
  return change;
}

std::vector<int> columns_from(int first, Index count) {
  std::vector<int> columns(static_cast<std::size_t>(count));
  std::iota(columns.begin(), columns.end(), first);
  return columns;
}

// A joint's observations with other rows and columns.
JointObservations folded(const MatrixXd& rows, std::vector<int> columns, const JointObservations& of) {
  return {std::move(columns), triangular_factor_of(rows), of.rows, of.correlation};
}

// An instant with other columns: those of each equation times `change`, and then, if `keeps` is true, as they were.
EquationInstant changed(const EquationInstant& instant, const Observations& of, const MatrixXd& change, bool keeps,
                        const VectorXd& origin) {
  EquationInstant result = instant;
  result.entries.clear();
  for_equations(instant, of.joints, [&](std::size_t equation, std::size_t place, const auto& row) {
    const std::vector<int>& columns = of.joints[equation].columns;
    const Eigen::RowVectorXd moved = row * change(columns, Eigen::all);
    result.entries.insert(result.entries.end(), moved.begin(), moved.end());
    if (keeps) result.entries.insert(result.entries.end(), row.begin(), row.end());
    result.right[place] -= row * origin(columns);
  });
  return result;
}

std::vector<MatrixXd> times(std::vector<MatrixXd> rows, const MatrixXd& change) {
  for (MatrixXd& each : rows) each = each * change;
  return rows;
}

// The observations in the unknowns x of a linear substitution π_b = origin + change x.
Observations substituted(const Observations& observations, const VectorXd& origin, const MatrixXd& change) {
  const Index unknowns = change.cols();
  Observations result{static_cast<int>(unknowns), {}, {}, observations.stride, observations.shapes};
  for (const JointObservations& joint : observations.joints) {
    MatrixXd rows(joint.R.rows(), unknowns + 1);
    rows << joint.A() * change(joint.columns, Eigen::all), joint.b() - joint.A() * joint.restricted(origin);
    result.joints.push_back(folded(rows, columns_from(0, unknowns), joint));
  }
  for (const EquationInstant& instant : observations.instants) {
    result.instants.push_back(changed(instant, observations, change, false, origin));
  }
  return result;
}

// The rows of both in the ten payload parameters followed by π_b without the payload; with it, π_b + change x holds.
// Each log has its own rows of a joint, and so its own weights: its noise may differ, also in correlation.
Observations side_by_side(const Observations& with, const Observations& without, const MatrixXd& change) {
  const Index unknowns = change.cols();
  const auto behind = [&](std::vector<int> columns) {
    for (int& column : columns) column += static_cast<int>(unknowns);
    return columns;
  };
  Observations result{static_cast<int>(unknowns) + with.parameters, {}, {}, with.stride, with.shapes};
  for (const JointObservations& joint : with.joints) {
    MatrixXd rows(joint.R.rows(), unknowns + joint.R.cols());
    rows << joint.A() * change(joint.columns, Eigen::all), joint.R;
    std::vector<int> columns = columns_from(0, unknowns);
    for (const int column : behind(joint.columns)) columns.push_back(column);
    result.joints.push_back(folded(rows, std::move(columns), joint));
  }
  for (const JointObservations& joint : without.joints) {
    result.joints.push_back({behind(joint.columns), joint.R, joint.rows, joint.correlation});
  }
  const VectorXd origin = VectorXd::Zero(with.parameters);
  for (const EquationInstant& instant : with.instants) {
    result.instants.push_back(changed(instant, with, change, true, origin));
  }
  for (EquationInstant instant : without.instants) {
    instant.first = static_cast<int>(with.joints.size());
    instant.log += static_cast<int>(with.shapes.size());
    result.instants.push_back(std::move(instant));
  }
  result.shapes.insert(result.shapes.end(), without.shapes.begin(), without.shapes.end());
  return result;
}

// A basis of the same space of columns: each has a 1 in a row in which the others have 0. Earlier rows come first.
MatrixXd echelon(MatrixXd columns) {
  constexpr double kNothing = 1e-6;  // share of the largest entry of a basis of unit length
  Index done = 0;
  for (Index row = 0; row < columns.rows() && done < columns.cols(); ++row) {
    Index pivot = 0;
    if (columns.row(row).tail(columns.cols() - done).cwiseAbs().maxCoeff(&pivot) < kNothing) continue;
    columns.col(done).swap(columns.col(done + pivot));
    columns.col(done) /= columns(row, done);
    for (Index k = 0; k < columns.cols(); ++k) {
      if (k != done) columns.col(k) -= columns(row, k) * columns.col(done).eval();
    }
    ++done;
  }
  return columns;
}

// The null space of the information on the first ten unknowns, whatever the others are.
MatrixXd untold_of_payload(const Estimate& estimate, const MatrixXd& root_of_payload) {
  constexpr double kRounding = 1e-9;  // where columns have unit length
  VectorXd lengths = estimate.root_information.leftCols(kInertialPerBody).colwise().norm();
  lengths = (lengths.array() > 0).select(lengths, 1);
  const SingularValues svd = singular_values(root_of_payload * lengths.cwiseInverse().asDiagonal());
  const Index told = (svd.s.array() > kRounding).count();
  const MatrixXd scaled = svd.V.rightCols(kInertialPerBody - told);
  return echelon((lengths.cwiseInverse().asDiagonal() * scaled).colwise().normalized());
}

}  // namespace

PayloadEstimate payload_of(const Estimate& estimate) {
  PayloadEstimate result;
  result.unknowns = estimate.values;
  result.values = estimate.values.head(kInertialPerBody);
  result.standard_deviations = estimate.standard_deviations.head(kInertialPerBody);
  const MatrixXd root = root_information_of_first(estimate, kInertialPerBody);
  result.untold = untold_of_payload(estimate, root);
  const NearestBody body = nearest_body(result.values, root);
  result.body = body.ten;
  result.largest_misfit = body.largest_misfit;
  return result;
}

PayloadProblem payload_problem(const TorqueModel& model, const LoadedRobot& robot, const Observations& with_payload) {
  const Eigen::Map<const VectorXd> known(model.file_values().data(), model.parameters());
  const MatrixXd payload = base_change(model), lacking = change_by_lacking(model, robot);
  MatrixXd change(payload.rows(), payload.cols() + lacking.cols());
  change << payload, lacking;
  MatrixXd all(change.rows(), change.cols() + 1);
  all << change, known;
  return {
      substituted(with_payload, known, change),
      [&model, all](const EquationInstant& instant) { return times(model.acceleration_rows(instant.q.data()), all); },
      VectorXd::Zero(change.cols())};
}

PayloadProblem payload_problem(const TorqueModel& model, const Observations& with_payload,
                               const Observations& without_payload, const VectorXd& prior) {
  const MatrixXd change = base_change(model);
  PayloadProblem problem{side_by_side(with_payload, without_payload, change), nullptr, {}};
  const Index unknowns = problem.observations.parameters;
  problem.prior = VectorXd::Zero(unknowns);
  problem.prior.tail(prior.size()) = prior;
  MatrixXd without = MatrixXd::Zero(prior.size(), unknowns);
  without.rightCols(prior.size()).setIdentity();
  MatrixXd with = without;
  with.leftCols(kInertialPerBody) = change;
  problem.acceleration_rows = [&model, with, without](const EquationInstant& instant) {
    return times(model.acceleration_rows(instant.q.data()), instant.first == 0 ? with : without);
  };
  return problem;
}

PayloadEstimate estimate_payload(const PayloadProblem& problem) {
  EstimateOptions options;
  options.acceleration_rows = problem.acceleration_rows;
  return payload_of(estimate(problem.observations, problem.prior, options));
}

std::vector<MeasuredLog> all_logs(const std::vector<Measurement>& measurements) {
  std::vector<MeasuredLog> logs;
  for (const Measurement& each : measurements) logs.insert(logs.end(), each.logs.begin(), each.logs.end());
  return logs;
}

FittedPayload fitted_payload(const TorqueModel& model, const LoadedRobot& robot,
                             std::vector<Measurement> measurements) {
  const Observations& with = measurements.front().observations;
  PayloadProblem problem = measurements.size() == 1 ? payload_problem(model, robot, with)
                                                    : payload_problem(model, with, measurements.back().observations,
                                                                      TorqueEquations(model).file_values());
  FittedPayload found{estimate_payload(problem), {}, {}, {}};
  found.fits =
      fit_quality(problem.observations, all_logs(measurements), found.payload.unknowns, problem.acceleration_rows);
  found.observations = std::move(problem.observations);
  found.is_by_file = measurements.size() == 1;
  found.measurements = std::move(measurements);
  return found;
}

}  // namespace flatdyn
