// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/noise_structure.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::vector<NoiseKind> kinds_of(const std::vector<NoiseShape>& shapes, bool has_repetition) {
  std::vector<NoiseKind> kinds(1 + NoiseShape::kColours.size());
  for (const NoiseShape& shape : shapes) {
    kinds[0].by_log.push_back(shape.measured);
    for (std::size_t c = 0; c < NoiseShape::kColours.size(); ++c) kinds[c + 1].by_log.push_back(shape.coloured[c]);
  }
  for (std::size_t k = 0; k < 1 + NoiseShape::kColours.size() && has_repetition; ++k) {
    kinds.push_back({kinds[k].by_log, true});
  }
  return kinds;
}

VectorXd ratios_of(const Observations& observations) {
  VectorXd result = VectorXd::Zero(static_cast<Index>(observations.joints.size())), kept = result;
  for (const EquationInstant& instant : observations.instants) {
    for (std::size_t i = 0; i < instant.used.size(); ++i) {
      if (instant.used[i] != 0) kept[instant.first + static_cast<Index>(i)] += 1;
    }
  }
  for (Index i = 0; i < kept.size(); ++i) {
    const auto rows = static_cast<double>(observations.joints[static_cast<std::size_t>(i)].rows);
    if (kept[i] > 0) result[i] = rows / kept[i];
  }
  return result;
}

}  // namespace

NoiseStructure::NoiseStructure(const Observations& observations)
    : observations_(observations),
      repetition_(repetition_of(observations)),
      kinds_(kinds_of(observations.shapes, repetition_.any())),
      row_ratios_(ratios_of(observations)) {
  if (!repetition_.any()) return;
  phase_of_.resize(observations.instants.size());
  for (std::size_t motion = 0; motion < repetition_.motions.size(); ++motion) add_phases(motion);
}

void NoiseStructure::add_phases(std::size_t motion) {
  const RepeatedMotion& repeated = repetition_.motions[motion];
  std::map<long, std::vector<std::size_t>> instants;  // by phase, to a row
  const long period = std::lround(repeated.period);
  for (std::size_t t = 0; t < observations_.instants.size(); ++t) {
    const long phase = std::lround(repetition_.phase_of[t]);
    if (repetition_.motion_of[t] == motion) instants[repeated.begins_anew ? phase % period : phase].push_back(t);
  }
  const long first = repeated.begins_anew ? 0 : instants.begin()->first;
  const long all = repeated.begins_anew ? period : instants.rbegin()->first - first + 1;
  first_phase_.push_back(phases_.size());
  phase_count_.push_back(static_cast<std::size_t>(all));
  phases_.resize(phases_.size() + static_cast<std::size_t>(all), {motion});
  for (auto& [phase, own] : instants) {
    const std::size_t at = first_phase_.back() + static_cast<std::size_t>(phase - first);
    for (const std::size_t t : own) phase_of_[t] = at;
    phases_[at] = {motion, observations_.instants[own.back()].log, std::move(own), occupied_++};
  }
}

bool NoiseStructure::uses(Index instant, Index equation) const {
  const EquationInstant& at = observations_.instants[static_cast<std::size_t>(instant)];
  const Index place = equation - at.first;
  return place >= 0 && place < static_cast<Index>(at.used.size()) && at.used[static_cast<std::size_t>(place)] != 0;
}

std::optional<std::size_t> NoiseStructure::phase_behind(std::size_t phase, long lag) const {
  const std::size_t motion = phases_[phase].motion;
  const long first = static_cast<long>(first_phase_[motion]), count = static_cast<long>(phase_count_[motion]);
  long at = static_cast<long>(phase) - first + lag;
  if (repetition_.motions[motion].begins_anew) at = (at % count + count) % count;
  if (at < 0 || at >= count) return std::nullopt;
  return static_cast<std::size_t>(first + at);
}

MatrixXd NoiseStructure::rows_of(Index equation) const {
  const JointObservations& joint = observations_.joints[static_cast<std::size_t>(equation)];
  const auto count = static_cast<Index>(joint.columns.size());
  MatrixXd rows = MatrixXd::Zero(static_cast<Index>(observations_.instants.size()), count);
  for (Index t = 0; t < rows.rows(); ++t) {
    const EquationInstant& instant = observations_.instants[static_cast<std::size_t>(t)];
    for_equations(instant, observations_.joints, [&](std::size_t each, std::size_t place, const auto& row) {
      if (static_cast<Index>(each) == equation && instant.used[place] != 0) rows.row(t) = row;
    });
  }
  return rows;
}

