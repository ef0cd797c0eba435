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

#include "laboratory/identify/noise_structure.hpp"

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
  Eigen::MatrixXd torques;                  // by equation and NoiseStructure::kinds(): variance, (N m)² or N²
  Eigen::VectorXd acceleration;             // by joint: variance of the noise of q, q̇ or q̈ in one sample
  Eigen::MatrixXd acceleration_covariance;  // of the errors of `acceleration`
};

// The noise above the band, which `observations` know from the logs, counts as much as this many rows of a joint.
constexpr double kRowsOfKnownNoise = 8;

// By equation: the mean square of what the torque's noise above the band leaves in a row; 0 if it is not known.
Eigen::VectorXd known_squares(const Observations& observations);

// How a fit makes parameters of the equations.
struct FitGain {
  Eigen::MatrixXd spread;   // Solution::spread
  Eigen::VectorXd weights;  // by equation, of the squares of residuals
  Eigen::VectorXd freedom;  // by equation, the share of its rows that the fit leaves of white noise
};

// The variances that explain best the residuals of `values` at lags 0 … 3 of all pairs of equations, at lags 0 … 23 of
// each by itself and of repetitions of a motion, and the noise above the band; none is negative. What a fit takes away
// of each kind of noise is taken account of. `rows` may be null: noise of positions then counts as noise of torques.
class NoiseSearch {
 public:
  NoiseSearch(const NoiseStructure& structure, const FitGain& gain, const AccelerationRows& rows);

  ResidualNoise noise_of(const Eigen::VectorXd& values) const;

 private:
  // The products of an equation's residuals at one lag, summed: what noise of each kind makes of them.
  struct OwnProduct {
    Eigen::Index equation = 0;
    long lag = 0;
    bool is_of_repetitions = false;
    long count = 0;
    Eigen::VectorXd of_kinds{};
  };
  struct Residuals;
  struct Sums;
  struct LaggedProduct;

  void add_own(Eigen::Index equation, const FitGain& gain, const std::vector<Eigen::MatrixXd>& information);
  Eigen::VectorXd mean_squares(const Eigen::MatrixXd& left) const;
  LaggedProduct lagged_product(const Residuals& residuals, Eigen::Index i, Eigen::Index k, long lag) const;
  void add_own_products(const Residuals& residuals, Sums& sums) const;
  void add_common_products(const Residuals& residuals, Sums& sums) const;

  // The unknowns in one vector: all kinds of noise of torques but the white one by equation, the white one by equation,
  // then noise of accelerations by joint.
  Eigen::Index place_of(Eigen::Index equation, Eigen::Index kind) const {
    const auto equations = freedom_.size(), others = kind_count() - 1;
    return kind == 0 ? equations * others + equation : equation * others + kind - 1;
  }
  Eigen::Index kind_count() const { return static_cast<Eigen::Index>(structure_.kinds().size()); }

  const NoiseStructure& structure_;
  const AccelerationRows& rows_;
  Eigen::VectorXd freedom_;  // by equation
  std::vector<OwnProduct> own_;
};

}  // namespace flatdyn
