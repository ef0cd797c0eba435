// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/repetition.hpp"

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

constexpr double kAlike = 0.01, kUnlike = 0.25;  // mean squares of differences, divided by those of other motions
constexpr double kSameInterval = 1e-3;           // relative difference of the intervals of rows

// The instants of a log.
struct LoggedMotion {
  int log = 0;
  long first = 0;                          // the first one's index
  std::vector<const EquationInstant*> at;  // from index `first` on; nullptr where the instant is not kept
  std::vector<long> kept;                  // where it is: index - first

  long rows() const { return static_cast<long>(at.size()); }
  // Seconds from a row to the next one.
  double interval() const { return (at.back()->time - at.front()->time) / static_cast<double>(rows() - 1); }
};

std::vector<LoggedMotion> logged_motions(const Observations& observations) {
  std::vector<LoggedMotion> result;
  for (const EquationInstant& each : observations.instants) {
    if (result.empty() || result.back().log != each.log) result.push_back({each.log, each.index, {}, {}});
    LoggedMotion& motion = result.back();
    motion.at.resize(static_cast<std::size_t>(each.index - motion.first) + 1, nullptr);
    motion.at.back() = &each;
    motion.kept.push_back(each.index - motion.first);
  }
  return result;
}

// How positions and rates vary: the sum of all entries' variances.
struct Variation {
  double q = 0, qd = 0;
};

double variance_of(const std::vector<EquationInstant>& instants, std::vector<double> EquationInstant::*entries) {
  double result = 0;
  for (std::size_t k = 0; k < (instants.front().*entries).size(); ++k) {
    double sum = 0, squares = 0;
    for (const EquationInstant& each : instants) {
      sum += (each.*entries)[k];
      squares += std::pow((each.*entries)[k], 2);
    }
    const auto count = static_cast<double>(instants.size());
    result += squares / count - std::pow(sum / count, 2);
  }
  return result;
}

double squared_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::pow(a[k] - b[k], 2);
  return sum;
}

// Compares motions, one of them `lag` rows later.
class Comparison {
 public:
  explicit Comparison(const Observations& observations)
      : variation_{variance_of(observations.instants, &EquationInstant::q),
                   variance_of(observations.instants, &EquationInstant::qd)} {}

  // The mean square of the differences, 1 for motions that have nothing in common; infinite where too few instants of
  // both are there.
  double difference(const LoggedMotion& a, const LoggedMotion& b, long lag) const {
    constexpr double kLeast = 32, kShare = 0.1;
    double count = 0, sum = 0;
    for (const long k : a.kept) {
      if (k + lag < 0 || k + lag >= b.rows()) continue;
      const EquationInstant& one = *a.at[static_cast<std::size_t>(k)];
      const EquationInstant* other = b.at[static_cast<std::size_t>(k + lag)];
      if (other == nullptr) continue;
      sum += squared_distance(one.q, other->q) / variation_.q + squared_distance(one.qd, other->qd) / variation_.qd;
      if (++count >= kLeast && sum > 4 * count) break;  // another motion
    }
    const bool is_enough =
        count >= std::max(kLeast, kShare * static_cast<double>(std::min(a.kept.size(), b.kept.size())));
    return is_enough ? sum / (4 * count) : std::numeric_limits<double>::infinity();
  }

  // The lag from `from` to `to` with the least difference.
  long best(const LoggedMotion& a, const LoggedMotion& b, long from, long to) const {
    long result = from;
    double least = std::numeric_limits<double>::infinity();
    for (long lag = from; lag <= to; ++lag) {
      const double own = difference(a, b, lag);
      if (own < least) result = lag;
      least = std::min(least, own);
    }
    return result;
  }

  bool can_compare() const { return variation_.q > 0 && variation_.qd > 0; }

 private:
  Variation variation_;
};

// The rows after which a motion begins anew; nullopt if it does not.
std::optional<double> period_of(const LoggedMotion& motion, const Comparison& comparison) {
  bool was_unlike = false;
  for (long lag = 1; lag < motion.rows(); ++lag) {
    const double own = comparison.difference(motion, motion, lag);
    was_unlike = was_unlike || (own > kUnlike && std::isfinite(own));
    if (!was_unlike || own > kAlike) continue;
    long period = lag;
    while (comparison.difference(motion, motion, period + 1) < comparison.difference(motion, motion, period)) ++period;
    // Far repetitions tell the period more exactly.
    double exact = static_cast<double>(period);
    for (long count = 2; static_cast<double>(count) * exact < 0.75 * static_cast<double>(motion.rows()); ++count) {
      const long near = std::lround(static_cast<double>(count) * exact);
      const long far = comparison.best(motion, motion, near - 1, near + 1);
      if (comparison.difference(motion, motion, far) > kAlike) break;
      exact = static_cast<double>(far) / static_cast<double>(count);
    }
    return exact;
  }
  return std::nullopt;
}

// The lag at which motion b is like a; nullopt if it never is.
std::optional<long> lag_between(const LoggedMotion& a, const LoggedMotion& b, const Comparison& comparison) {
  const long lag = comparison.best(a, b, -a.rows(), b.rows());
  return comparison.difference(a, b, lag) <= kAlike ? std::optional(lag) : std::nullopt;
}

// A log as a part of a motion: index `start` is the motion's beginning.
struct Placed {
  std::size_t motion = 0;
  double start = 0;
};

}  // namespace

std::optional<double> Repetition::distance(std::size_t a, std::size_t b) const {
  if (motion_of[a] != motion_of[b]) return std::nullopt;
  const RepeatedMotion& motion = motions[motion_of[a]];
  const double rows = phase_of[b] - phase_of[a];
  return motion.begins_anew ? std::remainder(rows, motion.period) : rows;
}

bool Repetition::any() const {
  return std::any_of(motions.begin(), motions.end(), [](const RepeatedMotion& each) { return each.count > 1; });
}

Repetition repetition_of(const Observations& observations) {
  Repetition result;
  if (observations.instants.empty()) return result;
  const std::vector<LoggedMotion> logged = logged_motions(observations);
  const Comparison comparison(observations);
  std::vector<std::size_t> first_of;  // by motion, the log that shows it first
  for (std::size_t k = 0; k < logged.size(); ++k) {
    const LoggedMotion& own = logged[k];
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(own.log)];
    const bool can_repeat = shape.run > 1 && comparison.can_compare();  // else rows may lie far apart
    std::optional<Placed> placed;
    for (std::size_t m = 0; m < first_of.size() && !placed && can_repeat; ++m) {
      const LoggedMotion& other = logged[first_of[m]];
      if (!(std::abs(other.interval() / own.interval() - 1) < kSameInterval)) continue;
      const std::optional<long> lag = lag_between(other, own, comparison);
      if (lag) placed = {m, static_cast<double>(own.first + *lag)};
    }
    const auto rows = static_cast<double>(own.rows());
    if (!placed) {
      const std::optional<double> period = can_repeat ? period_of(own, comparison) : std::nullopt;
      placed = {result.motions.size(), static_cast<double>(own.first)};
      result.motions.push_back({own.log, period.value_or(rows), period.has_value()});
      first_of.push_back(k);
    }
    RepeatedMotion& motion = result.motions[placed->motion];
    motion.count += rows / motion.period;
    for (const long at : own.kept) {
      const double since = static_cast<double>(own.first + at) - placed->start, phase = std::fmod(since, motion.period);
      result.motion_of.push_back(placed->motion);
      result.phase_of.push_back(!motion.begins_anew ? since : phase < 0 ? phase + motion.period : phase);
    }
  }
  return result;
}

}  // namespace flatdyn
