// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/friction_search.hpp"

#include <ceres/ceres.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "laboratory/identify/identification.hpp"
#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kSpeeds = 12;

// Weights of the columns of a dictionary for a speed between its own, by cubic polynomials in the logarithm.
struct Interpolation {
  VectorXd weights, slopes;  // slopes: by the place
};

// place: 0 … size - 1.
Interpolation interpolation(double place, Index size) {
  Interpolation result{VectorXd::Zero(size), VectorXd::Zero(size)};
  const Index first = std::clamp<Index>(static_cast<Index>(std::floor(place)) - 1, 0, size - 4);
  const double x = place - static_cast<double>(first);
  for (Index k = 0; k < 4; ++k) {
    double value = 1, slope = 0;
    for (Index other = 0; other < 4; ++other) {
      if (other == k) continue;
      const double span = static_cast<double>(k - other);
      slope = slope * (x - static_cast<double>(other)) / span + value / span;
      value *= (x - static_cast<double>(other)) / span;
    }
    result.weights[first + k] = value;
    result.slopes[first + k] = slope;
  }
  return result;
}

// The weighted rows of all instants, folded: |R (x, -1)|² is the sum of the squares of their residuals. The columns of
// dictionaries, `first` up to `end`, come behind all others.
MatrixXd folded_rows(const Observations& observations, const std::vector<JointFit>& fits, int first, int end) {
  const int behind = observations.parameters - end;
  const auto place_of = [=](int column) {
    return column < first ? column : column < end ? column + behind : column - (end - first);
  };
  TriangularFactor factor(observations.parameters);
  for (const EquationInstant& instant : observations.instants) {
    const double* entries = instant.entries.data();
    for (std::size_t i = 0; i < instant.used.size(); ++i) {
      const std::vector<int>& columns = observations.joints[i].columns;
      if (instant.used[i] != 0 && fits[i].expected > 0) {
        auto row = factor.next_row();
        row.setZero();
        for (std::size_t k = 0; k < columns.size(); ++k) row[place_of(columns[k])] = entries[k] / fits[i].expected;
        row[observations.parameters] = instant.right[i] / fits[i].expected;
      }
      entries += columns.size();
    }
  }
  return factor.factor();
}

// Where the columns of one joint's dictionary are.
struct Dictionary {
  int joint = 0;
  Index first = 0;
  std::vector<double> speeds;

  double speed_at(double place) const {
    const double part = place / static_cast<double>(speeds.size() - 1);
    return speeds.front() * std::pow(speeds.back() / speeds.front(), part);
  }
};

// Residuals R (x, -1), where x has π and each joint's amplitude times its interpolated columns.
class FrictionCost : public ceres::CostFunction {
 public:
  FrictionCost(MatrixXd R, const std::vector<Dictionary>& dictionaries, Index linear)
      : R_(std::move(R)), dictionaries_(dictionaries), linear_(linear) {
    set_num_residuals(static_cast<int>(R_.rows()));
    for (const Index size : {linear_, joints(), joints()})
      mutable_parameter_block_sizes()->push_back(static_cast<int>(size));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    using RowByRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<VectorXd> r(residuals, R_.rows());
    r = R_.leftCols(linear_) * Eigen::Map<const VectorXd>(parameters[0], linear_) - R_.rightCols<1>();
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<RowByRow>(jacobians[0], R_.rows(), linear_) = R_.leftCols(linear_);
    }
    for (Index j = 0; j < joints(); ++j) {
      const Dictionary& each = dictionaries_[static_cast<std::size_t>(j)];
      const auto size = static_cast<Index>(each.speeds.size());
      const auto [weights, slopes] = interpolation(parameters[2][j], size);
      const auto columns = R_.middleCols(each.first, size);
      const VectorXd by_amplitude = columns * weights;
      r += parameters[1][j] * by_amplitude;
      if (jacobians == nullptr) continue;
      if (jacobians[1] != nullptr) Eigen::Map<RowByRow>(jacobians[1], R_.rows(), joints()).col(j) = by_amplitude;
      if (jacobians[2] != nullptr) {
        Eigen::Map<RowByRow>(jacobians[2], R_.rows(), joints()).col(j) = parameters[1][j] * (columns * slopes);
      }
    }
    return true;
  }

 private:
  Index joints() const { return static_cast<Index>(dictionaries_.size()); }

  MatrixXd R_;
  const std::vector<Dictionary>& dictionaries_;
  Index linear_;
};

