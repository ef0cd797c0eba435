// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/estimate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

// The parameters that make up nearly all of a unit direction, largest first.
std::string main_parameters(const TorqueEquations& equations, const Eigen::VectorXd& components) {
  constexpr double kShown = 0.2;
  std::vector<int> indices;
  for (Eigen::Index k = 0; k < components.size(); ++k) {
    if (std::abs(components(k)) > kShown) indices.push_back(static_cast<int>(k));
  }
  std::stable_sort(indices.begin(), indices.end(),
                   [&](int a, int b) { return std::abs(components(a)) > std::abs(components(b)); });
  std::string names;
  for (const int k : indices) names += " " + equations.names()[static_cast<std::size_t>(k)];
  return names;
}

}  // namespace

std::string untold_text(const TorqueEquations& equations, const Estimate& estimate, bool lacks_base_force) {
  std::string text;
  if (lacks_base_force) {
    text +=
        "\nno log has the force on the base, base_fx to base_nz: the base's own ten parameters keep the robot file's\n"
        "values\n";
  }
  if (!estimate.damped.empty()) {
    text +=
        "\ndirections that this motion does not tell; along them nothing leaves the robot file's values (damped least\n"
        "squares), but their parameters may lie in others, too. Relative singular value and parameters of each:\n";
  }
  for (const auto& [singular_value, components] : estimate.damped) {
    text += fmt::format("  {:8.1e} {}\n", singular_value, main_parameters(equations, components));
  }
  if (!estimate.hidden.empty()) {
    text +=
        "\ndirections that noise hides: it could make more of them than the robot file has of anything, and the log\n"
        "tells of anything; along them values stay near the file's. Standard deviation without that, and parameters of "
        "each:\n";
  }
  for (const auto& [deviation, components] : estimate.hidden) {
    text += fmt::format("  {:8.1e} {}\n", deviation, main_parameters(equations, components));
  }
  return text;
}

std::string conditioning_text(const Estimate& estimate) {
  constexpr Eigen::Index kInALine = 10;
  std::string text = fmt::format("\ncondition number {:.4g}; weights {} after {} iterations\n", estimate.condition(),
                                 estimate.converged ? "stable" : "not stable", estimate.iterations);
  text += "singular values (rows weighted, columns scaled to unit norm):";
  for (Eigen::Index k = 0; k < estimate.singular_values.size(); ++k) {
    text += fmt::format("{}{:.3g}", k % kInALine == 0 ? "\n  " : " ", estimate.singular_values(k));
  }
  return text + "\n";
}

}  // namespace flatdyn
