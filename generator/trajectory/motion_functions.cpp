// SPDX-License-Identifier: GPL-2.0-or-later
#include "trajectory/motion_functions.hpp"

#include <fmt/format.h>

namespace flatdyn {

std::vector<Function> motion_functions(const Model& model, const std::vector<std::string>& names, Progress& progress) {
  if (!model.mechanism.symbols.empty()) {
    throw Failure(ExitCode::unsupported,
                  fmt::format("{}: the robot has free symbols ({}, ...): torques along a trajectory need numbers",
                              model.robot.file, model.mechanism.symbols.front().name),
                  "write numbers for its lengths and masses");
  }
  Model whole = model;
  whole.robot.scene = {};
  whole.abbreviation.reset();
  PipelineOptions options;
  options.functions = names;
  Diagnostics none;
  return functions_of(make_functions(whole, options, progress, none));
}

double tip_torque(std::span<const double> J, std::span<const double> h_e, std::size_t joint) {
  const std::size_t n = J.size() / 6;
  double torque = 0;
  for (std::size_t row = 0; row < h_e.size(); ++row) torque += J[row * n + joint] * h_e[row];
  return torque;
}

}  // namespace flatdyn
