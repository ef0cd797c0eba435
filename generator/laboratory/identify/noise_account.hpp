// SPDX-License-Identifier: GPL-2.0-or-later
// Takes account of noise in a solution of least squares: of its correlation, which intervals depend on, and of noise of
// positions in the regressor, which least squares takes for motion.
//
// Noise ΔY in the regressor adds E[ΔYᵀ W ΔY] to the information Yᵀ W Y and makes parameters smaller than they are. It
// is taken off again (bias compensation; Söderström, Automatica 43, 2007). Its size is estimated, and where it is most
// of the information along a direction (NoisyDirection), that is left open.
#pragma once

#include "laboratory/identify/damped_solution.hpp"
#include "laboratory/identify/residual_noise.hpp"

namespace flatdyn {

// `weights`: by equation, of the squares of residuals. `freedom`: by equation, the share of its rows that the fit
// leaves. Sets the values, their covariance, Solution::noisy and ::compensation. Without instants nothing is changed;
// unless it `compensates`, the values stay, and noise of positions counts in their covariance alone. They stay, too,
// where the residuals without it are so much larger that it is no noise (Solution::growth).
void take_account_of_noise(Solution& solution, const Observations& observations, const Eigen::VectorXd& weights,
                           const Eigen::VectorXd& freedom, const AccelerationRows& rows, bool compensates = true);

}  // namespace flatdyn
