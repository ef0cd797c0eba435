// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/excitation_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {
namespace {

// The triangular factor of one matrix above the other; either may be empty.
Eigen::MatrixXd stacked_factor(const Eigen::MatrixXd& above, const Eigen::MatrixXd& below) {
  if (above.size() == 0) return below;
  return triangular_factor_of((Eigen::MatrixXd(above.rows() + below.rows(), below.cols()) << above, below).finished());
}

// A log that cannot show anything, because the filter's window takes all of it.
void refuse_empty(const Measurement& measurement, const std::filesystem::path& log, Diagnostics& diagnostics) {
  if (measurement.count.used > 0) return;
  diagnostics.error({log.string(), 0}, fmt::format("none of {} samples can be used", measurement.count.lines),
                    "log longer runs without gaps, or q, qd and qdd, so that there is no filter");
}

}  // namespace

LoggedInformation information_of(const Observations& observations, double seconds) {
  LoggedInformation result{Eigen::MatrixXd::Zero(observations.parameters, observations.parameters)};
  for (const JointObservations& joint : observations.joints) {
    const Eigen::MatrixXd A = joint.A();
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(A.rows(), observations.parameters);
    rows(Eigen::all, joint.columns) = std::sqrt(seconds) * A;
    result.root = stacked_factor(result.root, rows);
    result.seconds = std::max(result.seconds, seconds * static_cast<double>(joint.rows));
  }
  return result;
}

LoggedInformation logged_information(const TorqueModel& model, const std::vector<std::filesystem::path>& logs,
                                     const std::string& imu, Progress& progress, Diagnostics& diagnostics) {
  const TorqueEquations equations(model);
  LoggedInformation all;
  std::map<LogIdentity, std::string> known;
  for (const std::filesystem::path& log : logs) {
    const Measurement measurement = measure(equations, model.mechanism(), {log}, {.imu = imu}, progress, diagnostics);
    if (!diagnostics.has_errors()) refuse_empty(measurement, log, diagnostics);
    if (diagnostics.has_errors()) return all;
    const MeasuredLog& read = measurement.logs.front();
    const auto [before, is_new] = known.emplace(read.identity, log.string());
    if (!is_new) {
      diagnostics.error({log.string(), 0},
                        fmt::format("the same log as {}, by name, size and beginning", before->second),
                        "what is given twice would count as new data; a log of another motion needs another name");
      return all;
    }
    const LoggedInformation more = information_of(measurement.observations, read.filter.dt * read.filter.decimate);
    all.root = stacked_factor(all.root, more.root);
    all.seconds += more.seconds;
  }
  return all;
}

}  // namespace flatdyn
