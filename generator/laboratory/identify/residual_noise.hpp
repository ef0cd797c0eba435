// SPDX-License-Identifier: GPL-2.0-or-later
// The noise that is left in the equations after the fit, with its correlation across time and across joints, and what
// it does to the parameters.
//
// Noise enters a log in the measured torques and in the positions (or rates), such as the rounding of an encoder. Both
// are white above the band; in the band, torques of drives may have slower noise, too (NoiseShape::coloured). The
// filter shapes both (NoiseShape). Noise of joint j's position enters all equations through column j of B(q), and is
// strongest where it is fast, so that it hides little of what a slow motion shows: intervals that took it for white
// would be several times too wide. The variances of both kinds come from the residuals.
#pragma once

#include <functional>

#include "laboratory/identify/observations.hpp"

namespace flatdyn {

// ∂Y/∂q̈_j of an instant by joint j: one row per equation of the instant, one column per parameter. Times the
// parameters, this is column j of B(q). If some of the torques is known and not in Y, a last column has this part's
// share of column j of B(q).
using AccelerationRows = std::function<std::vector<Eigen::MatrixXd>(const EquationInstant& instant)>;

// `values` as `columns` numbers: with 1 behind them for the known part of acceleration rows, if they have one.
Eigen::VectorXd with_known_part(const Eigen::VectorXd& values, Eigen::Index columns);

// B(q) of every instant: one row per equation of the instant, one column per joint. Empty if `rows` is null.
std::vector<Eigen::MatrixXd> inertias(const Observations& observations, const Eigen::VectorXd& values,
                                      const AccelerationRows& rows);

// Residuals of all equations at the instants, NaN where an equation is not used: instants × equations.
Eigen::MatrixXd residuals(const Observations& observations, const Eigen::VectorXd& values);

struct ResidualNoise {
  Eigen::VectorXd measured;                 // by equation: variance of the torque's noise in one sample, (N m)² or N²
  Eigen::MatrixXd coloured;                 // by equation and colour: variance of slower noise, at one stride
  Eigen::VectorXd acceleration;             // by joint: variance of the noise of q, q̇ or q̈ in one sample
  Eigen::MatrixXd acceleration_covariance;  // of the errors of `acceleration`
};

// The noise above the band, which `observations` know from the logs, counts as much as this many rows of a joint.
constexpr double kRowsOfKnownNoise = 8;

// By equation: the mean square of what the torque's noise above the band leaves in a row; 0 if it is not known.
Eigen::VectorXd known_squares(const Observations& observations);

// The variances that explain best the residuals of `values` at lags 0 … 3 of all pairs of equations and at lags 0 … 11
// of each by itself, and the noise above the band; none is negative. `freedom`: by equation, the share of its rows that
// the fit leaves. `rows` may be null: noise of positions then counts as noise of torques.
ResidualNoise residual_noise(const Observations& observations, const Eigen::VectorXd& values,
                             const Eigen::VectorXd& freedom, const AccelerationRows& rows);

// The covariance of Σ Y_iᵀ w_i e_i over all equations i and rows, where e is such noise and w_i the weights: b².
Eigen::MatrixXd score_covariance(const Observations& observations, const Eigen::VectorXd& values,
                                 const Eigen::VectorXd& weights, const ResidualNoise& noise,
                                 const AccelerationRows& rows);

// Noise of positions is in Y, too, where least squares takes it for motion: E[ΔYᵀ W ΔY] by joint, b² each, of noise
// with variance 1 in every sample, and as many columns more as acceleration rows have. Empty if `rows` is null.
std::vector<Eigen::MatrixXd> false_information(const Observations& observations, const Eigen::VectorXd& weights,
                                               const AccelerationRows& rows);

}  // namespace flatdyn
