// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/residual_noise.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "laboratory/identify/variance_fit.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr long kFittedLags = 4, kOwnLags = 24;  // of two equations, of one with itself

// The mean variances of the noise above the band, in one sample: of all equations, then of all joints; 0 where it is
// not known.
VectorXd known_variances(const Observations& observations, Index joints) {
  const auto n = static_cast<Index>(observations.joints.size());
  VectorXd sums = VectorXd::Zero(n + joints), counts = VectorXd::Zero(n + joints);
  for (const EquationInstant& instant : observations.instants) {
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(instant.log)];
    const auto add = [&](Index at, double deviation) {
      sums[at] += deviation * deviation;
      counts[at] += 1;
    };
    for (std::size_t i = 0; i < shape.measured_deviations.size(); ++i) {
      if (instant.used[i] != 0) add(instant.first + static_cast<Index>(i), shape.measured_deviations[i]);
    }
    for (Index j = 0; j < std::min(joints, static_cast<Index>(shape.acceleration_deviations.size())); ++j) {
      add(n + j, shape.acceleration_deviations[static_cast<std::size_t>(j)]);
    }
  }
  return sums.cwiseQuotient(counts.cwiseMax(1));
}

// By joint: the largest variance that its noise may have in any of the logs.
VectorXd most_of_accelerations(const Observations& observations, Index joints) {
  VectorXd most = VectorXd::Zero(joints);
  for (const NoiseShape& shape : observations.shapes) {
    for (Index j = 0; j < joints; ++j) {
      const bool is_known = j < static_cast<Index>(shape.most_of_accelerations.size());
      const double own =
          is_known ? shape.most_of_accelerations[static_cast<std::size_t>(j)] : std::numeric_limits<double>::infinity();
      most[j] = std::max(most[j], own);
    }
  }
  return most;
}

// An orthonormal basis of what the rows of `matrix` span, as columns, but for what is nothing beside the rest.
MatrixXd row_space(const MatrixXd& matrix) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(matrix.transpose());
  return qr.householderQ() * MatrixXd::Identity(matrix.cols(), qr.rank());
}

}  // namespace

struct NoiseSearch::Residuals {
  MatrixXd left;                   // residuals(): instants × equations
  std::vector<MatrixXd> inertias;  // by instant
  VectorXd squares;                // by equation, their mean

  Index joints() const { return inertias.empty() ? 0 : inertias.front().cols(); }
};

// The sums of weighted least squares for the unknowns.
struct NoiseSearch::Sums {
  MatrixXd H;
  VectorXd h;

  explicit Sums(Index size) : H(MatrixXd::Zero(size, size)), h(VectorXd::Zero(size)) {}
  void add(const VectorXd& row, double right, double scale) {
    H += scale * scale * row * row.transpose();
    h += scale * scale * right * row;
  }
  // The first unknowns count only for what is more than chance explains.
  void leave_chance(Index first) {
    constexpr double kDeviations = 2;
    h.head(first) -= kDeviations * H.diagonal().head(first).cwiseSqrt();
  }
};

// The products of residuals of two equations that are `lag` rows apart, summed, and what the acceleration noise of each
// joint makes of them.
struct NoiseSearch::LaggedProduct {
  double product = 0;
  VectorXd of_accelerations{};
  long count = 0;
};

NoiseSearch::LaggedProduct NoiseSearch::lagged_product(const Residuals& residuals, Index i, Index k, long lag) const {
  const Index joints = residuals.joints();
  const std::vector<MatrixXd>& B = residuals.inertias;
  LaggedProduct result{.of_accelerations = VectorXd::Zero(joints)};
  const Observations& observations = structure_.observations();
  structure_.for_pairs(lag, [&](Index t, Index later) {
    const double product = residuals.left(t, i) * residuals.left(later, k);
    if (std::isnan(product)) return;
    const EquationInstant& instant = observations.instants[static_cast<std::size_t>(t)];
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(instant.log)];
    result.product += product;
    const Index first = instant.first;
    for (Index j = 0; j < joints; ++j) {
      result.of_accelerations[j] +=
          shape.acceleration[static_cast<std::size_t>(j)][lag] *
          (B[static_cast<std::size_t>(t)](i - first, j) * B[static_cast<std::size_t>(later)](k - first, j));
    }
    ++result.count;
  });
  return result;
}

VectorXd with_known_part(const VectorXd& values, Index columns) {
  VectorXd result = VectorXd::Ones(columns);
  result.head(values.size()) = values;
  return result;
}