// first: the column of the first dictionary.
std::vector<Dictionary> dictionaries_of(const TorqueEquations& equations, Index first) {
  std::vector<Dictionary> result;
  for (int j = 0; j < equations.equations(); ++j) {
    const auto more =
        static_cast<Index>(std::count_if(equations.columns()[static_cast<std::size_t>(j)].begin(),
                                         equations.columns()[static_cast<std::size_t>(j)].end(),
                                         [&](int column) { return column >= equations.model().parameters(); }));
    if (more >= kSpeeds) result.push_back({j, first, equations.further().dictionary[static_cast<std::size_t>(j)]});
    first += std::min<Index>(more, kSpeeds);
  }
  return result;
}

// The places with least cost if all joints have the same, with the amplitudes and the linear parameters found there.
void start(const MatrixXd& R, const std::vector<Dictionary>& dictionaries, VectorXd& pi, VectorXd& amplitudes,
           VectorXd& places) {
  double least = HUGE_VAL;
  const Index linear = pi.size(), joints = amplitudes.size();
  for (Index place = 0; place < kSpeeds; ++place) {
    MatrixXd A(R.rows(), linear + joints);
    A.leftCols(linear) = R.leftCols(linear);
    for (Index j = 0; j < joints; ++j) {
      A.col(linear + j) = R.col(dictionaries[static_cast<std::size_t>(j)].first + place);
    }
    const VectorXd x = A.completeOrthogonalDecomposition().solve(R.rightCols<1>());
    const double cost = (A * x - R.rightCols<1>()).squaredNorm();
    if (cost >= least) continue;
    least = cost;
    pi = x.head(linear);
    amplitudes = x.tail(joints);
    places.setConstant(static_cast<double>(place));
  }
}

// The columns of a joint's friction in R: F_v, F_s, which may be missing, and then the law's term.
std::vector<Index> friction_columns(const TorqueEquations& equations, int joint) {
  std::vector<Index> columns;
  const std::vector<int>& parameters = equations.model().base().columns;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Parameter kind = parameter_of(parameters[k]);
    const bool is_friction = kind == Parameter::Fv || kind == Parameter::Fs;
    if (is_friction && joint_of(parameters[k]) == joint) columns.push_back(static_cast<Index>(k));
  }
  return columns;
}

// The parameters of a joint's friction, F_v, F_s and the term's, and the cost, where its speed is one of the
// dictionary's and all others are those that were found.
struct FrictionAt {
  VectorXd values, deviations;
  double cost = 0;
};

// columns: of all others, with their speeds; the joint's term comes behind them.
FrictionAt friction_at(const MatrixXd& others, const VectorXd& term, const VectorXd& right,
                       const std::vector<Index>& friction) {
  MatrixXd A(others.rows(), others.cols() + 1);
  A << others, term;
  const VectorXd lengths = A.colwise().norm().cwiseMax(1e-150);
  const auto decomposition = (A * lengths.cwiseInverse().asDiagonal()).eval().completeOrthogonalDecomposition();
  const VectorXd x = decomposition.solve(right);
  const MatrixXd inverse = decomposition.pseudoInverse();
  FrictionAt result{VectorXd(friction.size() + 1), VectorXd(friction.size() + 1)};
  for (Index k = 0; k < result.values.size(); ++k) {
    const bool is_term = k == static_cast<Index>(friction.size());
    const Index column = is_term ? others.cols() : friction[static_cast<std::size_t>(k)];
    result.values[k] = x[column] / lengths[column];
    result.deviations[k] = inverse.row(column).norm() / lengths[column];
  }
  result.cost = (A * lengths.cwiseInverse().asDiagonal() * x - right).squaredNorm();
  return result;
}

// Friction of the joint of dictionary j at its own place, then at all places of the dictionary.
std::vector<FrictionAt> frictions_by_speed(const MatrixXd& R, Index linear, const std::vector<Dictionary>& dictionaries,
                                           const VectorXd& places, std::size_t j, const std::vector<Index>& friction) {
  const auto term_of = [&](std::size_t of, double place) -> VectorXd {
    return R.middleCols(dictionaries[of].first, kSpeeds) * interpolation(place, kSpeeds).weights;
  };
  MatrixXd others = MatrixXd::Zero(R.rows(), linear + places.size());
  others.leftCols(linear) = R.leftCols(linear);
  for (std::size_t other = 0; other < dictionaries.size(); ++other) {
    const auto at = static_cast<Index>(other);
    if (other != j) others.col(linear + at) = term_of(other, places[at]);
  }
  std::vector<FrictionAt> result{
      friction_at(others, term_of(j, places[static_cast<Index>(j)]), R.rightCols<1>(), friction)};
  for (Index place = 0; place < kSpeeds; ++place) {
    result.push_back(friction_at(others, term_of(j, static_cast<double>(place)), R.rightCols<1>(), friction));
  }
  return result;
}

