// SPDX-License-Identifier: GPL-2.0-or-later
// The effect on the parameters of the noise that is left in the equations.
#pragma once

#include "laboratory/identify/residual_noise.hpp"

namespace flatdyn {

// The covariance of Σ Y_iᵀ w_i e_i over all equations i and rows, where e is such noise and w_i the weights: b².
Eigen::MatrixXd score_covariance(const NoiseStructure& structure, const Eigen::VectorXd& values,
                                 const Eigen::VectorXd& weights, const ResidualNoise& noise,
                                 const AccelerationRows& rows);

// Noise of positions is in Y, too, where least squares takes it for motion: E[ΔYᵀ W ΔY] by joint, b² each, of noise
// with variance 1 in every sample, and as many columns more as acceleration rows have. Empty if `rows` is null.
std::vector<Eigen::MatrixXd> false_information(const NoiseStructure& structure, const Eigen::VectorXd& weights,
                                               const AccelerationRows& rows);

}  // namespace flatdyn