std::vector<MatrixXd> inertias(const Observations& observations, const VectorXd& values, const AccelerationRows& rows) {
  std::vector<MatrixXd> result;
  if (!rows) return result;
  for (const EquationInstant& instant : observations.instants) {
    const std::vector<MatrixXd> of_joints = rows(instant);
    MatrixXd B(of_joints.front().rows(), static_cast<Index>(of_joints.size()));
    for (std::size_t j = 0; j < of_joints.size(); ++j) {
      B.col(static_cast<Index>(j)) = of_joints[j] * with_known_part(values, of_joints[j].cols());
    }
    result.push_back(std::move(B));
  }
  return result;
}

MatrixXd residuals(const Observations& observations, const VectorXd& values) {
  const auto n = static_cast<Index>(observations.joints.size());
  MatrixXd result = MatrixXd::Constant(static_cast<Index>(observations.instants.size()), n, std::nan(""));
  for (Index t = 0; t < result.rows(); ++t) {
    const EquationInstant& instant = observations.instants[static_cast<std::size_t>(t)];
    for_equations(instant, observations.joints, [&](std::size_t i, std::size_t place, const auto& row) {
      if (instant.used[place] == 0) return;
      result(t, static_cast<Index>(i)) = instant.right[place] - row * observations.joints[i].restricted(values);
    });
  }
  return result;
}

VectorXd known_squares(const Observations& observations) {
  const auto n = static_cast<Index>(observations.joints.size());
  VectorXd sums = VectorXd::Zero(n), counts = VectorXd::Zero(n);
  for (const EquationInstant& instant : observations.instants) {
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(instant.log)];
    for (std::size_t i = 0; i < instant.used.size() && !shape.measured_deviations.empty(); ++i) {
      if (instant.used[i] == 0) continue;
      const Index equation = instant.first + static_cast<Index>(i);
      sums[equation] += shape.measured[0] * std::pow(shape.measured_deviations[i], 2);
      counts[equation] += 1;
    }
  }
  return sums.cwiseQuotient(counts.cwiseMax(1));
}

// Σ Uᵀ C U over all equations by kind, where U are an equation's rows in the coordinates of the fit, weighted: all
// equations are taken to have each kind in proportion to what the fit leaves of them.
NoiseSearch::NoiseSearch(const NoiseStructure& structure, const FitGain& gain, const AccelerationRows& rows)
    : structure_(structure), rows_(rows), freedom_(gain.freedom) {
  const Observations& observations = structure.observations();
  const Index size = gain.spread.cols();
  std::vector<MatrixXd> information(structure.kinds().size(), MatrixXd::Zero(size, size));
  for (Index i = 0; i < gain.weights.size(); ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    const MatrixXd Y = structure.rows_of(i), S = gain.spread(joint.columns, Eigen::all);
    for (std::size_t k = 0; k < structure.kinds().size(); ++k) {
      const MatrixXd C = Y.transpose() * structure.correlated(Y, i, structure.kinds()[k]);
      information[k] += structure.row_ratios()[i] * gain.weights[i] * (S.transpose() * C * S);
    }
  }
  for (Index i = 0; i < gain.weights.size(); ++i) add_own(i, gain, information);
}

// The noise n leaves residuals n - U Σ Uᵀ w n: the fit takes C U w Uᵀ and its transpose off the covariance C of a kind,
// and adds U w (Σ Uᵀ C U w) Uᵀ.
void NoiseSearch::add_own(Index equation, const FitGain& gain, const std::vector<MatrixXd>& information) {
  const JointObservations& joint = structure_.observations().joints[static_cast<std::size_t>(equation)];
  const MatrixXd S = gain.spread(joint.columns, Eigen::all), basis = row_space(S);
  const MatrixXd U = structure_.rows_of(equation) * (S * basis);
  const double weight = gain.weights[equation];
  std::vector<MatrixXd> taken, added;
  for (std::size_t k = 0; k < structure_.kinds().size(); ++k) {
    taken.push_back(weight * structure_.correlated(U, equation, structure_.kinds()[k]));
    added.push_back(U * (weight * (basis.transpose() * information[k] * basis)));
  }
  const auto add = [&](long lag, bool is_of_repetitions) {
    OwnProduct own{equation, lag, is_of_repetitions, 0, VectorXd::Zero(static_cast<Index>(taken.size()))};
    const auto visit = [&](Index a, Index b) {
      if (!structure_.uses(a, equation) || !structure_.uses(b, equation)) return;
      ++own.count;
      const auto log = static_cast<std::size_t>(structure_.observations().instants[static_cast<std::size_t>(a)].log);
      for (std::size_t k = 0; k < taken.size(); ++k) {
        const NoiseKind& kind = structure_.kinds()[k];
        double& sum = own.of_kinds[static_cast<Index>(k)];
        if (kind.is_repeated || !is_of_repetitions) sum += kind.by_log[log][lag];
        if (U.cols() == 0) continue;
        sum += U.row(a).dot(added[k].row(b)) - U.row(a).dot(taken[k].row(b)) - taken[k].row(a).dot(U.row(b));
      }
    };
    is_of_repetitions ? structure_.for_repeated_pairs(lag, visit) : structure_.for_pairs(lag, visit);
    if (own.count > 0) own_.push_back(std::move(own));
  };
  for (long lag = 0; lag < kOwnLags; ++lag) add(lag, false);
  for (long lag = 0; lag < kOwnLags && structure_.has_repetition(); ++lag) add(lag, true);
}

