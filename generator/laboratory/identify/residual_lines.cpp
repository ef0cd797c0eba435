// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/residual_lines.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double kFullTurn = 2 * std::numbers::pi;

// A residual, where it is in the cycle that is looked at, how fast that goes, and between which frequencies lines show.
struct Reading {
  double residual, place, speed, lowest, highest;  // Hz
};

// The best of the lines with rates from `from` to `to`, in steps.
std::optional<ResidualLine> best_line(const std::vector<Reading>& readings, double from, double to, double step) {
  constexpr double kLeastShare = 0.2, kChance = 40;
  constexpr double kLeastReadings = 100;
  std::vector<Complex> turned, by_step;
  for (const Reading& each : readings) {
    turned.push_back(std::polar(each.residual, kFullTurn * from * each.place));
    by_step.push_back(std::polar(1.0, kFullTurn * step * each.place));
  }
  std::optional<ResidualLine> best;
  for (double rate = from; rate <= to; rate += step) {
    Complex sum = 0;
    double squares = 0, count = 0;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const Reading& each = readings[k];
      if (rate * each.speed >= each.lowest && rate * each.speed < each.highest) {
        sum += turned[k];
        squares += each.residual * each.residual;
        ++count;
      }
      turned[k] *= by_step[k];
    }
    if (count < kLeastReadings || squares == 0) continue;
    const double share = 2 * std::norm(sum) / (count * squares);
    if (share < std::max(kLeastShare, kChance / count) || (best && share < best->share)) continue;
    best = ResidualLine{false, rate, 2 * std::abs(sum) / count, share};
  }
  return best;
}

// The log with most instants.
int longest_log(const Observations& observations) {
  std::map<int, long> counts;
  for (const EquationInstant& each : observations.instants) ++counts[each.log];
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? 0 : most->first;
}

// By instant: whether it is in the second half of its log.
std::vector<bool> second_halves(const std::vector<EquationInstant>& instants) {
  std::map<int, std::pair<double, double>> times;  // by log: its first and last one
  for (const EquationInstant& each : instants) {
    const auto [at, is_new] = times.try_emplace(each.log, each.time, each.time);
    if (!is_new) at->second.second = each.time;
  }
  std::vector<bool> result;
  for (const EquationInstant& each : instants) {
    const auto& [first, last] = times[each.log];
    result.push_back(each.time > (first + last) / 2);
  }
  return result;
}

}  // namespace

std::optional<ResidualLine> residual_line(const Observations& observations, const VectorXd& residual, Index position,
                                          bool slides, const std::vector<double>& bands) {
  constexpr double kFewestTurns = 8, kMostTurns = 400, kStepOfTurns = 0.1;
  constexpr double kInBand = 0.7;                 // share of the filter's band
  constexpr double kLowest = 0.15, kSlowest = 2;  // Hz by the band, and Hz: slower lines may follow the motion
  constexpr double kLongest = 300;                // s that are looked at
  std::vector<Reading> by_turns, by_time;
  const int longest = longest_log(observations);
  double span = 0, band = 0, start = 0;
  for (Index t = 0; t < residual.size(); ++t) {
    const EquationInstant& instant = observations.instants[static_cast<std::size_t>(t)];
    const auto at = static_cast<std::size_t>(position);
    if (std::isnan(residual[t])) continue;
    const double unit = slides ? 1 : kFullTurn, own = bands[static_cast<std::size_t>(instant.log)];
    by_turns.push_back({residual[t], instant.q[at] / unit, std::abs(instant.qd[at]) / unit, 0, kInBand * own});
    if (instant.log != longest) continue;
    if (by_time.empty()) start = instant.time;
    if (instant.time - start > kLongest) continue;
    by_time.push_back({residual[t], instant.time - start, 1, 0, kInBand * own});
    span = instant.time - start;
    band = own;
  }
  if (band <= 0 || span <= 0) return std::nullopt;
  std::optional<ResidualLine> of_turns = best_line(by_turns, kFewestTurns, kMostTurns, kStepOfTurns);
  const std::optional<ResidualLine> of_time =
      best_line(by_time, std::max(kLowest * band, kSlowest), band, 1 / (4 * span));
  if (of_turns) of_turns->is_of_turns = true;
  if (!of_turns || (of_time && of_time->share > of_turns->share)) return of_time;
  return of_turns;
}

