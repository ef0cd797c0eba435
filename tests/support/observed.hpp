// SPDX-License-Identifier: GPL-2.0-or-later
// The equations of a motion that is known with all its derivatives, without a filter.
#pragma once

#include "laboratory/identify/observations.hpp"
#include "laboratory/identify/torque_equations.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {

// h_e: by sample, what a sensor at the wrist measures; empty if there is none.
inline Observations observed(const EquationModel& equations, const Mechanism& mechanism,
                             const std::vector<SimulatedSample>& samples,
                             const std::vector<std::vector<double>>& h_e = {}) {
  StreamPlan plan;
  LogLayout& layout = plan.heading.layout;
  layout.joints = mechanism.size();
  layout.positions = mechanism.position_count();
  for (int i = 0; i < layout.joints; ++i) layout.position_of.push_back(mechanism.position_of(i));
  layout.has_rates = layout.has_accelerations = true;
  layout.has_tip_force = !h_e.empty();
  plan.filter.dt = 1;
  plan.rest_speed.assign(static_cast<std::size_t>(layout.joints), 0);
  ObservationFolder folder(equations);
  EquationFilter filter(plan, equations, [&](const FilteredEquations& each) { folder.add(each); });
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const SimulatedSample& sample = samples[k];
    std::vector<double> channels = {sample.time};
    for (const Eigen::VectorXd* each : {&sample.q, &sample.tau, &sample.qd, &sample.qdd}) {
      channels.insert(channels.end(), each->begin(), each->end());
    }
    if (!h_e.empty()) channels.insert(channels.end(), h_e[k].begin(), h_e[k].end());
    filter.sample({channels.data(), static_cast<long>(k), static_cast<long>(k)});
  }
  return folder.observations();
}

inline Observations observed(const TorqueModel& torque, const std::vector<SimulatedSample>& samples) {
  return observed(TorqueEquations(torque), torque.mechanism(), samples);
}

}  // namespace flatdyn::testing