// The number of equations that are used at the instants.
double kept_rows(const Measurement& measurement) {
  double rows = 0;
  for (const EquationInstant& instant : measurement.observations.instants) {
    rows += static_cast<double>(std::count_if(instant.used.begin(), instant.used.end(), [](auto u) { return u != 0; }));
  }
  return std::max(rows, 1.0);
}

// Whether all speeds that fit about as well as the best are alike, or give the same friction. A negative term is no
// friction: it stands for something that the model lacks. The first place is the
// one that was found. noise: the cost of one row.
bool tell_the_same(const std::vector<FrictionAt>& places, double noise) {
  constexpr double kAlike = 9, kClearly = 25, kFar = 2;  // of the cost, twice; standard deviations
  constexpr int kNeighbours = 2;                         // places: speeds that differ by a factor of about 2
  const auto best = std::min_element(places.begin(), places.end(),
                                     [](const FrictionAt& a, const FrictionAt& b) { return a.cost < b.cost; });
  const auto fits = [&](const FrictionAt& each) { return each.cost < best->cost + kAlike * noise; };
  if (places.back().cost < best->cost + kClearly * noise || best->values.tail<1>()[0] < 0) return false;
  if (std::count_if(places.begin() + 1, places.end(), fits) <= kNeighbours) return true;
  return std::all_of(places.begin(), places.end(), [&](const FrictionAt& each) {
    if (!fits(each)) return true;
    const VectorXd change = (each.values - best->values).cwiseAbs();
    return (change.array() <= kFar * std::sqrt(noise) * (each.deviations + best->deviations).array()).all();
  });
}

}  // namespace

std::vector<std::vector<double>> friction_dictionary(const TorqueEquations& equations, const Measurement& measurement) {
  constexpr double kSlowest = 2, kLeast = 1e-3, kFastest = 0.7;  // of the rest speed; of the largest speed
  const std::vector<double> rest = measurement.rest_speeds();
  std::vector<std::vector<double>> dictionary;
  for (std::size_t j = 0; j < static_cast<std::size_t>(equations.equations()); ++j) {
    double largest = 0;
    for (const EquationInstant& instant : measurement.observations.instants) {
      largest = std::max(largest, std::abs(instant.qd[j]));
    }
    const double last = std::max(kFastest * largest, 1e-6),
                 first = std::min(std::max(kSlowest * rest[j], kLeast * largest), last / 2);
    dictionary.emplace_back();
    for (int k = 0; k < kSpeeds; ++k) {
      dictionary.back().push_back(first * std::pow(last / first, static_cast<double>(k) / (kSpeeds - 1)));
    }
  }
  return dictionary;
}

FrictionSpeeds friction_speeds(const TorqueEquations& equations, const Measurement& measurement) {
  const int parameters = equations.model().parameters(), offsets = equations.static_parameters();
  const Index linear = parameters + offsets;
  const std::vector<Dictionary> dictionaries = dictionaries_of(equations, linear);
  const auto joints = static_cast<std::size_t>(equations.equations());
  FrictionSpeeds found{std::vector<double>(joints, 1), std::vector<bool>(joints, true)};
  if (dictionaries.empty()) return found;
  const VectorXd values = estimate_of(equations, measurement, {}).values;
  MatrixXd R =
      folded_rows(measurement.observations,
                  fit_quality(measurement.observations, measurement.logs, values, equations.acceleration_rows()),
                  parameters, equations.parameters() - offsets);
  if (equations.further().law == FrictionLaw::smooth) {
    for (Index k = 0; k < parameters; ++k) {
      const int index = equations.model().base().columns[static_cast<std::size_t>(k)];
      if (parameter_of(index) == Parameter::Fs) R.col(k).setZero();
    }
  }
  VectorXd pi(linear), amplitudes(dictionaries.size()), places(dictionaries.size());
  start(R, dictionaries, pi, amplitudes, places);
  ceres::Problem problem;
  problem.AddResidualBlock(new FrictionCost(R, dictionaries, linear), nullptr, pi.data(), amplitudes.data(),
                           places.data());
  for (int j = 0; j < static_cast<int>(places.size()); ++j) {
    problem.SetParameterLowerBound(places.data(), j, 0);
    problem.SetParameterUpperBound(places.data(), j, kSpeeds - 1);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const double noise = std::max(1.0, 2 * summary.final_cost / kept_rows(measurement));
  for (std::size_t j = 0; j < dictionaries.size(); ++j) {
    const auto joint = static_cast<std::size_t>(dictionaries[j].joint);
    found.speeds[joint] = dictionaries[j].speed_at(places[static_cast<Index>(j)]);
    found.are_told[joint] = tell_the_same(
        frictions_by_speed(R, linear, dictionaries, places, j, friction_columns(equations, dictionaries[j].joint)),
        noise);
  }
  return found;
}

}  // namespace flatdyn