std::optional<ResidualLine> fast_ripple(const Observations& observations, Index equation, Index position, bool slides,
                                        const std::vector<double>& bands, const std::vector<double>& sampled) {
  constexpr double kFewestTurns = 8, kMostTurns = 1500, kStepOfRange = 0.25;
  constexpr double kBehindBand = 1.6, kBelowSampling = 0.45;  // of the band; of the samples a second
  const auto at = static_cast<std::size_t>(position), row = static_cast<std::size_t>(equation);
  const double unit = slides ? 1 : kFullTurn;
  std::vector<Reading> readings;
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const EquationInstant& instant : observations.instants) {
    if (instant.fast.empty()) continue;
    const auto log = static_cast<std::size_t>(instant.log);
    const double place = instant.q[at] / unit;
    readings.push_back({instant.fast[row], place, std::abs(instant.qd[row]) / unit, kBehindBand * bands[log],
                        kBelowSampling * sampled[log]});
    least = std::min(least, place);
    largest = std::max(largest, place);
  }
  if (!(largest > least)) return std::nullopt;
  std::optional<ResidualLine> line =
      best_line(readings, kFewestTurns, kMostTurns, std::min(1.0, kStepOfRange / (largest - least)));
  if (line) line->is_of_turns = true;
  return line;
}

std::optional<FrictionChange> friction_change(const Observations& observations, const VectorXd& residual, Index rate,
                                              double viscous, double coulomb, double least, double correlation) {
  constexpr double kLeastShare = 0.05, kClearly = 40;  // of the friction; of the fit's squares
  constexpr double kCosine = 0.8;                      // cosine between the change and the friction
  const std::vector<bool> is_later = second_halves(observations.instants);
  Eigen::Matrix2d halves[2] = {Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero()};
  Eigen::Vector2d right[2] = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double squares = 0, used = 0, friction = 0;
  for (Index t = 0; t < residual.size(); ++t) {
    if (std::isnan(residual[t])) continue;
    const double qd = observations.instants[static_cast<std::size_t>(t)].qd[static_cast<std::size_t>(rate)];
    const Eigen::Vector2d row(qd, qd < 0 ? -1 : 1);
    const int half = is_later[static_cast<std::size_t>(t)] ? 1 : 0;
    halves[half] += row * row.transpose();
    right[half] += row * residual[t];
    squares += residual[t] * residual[t];
    friction += std::pow(viscous * row[0] + coulomb * row[1], 2);
    ++used;
  }
  if (used == 0 || squares == 0 || friction <= least * least * used) return std::nullopt;
  for (const Eigen::Matrix2d& each : halves) {
    if (!(each.determinant() > 1e-6 * each(0, 0) * each(1, 1))) return std::nullopt;
  }
  const Eigen::Matrix2d covariance = correlation * squares / used * (halves[0].inverse() + halves[1].inverse());
  const Eigen::Vector2d change = halves[1].inverse() * right[1] - halves[0].inverse() * right[0];
  const Eigen::Matrix2d all = halves[0] + halves[1];
  const double size = std::sqrt(change.dot(all * change) / friction);
  if (size < kLeastShare || change.dot(covariance.inverse() * change) < kClearly) return std::nullopt;
  const double direction = change.dot(all * Eigen::Vector2d(viscous, coulomb));
  if (size > 1 || std::abs(direction) < kCosine * size * friction) return std::nullopt;
  return FrictionChange{change[0], change[1], direction < 0 ? -size : size};
}

}  // namespace flatdyn
