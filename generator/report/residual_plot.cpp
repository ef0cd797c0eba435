// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/residual_plot.hpp"

#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

// The abscissae of the samples: their times; several logs follow each other with a gap between them.
std::vector<double> places_of(const std::vector<EquationInstant>& samples, bool is_one_log) {
  constexpr double kGap = 0.02;  // share of the total time
  double total = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    if (samples[k].log == samples[k - 1].log) total += samples[k].time - samples[k - 1].time;
  }
  std::vector<double> places;
  double shift = is_one_log ? 0 : -samples.front().time;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const bool is_next_log = k > 0 && samples[k].log != samples[k - 1].log;
    if (is_next_log) shift = places.back() + kGap * total - samples[k].time;
    places.push_back(samples[k].time + shift);
  }
  return places;
}

void add(Series& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

// Ends the line that is being drawn.
void interrupt(Series& series) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  if (!series.x.empty() && !std::isnan(series.x.back())) add(series, kGap, kGap);
}

// One joint's half of a row.
Panel half_panel(const TorqueModel& model, int equation, const std::string& what) {
  const std::string title = what == "torque" && equation < model.first_joint() ? "reading" : what;
  Panel panel{model.name_of(equation) + ": " + title, "", model.unit_of(equation), {{what, {}, {}}}};
  panel.is_half = true;
  panel.if_empty = "the joint rests";
  return panel;
}

}  // namespace

std::string residual_plot(const TorqueModel& model, const Observations& observations, const Eigen::VectorXd& values,
                          PictureFormat format) {
  const int n = model.equations(), first = first_equation(model, observations);
  const std::vector<EquationInstant>& samples = observations.instants;
  const bool is_one_log = samples.front().log == samples.back().log;
  std::vector<Panel> panels;
  for (int i = first; i < n; ++i) {
    panels.push_back(half_panel(model, i, "torque"));
    panels.push_back(half_panel(model, i, "residual"));
  }
  for (std::size_t k = panels.size() - 2; k < panels.size(); ++k) {
    panels[k].x_label = is_one_log ? "t in s" : "t in s, one log behind the other";
  }
  const std::vector<double> places = places_of(samples, is_one_log);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const EquationInstant& sample = samples[k];
    const bool is_new = k > 0 && sample.log != samples[k - 1].log;
    const double* entries = sample.entries.data();
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const JointObservations& joint = observations.joints[at];
      const auto count = static_cast<Eigen::Index>(joint.columns.size());
      const Eigen::Map<const Eigen::VectorXd> row(entries, count);
      entries += count;
      if (i < first) continue;
      const auto panel = static_cast<std::size_t>(2 * (i - first));
      Series &torque = panels[panel].series.front(), &residual = panels[panel + 1].series.front();
      const bool is_used = sample.used[at] != 0;
      if (is_new) interrupt(torque);
      if (is_new || !is_used) interrupt(residual);
      add(torque, places[k], sample.right[at]);
      if (is_used) add(residual, places[k], sample.right[at] - row.dot(joint.restricted(values)));
    }
  }
  // The line of zero gives the residual the same time axis as the torque next to it, whatever rows are used.
  for (std::size_t at = 1; at < panels.size(); at += 2) {
    if (panels[at].series.front().x.empty()) continue;
    panels[at].series.push_back({"", {places.front(), places.back()}, {0, 0}, SeriesKind::guide});
  }
  return plot("Torques and residuals of " + model.mechanism().name, panels, format);
}

}  // namespace flatdyn
