// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/residual_noise.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr long kFittedLags = 4, kOwnLags = 12;  // of two equations, of one with itself
constexpr Index kColours = static_cast<Index>(NoiseShape::kColours.size());

// Variances without negative ones, and the covariance of their errors.
struct FittedVariances {
  VectorXd values;
  MatrixXd covariance;
};

// Whether b is the instant that is `lag` rows behind a.
bool follows(const EquationInstant& a, const EquationInstant& b, long lag) {
  return a.log == b.log && b.index - a.index == lag;
}

// The x from 0 to `most` that minimises xᵀ H x / 2 - hᵀ x, by coordinates.
VectorXd bounded_minimum(const MatrixXd& H, const VectorXd& h, const VectorXd& most) {
  constexpr int kRounds = 500;
  VectorXd x = VectorXd::Zero(h.size());
  for (int round = 0; round < kRounds; ++round) {
    for (Index k = 0; k < h.size(); ++k) {
      if (H(k, k) <= 0) continue;
      x[k] = std::clamp(x[k] + (h[k] - H.row(k).dot(x)) / H(k, k), 0.0, most[k]);
    }
  }
  return x;
}

// The variances x that minimise xᵀ H x / 2 - hᵀ x, where known ones are measurements, too. These are sure to a share of
// the variance itself: where the residuals are far larger than they say, they hardly count. Of the `optional` ones,
// which come first, those that are zero count as absent in the covariance. `most`: the largest values that they may
// have.
FittedVariances with_known(const MatrixXd& H, const VectorXd& h, const VectorXd& known, const VectorXd& most,
                           Index optional) {
  constexpr int kRounds = 6;
  FittedVariances result;
  for (int round = 0; round < kRounds; ++round) {
    MatrixXd all = H;
    VectorXd right = h;
    for (Index k = 0; k < known.size() && round > 0; ++k) {
      if (known[k] == 0) continue;
      const double weight = kRowsOfKnownNoise / 2 / std::pow(std::max(known[k], result.values[k]), 2);
      all(k, k) += weight;
      right[k] += weight * known[k];
    }
    // Both kinds have very different units: each unknown is scaled by its own column.
    const VectorXd diagonal = all.diagonal();
    const VectorXd units = (diagonal.array() > 0).select(diagonal.cwiseSqrt().cwiseInverse(), 0);
    MatrixXd scaled = units.asDiagonal() * all * units.asDiagonal();
    const VectorXd most_scaled = (units.array() > 0).select(most.cwiseQuotient(units), most);
    result.values = units.cwiseProduct(bounded_minimum(scaled, units.cwiseProduct(right), most_scaled));
    for (Index k = 0; k < optional; ++k) {
      if (result.values[k] > 0) continue;
      scaled.row(k).setZero();
      scaled.col(k).setZero();
    }
    result.covariance =
        units.asDiagonal() * scaled.completeOrthogonalDecomposition().pseudoInverse() * units.asDiagonal();
  }
  return result;
}

// The same, without noise of accelerations (the last `joints` unknowns) where neither the log gives it nor the
// residuals show it, as with q̈ of its own: its uncertainty alone would widen all intervals.
FittedVariances without_doubtful(const MatrixXd& H, const VectorXd& h, const VectorXd& known, const VectorXd& most,
                                 Index optional, Index joints) {
  const FittedVariances all = with_known(H, h, known, most, optional);
  if (joints == 0 || (known.tail(joints).array() > 0).any()) return all;
  MatrixXd fewer = H;
  fewer.rightCols(joints).setZero();
  fewer.bottomRows(joints).setZero();
  VectorXd right = h;
  right.tail(joints).setZero();
  const FittedVariances without = with_known(fewer, right, known, most, optional);
  const auto misfit = [&](const VectorXd& x) { return x.dot(H * x) - 2 * h.dot(x); };
  // Chance explains about one per joint at most.
  const double explained = misfit(without.values) - misfit(all.values);
  return explained > static_cast<double>(joints) ? all : without;
}

// The mean products of residuals of two equations that are `lag` rows apart, and what the kinds of noise make of them:
// the first equation's torque noise, white and by colour, then each joint's acceleration noise.
struct LaggedProduct {
  double product = 0;
  double of_measured = 0;
  VectorXd of_colours = VectorXd::Zero(kColours);
  VectorXd of_accelerations{};
  long count = 0;
};

