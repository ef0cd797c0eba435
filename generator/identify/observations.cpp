// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/observations.hpp"

#include <algorithm>

namespace flatdyn {

double JointObservations::rms_residual(const Eigen::VectorXd& pi_b) const {
  const Eigen::VectorXd residual = A() * restricted(pi_b) - b();
  return residual.norm() / std::sqrt(static_cast<double>(rows));
}

double JointObservations::rms_torque() const { return b().norm() / std::sqrt(static_cast<double>(rows)); }

void Observations::set_correlation(double correlation) {
  for (JointObservations& joint : joints) joint.correlation = correlation;
}

ObservationFolder::ObservationFolder(const TorqueModel& model)
    : model_(model),
      y_(static_cast<std::size_t>(model.joints() * model.parameters())),
      tip_(static_cast<std::size_t>(model.joints())) {
  for (int i = 0; i < model.joints(); ++i) factors_.emplace_back(static_cast<int>(model.columns_of(i).size()));
}

void ObservationFolder::add(const MeasuredMotion& motion) {
  model_.regressor(motion.q, motion.qd, motion.qdd, y_.data());
  if (motion.h_e != nullptr) model_.tip_torque(motion.q, motion.h_e, tip_.data());
  for (int i = 0; i < model_.joints(); ++i) {
    const double* const y = y_.data() + i * model_.parameters();
    auto row = factors_[static_cast<std::size_t>(i)].next_row();
    Eigen::Index k = 0;
    for (const int column : model_.columns_of(i)) row[k++] = y[column];
    row[k] = motion.tau[i] - tip_[static_cast<std::size_t>(i)];
  }
}

Observations ObservationFolder::observations() {
  Observations result{model_.parameters(), {}};
  for (int i = 0; i < model_.joints(); ++i) {
    TriangularFactor& factor = factors_[static_cast<std::size_t>(i)];
    result.joints.push_back({model_.columns_of(i), factor.factor(), factor.count()});
  }
  return result;
}

// If noise is correlated differently in the two, the worse value holds for all.
Observations joined(const Observations& a, const Observations& b) {
  Observations result{a.parameters, {}};
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    TriangularFactor factor(static_cast<int>(a.joints[i].columns.size()));
    for (const Observations* each : {&a, &b}) factor.join(each->joints[i].R, each->joints[i].rows);
    const double correlation = std::max(a.joints[i].correlation, b.joints[i].correlation);
    result.joints.push_back({a.joints[i].columns, factor.factor(), factor.count(), correlation});
  }
  return result;
}

}  // namespace flatdyn
