// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/payload.hpp"

#include "identify/physical_parameters.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Columns: what ten parameters of a body on the tip's link, in that link's frame, add to the base parameters.
MatrixXd base_change(const TorqueModel& model) {
  const Mechanism& mechanism = model.mechanism();
  const LinkFrame& tip = *std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                       [&](const LinkFrame& link) { return link.link == mechanism.tip.link; });
  MatrixXd change = MatrixXd::Zero(model.parameters(), kInertialPerBody);
  for (int k = 0; k < kInertialPerBody; ++k) {
    const InertialParameters body = transformed(unit_parameter(static_cast<Parameter>(k)), tip.R, tip.p);
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

std::vector<int> first_columns(Index count) {
  std::vector<int> columns(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = static_cast<int>(k);
  return columns;
}

// Rows in the unknowns of a linear substitution π_b = origin + change x.
Observations substituted(const Observations& observations, const VectorXd& origin, const MatrixXd& change) {
  const Index unknowns = change.cols();
  Observations result{static_cast<int>(unknowns), {}};
  for (const JointObservations& joint : observations.joints) {
    TriangularFactor factor(static_cast<int>(unknowns));
    MatrixXd rows(joint.R.rows(), unknowns + 1);
    rows.leftCols(unknowns) = joint.A() * change(joint.columns, Eigen::all);
    rows.col(unknowns) = joint.b() - joint.A() * joint.restricted(origin);
    for (Index k = 0; k < rows.rows(); ++k) factor.next_row() = rows.row(k);
    result.joints.push_back({first_columns(unknowns), factor.factor(), joint.rows});
  }
  return result;
}

}  // namespace

PayloadEstimate payload_of(const Estimate& estimate) {
  PayloadEstimate result;
  result.values = estimate.values.head(kInertialPerBody);
  result.standard_deviations = estimate.standard_deviations.head(kInertialPerBody);
  const NearestBody body =
      nearest_body(result.values, estimate.covariance.topLeftCorner(kInertialPerBody, kInertialPerBody));
  result.body = body.ten;
  result.largest_misfit = body.largest_misfit;
  return result;
}

PayloadEstimate estimate_payload(const TorqueModel& model, const Observations& with_payload,
                                 const VectorXd& without_payload) {
  const Observations change = substituted(with_payload, without_payload, base_change(model));
  return payload_of(estimate(change, VectorXd::Zero(kInertialPerBody)));
}

}  // namespace flatdyn