MatrixXd NoiseStructure::correlated(const MatrixXd& rows, Index equation, const NoiseKind& kind) const {
  return kind.is_repeated ? repeated(rows, equation, kind.by_log) : correlated(rows, kind.by_log);
}

MatrixXd NoiseStructure::correlated(const MatrixXd& rows, const std::vector<VectorXd>& by_log) const {
  if (rows.size() == 0) return rows;
  MatrixXd result = MatrixXd::Zero(rows.rows(), rows.cols());
  const std::vector<EquationInstant>& instants = observations_.instants;
  for (std::size_t t = 0; t < instants.size(); ++t) {
    const VectorXd& correlation = by_log[static_cast<std::size_t>(instants[t].log)];
    const auto at = static_cast<Index>(t);
    result.row(at) += correlation[0] * rows.row(at);
    for (std::size_t later = t + 1; later < instants.size(); ++later) {
      const long lag = instants[later].index - instants[t].index;
      if (instants[later].log != instants[t].log || lag >= correlation.size()) break;
      result.row(at) += correlation[lag] * rows.row(static_cast<Index>(later));
      result.row(static_cast<Index>(later)) += correlation[lag] * rows.row(at);
    }
  }
  return result;
}

// All rows of a phase have the same noise. Where not all instants are kept, the mean stands for those of its phase that
// are not.
MatrixXd NoiseStructure::repeated(const MatrixXd& rows, Index equation, const std::vector<VectorXd>& by_log) const {
  if (rows.size() == 0) return rows;
  MatrixXd sums = MatrixXd::Zero(occupied_, rows.cols());
  for (std::size_t phase = 0; phase < phases_.size(); ++phase) {
    if (phases_[phase].instants.empty()) continue;
    auto sum = sums.row(phases_[phase].row);
    double count = 0;
    for (const std::size_t t : phases_[phase].instants) {
      if (!uses(static_cast<Index>(t), equation)) continue;
      sum += rows.row(static_cast<Index>(t));
      ++count;
    }
    const double logged = std::ceil(repetition_.motions[phases_[phase].motion].count);
    if (count > 0) sum *= std::min(row_ratios_[equation], std::max(1.0, logged / count));
  }
  MatrixXd result = MatrixXd::Zero(rows.rows(), rows.cols());
  for (std::size_t t = 0; t < observations_.instants.size(); ++t) {
    if (!uses(static_cast<Index>(t), equation)) continue;
    const VectorXd& correlation = by_log[static_cast<std::size_t>(phases_[phase_of_[t]].log)];
    for (long lag = 1 - correlation.size(); lag < correlation.size(); ++lag) {
      const std::optional<std::size_t> other = phase_behind(phase_of_[t], lag);
      if (!other || phases_[*other].instants.empty()) continue;
      result.row(static_cast<Index>(t)) += correlation[std::abs(lag)] * sums.row(phases_[*other].row);
    }
  }
  return result;
}

void NoiseStructure::for_pairs(long lag, const Visit& visit) const {
  const std::vector<EquationInstant>& instants = observations_.instants;
  for (std::size_t t = 0; t + static_cast<std::size_t>(lag) < instants.size(); ++t) {
    const std::size_t later = t + static_cast<std::size_t>(lag);
    const bool follows = instants[t].log == instants[later].log && instants[later].index - instants[t].index == lag;
    if (follows) visit(static_cast<Index>(t), static_cast<Index>(later));
  }
}

void NoiseStructure::for_repeated_pairs(long lag, const Visit& visit) const {
  constexpr std::size_t kPartners = 2;
  constexpr long kFar = 32;  // rows; nearer ones are those that follow in a row
  const auto is_far = [&](std::size_t a, std::size_t b) {
    const EquationInstant &one = observations_.instants[a], &other = observations_.instants[b];
    return one.log != other.log || std::abs(one.index - other.index) > kFar;
  };
  for (std::size_t phase = 0; phase < phases_.size(); ++phase) {
    const std::optional<std::size_t> other = phase_behind(phase, lag);
    if (!other) continue;
    const std::vector<std::size_t>&own = phases_[phase].instants, &behind = phases_[*other].instants;
    for (std::size_t k = 0; k < own.size(); ++k) {
      for (std::size_t l = k + 1; l < std::min(behind.size(), k + 1 + kPartners); ++l) {
        if (is_far(own[k], behind[l])) visit(static_cast<Index>(own[k]), static_cast<Index>(behind[l]));
      }
    }
  }
}

}  // namespace flatdyn
