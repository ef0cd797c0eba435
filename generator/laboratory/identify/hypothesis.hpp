// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of a log as something unknown would make them, and the values of the unknown with which they fit best. Whatever
// a fit is not linear in is found by this one search: gains, offsets, delays, gravity's direction, speeds of friction.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

namespace flatdyn {

// Equations A π = b, each divided by its noise.
struct WeightedEquations {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
};

// A number in which the rows are not linear.
struct Unknown {
  double step = 1e-4;  // of derivatives, to either side
  double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();
};

struct Hypothesis {
  std::vector<Unknown> unknowns{};
  // The rows where the unknowns are x; as many rows for every x.
  std::function<WeightedEquations(const Eigen::VectorXd& x)> apply;
  // Values from which the search may start, one at least.
  std::vector<Eigen::VectorXd> starts{Eigen::VectorXd()};
};

struct HypothesisFit {
  double cost = 0;             // |A π - b|²
  Eigen::VectorXd pi;          // the parameters with which the rows fit best; 0 along directions that they leave open
  Eigen::VectorXd deviations;  // of π where the unknowns are exact, by noise of 1 in each row
  Eigen::VectorXd x{};         // the unknowns
};

// The fit of rows that are known.
HypothesisFit fit_of(WeightedEquations rows);
// The fit where the unknowns are x.
HypothesisFit fit_at(const Hypothesis& hypothesis, const Eigen::VectorXd& x);
// The fit with least cost in the valley of x: by Levenberg and Marquardt (Ceres), with π solved for in every step
// (variable projection; Kaufman 1975).
HypothesisFit fit_near(const Hypothesis& hypothesis, const Eigen::VectorXd& x);
// The same from the start with least cost.
HypothesisFit best_fit(const Hypothesis& hypothesis);

// JᵀJ of the unknowns, whatever π is: the cost grows by Δxᵀ information Δx about its least.
Eigen::MatrixXd information_on_unknowns(const Hypothesis& hypothesis, const Eigen::VectorXd& x);

}  // namespace flatdyn
