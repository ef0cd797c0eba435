// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/friction_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "laboratory/identify/hypothesis.hpp"
#include "laboratory/identify/identification.hpp"
#include "laboratory/identify/row_sample.hpp"
#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kSpeeds = 12;

// Weights of the columns of a dictionary for a place between theirs, 0 … size - 1, by cubic polynomials: the speeds'
// logarithms are evenly spaced.
VectorXd interpolation(double place, Index size) {
  VectorXd weights = VectorXd::Zero(size);
  const Index first = std::clamp<Index>(static_cast<Index>(std::floor(place)) - 1, 0, size - 4);
  for (Index k = first; k < first + 4; ++k) {
    weights[k] = 1;
    for (Index other = first; other < first + 4; ++other) {
      if (other != k) weights[k] *= (place - static_cast<double>(other)) / static_cast<double>(k - other);
    }
  }
  return weights;
}

// The columns of one joint's dictionary.
struct Dictionary {
  int joint = 0;
  std::vector<int> columns;
  std::vector<double> speeds;

  double speed_at(double place) const {
    const double part = place / static_cast<double>(speeds.size() - 1);
    return speeds.front() * std::pow(speeds.back() / speeds.front(), part);
  }
};

std::vector<Dictionary> dictionaries_of(const TorqueEquations& equations) {
  std::vector<Dictionary> result;
  const int behind = equations.parameters() - equations.static_parameters();
  for (int j = 0; j < equations.equations(); ++j) {
    const auto joint = static_cast<std::size_t>(j);
    Dictionary next{j, {}, equations.further().dictionary[joint]};
    for (const int column : equations.columns()[joint]) {
      if (column >= equations.first_of_law() && column < behind) next.columns.push_back(column);
    }
    if (!next.columns.empty()) result.push_back(std::move(next));
  }
  return result;
}

// Each joint's speed at an unknown place of its dictionary. The law's terms come behind the other columns, in the order
// of the dictionaries; F_s is left out where the law's term is in its place.
Hypothesis speeds_hypothesis(const TorqueEquations& equations, const WeightedEquations& rows,
                             const std::vector<Dictionary>& dictionaries) {
  std::vector<int> others(static_cast<std::size_t>(equations.parameters()));
  std::iota(others.begin(), others.end(), 0);
  for (const Dictionary& each : dictionaries) {
    std::erase_if(others, [&](int k) { return std::ranges::count(each.columns, k) > 0; });
  }
  MatrixXd linear = rows.A(Eigen::all, others);
  for (int k = 0; k < equations.model().parameters() && equations.further().law == FrictionLaw::smooth; ++k) {
    const int index = equations.model().base().columns[static_cast<std::size_t>(k)];
    if (parameter_of(index) == Parameter::Fs) linear.col(k).setZero();
  }
  const auto joints = static_cast<Index>(dictionaries.size());
  Hypothesis result{std::vector<Unknown>(dictionaries.size(), Unknown{.low = 0, .high = kSpeeds - 1}),
                    [=](const VectorXd& places) {
                      MatrixXd A(linear.rows(), linear.cols() + joints);
                      A.leftCols(linear.cols()) = linear;
                      for (Index j = 0; j < joints; ++j) {
                        A.col(linear.cols() + j) =
                            rows.A(Eigen::all, dictionaries[static_cast<std::size_t>(j)].columns) *
                            interpolation(places[j], kSpeeds);
                      }
                      return WeightedEquations{std::move(A), rows.b};
                    },
                    {}};
  for (int place = 0; place < kSpeeds; ++place) result.starts.push_back(VectorXd::Constant(joints, place));
  return result;
}

// The places in π of a joint's friction: F_v, F_s, which may be missing, and then the law's term.
std::vector<int> friction_places(const TorqueEquations& equations, int joint, int term) {
  std::vector<int> places;
  const std::vector<int>& parameters = equations.model().base().columns;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Parameter kind = parameter_of(parameters[k]);
    const bool is_friction = kind == Parameter::Fv || kind == Parameter::Fs;
    if (is_friction && joint_of(parameters[k]) == joint) places.push_back(static_cast<int>(k));
  }
  places.push_back(term);
  return places;
}

// The same squares in fewer rows.
WeightedEquations in_fewer_rows(const WeightedEquations& rows) {
  MatrixXd joined(rows.A.rows(), rows.A.cols() + 1);
  joined << rows.A, rows.b;
  const MatrixXd R = triangular_factor_of(joined);
  return {R.leftCols(rows.A.cols()), R.rightCols<1>()};
}

// Whether all speeds that fit about as well as the best are alike, or give the same friction. A negative term is no
// friction: it stands for something that the model lacks. fits: where the speed is the one that was found, then at all
// places of the dictionary. friction: the places of F_v, F_s and the term in π. noise: the cost of one row.
bool tell_the_same(const std::vector<HypothesisFit>& fits, const std::vector<int>& friction, double noise) {
  constexpr double kAlike = 9, kClearly = 25, kFar = 2;  // of the cost, twice; standard deviations
  constexpr int kNeighbours = 2;                         // places: speeds that differ by a factor of about 2
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const HypothesisFit& a, const HypothesisFit& b) { return a.cost < b.cost; });
  const auto is_good = [&](const HypothesisFit& each) { return each.cost < best->cost + kAlike * noise; };
  if (fits.back().cost < best->cost + kClearly * noise || best->pi[friction.back()] < 0) return false;
  if (std::count_if(fits.begin() + 1, fits.end(), is_good) <= kNeighbours) return true;
  return std::all_of(fits.begin(), fits.end(), [&](const HypothesisFit& each) {
    if (!is_good(each)) return true;
    const VectorXd change = (each.pi - best->pi)(friction).cwiseAbs(),
                   deviations = (each.deviations + best->deviations)(friction);
    return (change.array() <= kFar * std::sqrt(noise) * deviations.array()).all();
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
  const std::vector<Dictionary> dictionaries = dictionaries_of(equations);
  const auto joints = static_cast<std::size_t>(equations.equations());
  FrictionSpeeds found{std::vector<double>(joints, 1), std::vector<bool>(joints, true)};
  if (dictionaries.empty()) return found;
  const RowSample sample = sample_of(equations, measurement, InstantSample::kMost);
  const Hypothesis hypothesis = speeds_hypothesis(equations, in_fewer_rows(sample.rows()), dictionaries);
  const HypothesisFit fit = best_fit(hypothesis);
  const double noise = std::max(1.0, fit.cost / std::max(sample.count(), 1.0));
  for (Index j = 0; j < fit.x.size(); ++j) {
    const Dictionary& own = dictionaries[static_cast<std::size_t>(j)];
    const auto joint = static_cast<std::size_t>(own.joint);
    std::vector<HypothesisFit> fits{fit};
    for (VectorXd places = fit.x; const VectorXd& start : hypothesis.starts) {
      places[j] = start[j];
      fits.push_back(fit_at(hypothesis, places));
    }
    const auto term = static_cast<int>(fit.pi.size() - fit.x.size() + j);
    found.speeds[joint] = own.speed_at(fit.x[j]);
    found.are_told[joint] = tell_the_same(fits, friction_places(equations, own.joint, term), noise);
  }
  return found;
}

}  // namespace flatdyn