LaggedProduct lagged_product(const Observations& observations, const MatrixXd& left, const std::vector<MatrixXd>& B,
                             Index i, Index k, long lag, Index joints) {
  LaggedProduct result{.of_accelerations = VectorXd::Zero(joints)};
  const std::vector<EquationInstant>& instants = observations.instants;
  for (std::size_t t = 0; t + static_cast<std::size_t>(lag) < instants.size(); ++t) {
    const std::size_t later = t + static_cast<std::size_t>(lag);
    if (!follows(instants[t], instants[later], lag)) continue;
    const double product = left(static_cast<Index>(t), i) * left(static_cast<Index>(later), k);
    if (std::isnan(product)) continue;
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(instants[t].log)];
    result.product += product;
    if (i == k) {
      result.of_measured += shape.measured[lag];
      for (Index c = 0; c < kColours; ++c) result.of_colours[c] += shape.coloured[static_cast<std::size_t>(c)][lag];
    }
    if (!B.empty()) {
      const Index first = instants[t].first;
      for (Index j = 0; j < joints; ++j) {
        result.of_accelerations[j] +=
            shape.acceleration[static_cast<std::size_t>(j)][lag] * (B[t](i - first, j) * B[later](k - first, j));
      }
    }
    ++result.count;
  }
  return result;
}

// By equation: rows of all instants per row of those that are kept.
VectorXd row_ratios(const Observations& observations, const MatrixXd& left) {
  const auto n = static_cast<Index>(observations.joints.size());
  VectorXd ratios = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    const auto kept = static_cast<double>(left.col(i).array().isNaN().select(0, VectorXd::Ones(left.rows())).sum());
    if (kept > 0) ratios[i] = static_cast<double>(observations.joints[static_cast<std::size_t>(i)].rows) / kept;
  }
  return ratios;
}

// The autocorrelation of noise in the rows of a log.
using Correlation = std::function<VectorXd(const NoiseShape& shape)>;

// Σ over rows s and t of a log of correlation(s - t) rows(s)ᵀ rows(t).
MatrixXd correlated_sum(const Observations& observations, const MatrixXd& rows, const Correlation& correlation_of) {
  std::vector<VectorXd> correlations;
  for (const NoiseShape& shape : observations.shapes) correlations.push_back(correlation_of(shape));
  MatrixXd smoothed = MatrixXd::Zero(rows.rows(), rows.cols());
  const std::vector<EquationInstant>& instants = observations.instants;
  for (std::size_t t = 0; t < instants.size(); ++t) {
    const VectorXd& correlation = correlations[static_cast<std::size_t>(instants[t].log)];
    const auto at = static_cast<Index>(t);
    smoothed.row(at) += correlation[0] * rows.row(at);
    for (std::size_t later = t + 1; later < instants.size(); ++later) {
      const long lag = instants[later].index - instants[t].index;
      if (instants[later].log != instants[t].log || lag >= correlation.size()) break;
      smoothed.row(at) += correlation[lag] * rows.row(static_cast<Index>(later));
      smoothed.row(static_cast<Index>(later)) += correlation[lag] * rows.row(at);
    }
  }
  return rows.transpose() * smoothed;
}

// The rows of equation i at all instants, zero where it is not used: instants × columns.
MatrixXd rows_of(const Observations& observations, Index i) {
  const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
  const auto count = static_cast<Index>(joint.columns.size());
  MatrixXd rows = MatrixXd::Zero(static_cast<Index>(observations.instants.size()), count);
  for (Index t = 0; t < rows.rows(); ++t) {
    const EquationInstant& instant = observations.instants[static_cast<std::size_t>(t)];
    for_equations(instant, observations.joints, [&](std::size_t equation, std::size_t place, const auto& row) {
      if (static_cast<Index>(equation) == i && instant.used[place] != 0) rows.row(t) = row;
    });
  }
  return rows;
}

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

Index joints_of(const std::vector<MatrixXd>& B) { return B.empty() ? 0 : B.front().cols(); }

// The unknowns in one vector: coloured noise by equation and colour, white noise by equation, then noise of
// accelerations by joint.
struct Unknowns {
  Index equations = 0, joints = 0;

  Index all() const { return equations * (kColours + 1) + joints; }
  Index optional() const { return equations * kColours; }  // those before all that are known
  Eigen::VectorBlock<VectorXd> coloured(VectorXd& x, Index equation) const {
    return x.segment(equation * kColours, kColours);
  }
  Eigen::VectorBlock<VectorXd> measured(VectorXd& x) const { return x.segment(optional(), equations); }
  Eigen::VectorBlock<VectorXd> accelerations(VectorXd& x) const { return x.tail(joints); }
};

}  // namespace

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