// By equation: the mean square of the residuals, or that of the noise above the band if it is more.
VectorXd NoiseSearch::mean_squares(const MatrixXd& left) const {
  VectorXd result = known_squares(structure_.observations());
  for (Index i = 0; i < result.size(); ++i) {
    const auto is_used = left.col(i).array().isFinite();
    const double count = is_used.cast<double>().sum(), sum = is_used.select(left.col(i).array(), 0).square().sum();
    if (count > 0) result[i] = std::max(result[i], sum / count);
  }
  return result;
}

void NoiseSearch::add_own_products(const Residuals& residuals, Sums& sums) const {
  for (const OwnProduct& own : own_) {
    const Index i = own.equation;
    if (residuals.squares[i] <= 0) continue;
    VectorXd row = VectorXd::Zero(sums.h.size());
    for (Index k = 0; k < own.of_kinds.size(); ++k) row[place_of(i, k)] = own.of_kinds[k];
    double product = 0;
    if (own.is_of_repetitions) {
      structure_.for_repeated_pairs(own.lag, [&](Index a, Index b) {
        const double each = residuals.left(a, i) * residuals.left(b, i);
        if (!std::isnan(each)) product += each;
      });
    } else {
      const LaggedProduct found = lagged_product(residuals, i, i, own.lag);
      product = found.product;
      row.tail(residuals.joints()) = freedom_[i] * found.of_accelerations;
    }
    sums.add(row, product, 1 / std::sqrt(freedom_[i] * static_cast<double>(own.count)) / residuals.squares[i]);
  }
}

// Noise of torques is not common to two equations, noise of accelerations is.
void NoiseSearch::add_common_products(const Residuals& residuals, Sums& sums) const {
  const Index n = residuals.squares.size(), joints = residuals.joints();
  for (Index i = 0; i < n && joints > 0; ++i) {
    for (Index k = 0; k < n; ++k) {
      const double size = std::sqrt(residuals.squares[i] * residuals.squares[k]);
      if (size <= 0 || i == k) continue;
      const double free = std::sqrt(freedom_[i] * freedom_[k]);
      for (long lag = 0; lag < kFittedLags; ++lag) {
        const LaggedProduct found = lagged_product(residuals, i, k, lag);
        if (found.count == 0) continue;
        VectorXd row = VectorXd::Zero(sums.h.size());
        row.tail(joints) = free * found.of_accelerations;
        sums.add(row, found.product, 1 / std::sqrt(free * static_cast<double>(found.count)) / size);
      }
    }
  }
}

ResidualNoise NoiseSearch::noise_of(const VectorXd& values) const {
  const Observations& observations = structure_.observations();
  Residuals found{residuals(observations, values), inertias(observations, values, rows_), {}};
  found.squares = mean_squares(found.left);
  const Index n = found.squares.size(), joints = found.joints(), kinds = kind_count();
  Sums sums(n * kinds + joints);
  add_own_products(found, sums);
  add_common_products(found, sums);
  const Index optional = n * (kinds - 1);
  sums.leave_chance(optional);
  VectorXd known = VectorXd::Zero(sums.h.size());
  known.tail(n + joints) = known_variances(observations, joints);
  // Residuals that positions do not explain by what they show above the band are misfit of the torques.
  VectorXd most = VectorXd::Constant(sums.h.size(), std::numeric_limits<double>::infinity());
  most.tail(joints) = most_of_accelerations(observations, joints);
  const FittedVariances fitted = fitted_variances(sums.H, sums.h, known, most, optional, joints);
  ResidualNoise result{MatrixXd(n, kinds), fitted.values.tail(joints),
                       fitted.covariance.bottomRightCorner(joints, joints)};
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < kinds; ++k) result.torques(i, k) = fitted.values[place_of(i, k)];
  }
  return result;
}

}  // namespace flatdyn
