// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/residual_plot.hpp"

namespace flatdyn {

std::string residual_plot(const TorqueModel& model, const Identification& found, PictureFormat format) {
  const int n = model.joints(), b = model.parameters();
  std::vector<Panel> panels;
  for (const Body& body : model.mechanism().joints()) {
    panels.push_back(
        {body.joint, "", body.prismatic ? "tau in N" : "tau in N m", {{"measured", {}, {}}, {"residual", {}, {}}}});
  }
  panels.back().x_label = "t in s";
  std::vector<double> y(static_cast<std::size_t>(n * b));
  for (const MotionSample& sample : found.measurement.samples) {
    model.regressor(sample.q.data(), sample.qd.data(), sample.qdd.data(), y.data());
    for (int i = 0; i < n; ++i) {
      const Eigen::Map<const Eigen::VectorXd> row(y.data() + i * b, b);
      const double measured = sample.tau[static_cast<std::size_t>(i)];
      std::vector<Series>& series = panels[static_cast<std::size_t>(i)].series;
      for (Series& each : series) each.x.push_back(sample.time);
      series[0].y.push_back(measured);
      series[1].y.push_back(measured - row.dot(found.estimate.values));
    }
  }
  return plot("Torques and residuals of " + model.mechanism().name, panels, format);
}

}  // namespace flatdyn