ResidualNoise residual_noise(const Observations& observations, const VectorXd& values, const VectorXd& freedom,
                             const AccelerationRows& rows) {
  const MatrixXd left = residuals(observations, values);
  const std::vector<MatrixXd> B = inertias(observations, values, rows);
  const auto n = static_cast<Index>(observations.joints.size());
  const Index joints = joints_of(B);
  const Unknowns unknowns{n, joints};
  VectorXd known = VectorXd::Zero(unknowns.all());
  known.tail(n + joints) = known_variances(observations, joints);
  // Residuals that positions do not explain by what they show above the band are misfit of the torques.
  VectorXd most = VectorXd::Constant(unknowns.all(), std::numeric_limits<double>::infinity());
  most.tail(joints) = most_of_accelerations(observations, joints);
  MatrixXd H = MatrixXd::Zero(unknowns.all(), unknowns.all());
  VectorXd h = VectorXd::Zero(unknowns.all()), sizes = known_squares(observations);
  for (Index i = 0; i < n; ++i) {
    const LaggedProduct own = lagged_product(observations, left, B, i, i, 0, joints);
    if (own.count > 0) sizes[i] = std::max(sizes[i], own.product / static_cast<double>(own.count));
  }
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < n; ++k) {
      const double size = std::sqrt(sizes[i] * sizes[k]);
      if (size <= 0) continue;
      const double free = std::sqrt(freedom[i] * freedom[k]);
      for (long lag = 0; lag < (i == k ? kOwnLags : kFittedLags); ++lag) {
        const LaggedProduct mean = lagged_product(observations, left, B, i, k, lag, joints);
        if (mean.count == 0) continue;
        const double scale = std::sqrt(free / static_cast<double>(mean.count)) / size;
        VectorXd row = VectorXd::Zero(unknowns.all());
        unknowns.coloured(row, i) = mean.of_colours;
        unknowns.measured(row)[i] = mean.of_measured;
        unknowns.accelerations(row) = mean.of_accelerations;
        row *= scale;
        H += row * row.transpose();
        h += scale * mean.product / free * row;
      }
    }
  }
  auto [variances, covariance] = without_doubtful(H, h, known, most, unknowns.optional(), joints);
  return {unknowns.measured(variances), Eigen::Map<const MatrixXd>(variances.data(), kColours, n).transpose(),
          unknowns.accelerations(variances), covariance.bottomRightCorner(joints, joints)};
}

MatrixXd score_covariance(const Observations& observations, const VectorXd& values, const VectorXd& weights,
                          const ResidualNoise& noise, const AccelerationRows& acceleration_rows) {
  const MatrixXd left = residuals(observations, values);
  const VectorXd ratios = row_ratios(observations, left);
  const std::vector<MatrixXd> B = inertias(observations, values, acceleration_rows);
  const Index joints = joints_of(B), size = observations.parameters;
  MatrixXd result = MatrixXd::Zero(size, size);
  std::vector<MatrixXd> of_joints(static_cast<std::size_t>(joints), MatrixXd::Zero(left.rows(), size));
  for (Index i = 0; i < weights.size(); ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    const MatrixXd rows = rows_of(observations, i);
    const auto of_torques = [&](const NoiseShape& shape) {
      VectorXd sum = noise.measured[i] * shape.measured;
      for (Index c = 0; c < kColours; ++c) sum += noise.coloured(i, c) * shape.coloured[static_cast<std::size_t>(c)];
      return sum;
    };
    result(joint.columns, joint.columns) +=
        ratios[i] * weights[i] * weights[i] * correlated_sum(observations, rows, of_torques);
    for (Index t = 0; t < rows.rows() && joints > 0; ++t) {
      const EquationInstant& instant = observations.instants[static_cast<std::size_t>(t)];
      const Index place = i - instant.first;
      if (place < 0 || place >= B[static_cast<std::size_t>(t)].rows()) continue;
      for (Index j = 0; j < joints; ++j) {
        const double gain = std::sqrt(ratios[i]) * weights[i] * B[static_cast<std::size_t>(t)](place, j);
        of_joints[static_cast<std::size_t>(j)](t, joint.columns) += gain * rows.row(t);
      }
    }
  }
  for (Index j = 0; j < joints; ++j) {
    result += noise.acceleration[j] *
              correlated_sum(observations, of_joints[static_cast<std::size_t>(j)],
                             [j](const NoiseShape& shape) { return shape.acceleration[static_cast<std::size_t>(j)]; });
  }
  return result;
}

std::vector<MatrixXd> false_information(const Observations& observations, const VectorXd& weights,
                                        const AccelerationRows& rows) {
  std::vector<MatrixXd> result;
  if (!rows) return result;
  const VectorXd ratios = row_ratios(observations, residuals(observations, VectorXd::Zero(observations.parameters)));
  for (const EquationInstant& instant : observations.instants) {
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(instant.log)];
    const std::vector<MatrixXd> of_joints = rows(instant);
    const Index all = of_joints.empty() ? 0 : of_joints.front().cols();
    result.resize(of_joints.size(), MatrixXd::Zero(all, all));
    for (std::size_t i = 0; i < instant.used.size(); ++i) {
      const auto row = static_cast<Index>(i), equation = instant.first + row;
      if (instant.used[i] == 0) continue;
      std::vector<int> columns = observations.joints[static_cast<std::size_t>(equation)].columns;
      if (all > observations.parameters) columns.push_back(observations.parameters);
      const double weight = weights[equation] * ratios[equation];
      for (std::size_t j = 0; j < of_joints.size(); ++j) {
        const VectorXd gains = of_joints[j](row, columns);
        result[j](columns, columns) += shape.acceleration[j][0] * weight * gains * gains.transpose();
      }
    }
  }
  return result;
}

}  // namespace flatdyn
