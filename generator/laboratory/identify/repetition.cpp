// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/repetition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace flatdyn {
namespace {

constexpr double kAlike = 0.01, kUnlike = 0.25;  // mean squares of differences, divided by those of other motions
constexpr long kMostRows = 30000;                // of a period, and of logs that are compared
constexpr double kSameInterval = 1e-3;           // relative difference of the intervals of rows

// The instants of a log.
struct LoggedMotion {
  int log = 0;
  long first = 0;                          // the first one's index
  std::vector<const EquationInstant*> at;  // from index `first` on; nullptr where the instant is not kept
  std::vector<long> kept;                  // where it is: index - first

  double q_variance = 0, qd_variance = 0;  // sums over all entries

  long rows() const { return static_cast<long>(at.size()); }
  // Seconds from a row to the next one.
  double interval() const { return (at.back()->time - at.front()->time) / static_cast<double>(rows() - 1); }
};

double squared_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::pow(a[k] - b[k], 2);
  return sum;
}

double variance_of(const LoggedMotion& motion, std::vector<double> EquationInstant::*entries) {
  const std::size_t size = (motion.at.front()->*entries).size();
  std::vector<double> mean(size, 0);
  const auto count = static_cast<double>(motion.kept.size());
  for (const long k : motion.kept) {
    for (std::size_t i = 0; i < size; ++i) mean[i] += (motion.at[static_cast<std::size_t>(k)]->*entries)[i] / count;
  }
  double result = 0;
  for (const long k : motion.kept) {
    result += squared_distance(motion.at[static_cast<std::size_t>(k)]->*entries, mean) / count;
  }
  return result;
}

double squares_of(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double each : numbers) sum += each * each;
  return sum;
}

std::vector<LoggedMotion> logged_motions(const Observations& observations) {
  std::vector<LoggedMotion> result;
  for (const EquationInstant& each : observations.instants) {
    if (result.empty() || result.back().log != each.log) result.push_back({each.log, each.index, {}, {}, 0, 0});
    LoggedMotion& motion = result.back();
    motion.at.resize(static_cast<std::size_t>(each.index - motion.first) + 1, nullptr);
    motion.at.back() = &each;
    motion.kept.push_back(each.index - motion.first);
  }
  for (LoggedMotion& each : result) {
    each.q_variance = variance_of(each, &EquationInstant::q);
    each.qd_variance = variance_of(each, &EquationInstant::qd);
  }
  return result;
}

// The mean square of the differences of motion b, `lag` rows later, from motion a: 1 where they have nothing in common;
// infinite where too few instants of both are there, or where the robot hardly moves in them.
double difference(const LoggedMotion& a, const LoggedMotion& b, long lag) {
  constexpr double kLeast = 32, kShare = 0.03, kMoving = 0.25;
  const double q = std::min(a.q_variance, b.q_variance), qd = std::min(a.qd_variance, b.qd_variance);
  double count = 0, sum = 0, speed = 0;
  for (const long k : a.kept) {
    if (k + lag < 0 || k + lag >= b.rows()) continue;
    const EquationInstant& one = *a.at[static_cast<std::size_t>(k)];
    const EquationInstant* other = b.at[static_cast<std::size_t>(k + lag)];
    if (other == nullptr) continue;
    sum += squared_distance(one.q, other->q) / q + squared_distance(one.qd, other->qd) / qd;
    speed += squares_of(one.qd);
    if (++count >= kLeast && sum > 4 * count) break;  // another motion
  }
  const double enough = std::max(kLeast, kShare * static_cast<double>(std::min(a.kept.size(), b.kept.size())));
  return count >= enough && speed > kMoving * qd * count ? sum / (4 * count) : std::numeric_limits<double>::infinity();
}

// The lag from `from` to `to` with the least difference.
long best_lag(const LoggedMotion& a, const LoggedMotion& b, long from, long to) {
  long result = from;
  double least = std::numeric_limits<double>::infinity();
  for (long lag = from; lag <= to; ++lag) {
    const double own = difference(a, b, lag);
    if (own < least) result = lag;
    least = std::min(least, own);
  }
  return result;
}

// The rows after which a motion begins anew; nullopt if it does not. Far repetitions tell them more exactly.
std::optional<double> period_of(const LoggedMotion& motion) {
  constexpr long kNear = 12;  // rows from the first lag that is alike to the one that is most alike
  bool was_unlike = false;
  for (long lag = 1; lag < std::min(motion.rows(), kMostRows); ++lag) {
    const double own = difference(motion, motion, lag);
    was_unlike = was_unlike || (own > kUnlike && std::isfinite(own));
    if (!was_unlike || own > kAlike) continue;
    double exact = static_cast<double>(best_lag(motion, motion, lag, lag + kNear));
    for (long count = 2; static_cast<double>(count) * exact < 0.75 * static_cast<double>(motion.rows()); ++count) {
      const long near = std::lround(static_cast<double>(count) * exact);
      const long far = best_lag(motion, motion, near - 2, near + 2);
      const double unlike = difference(motion, motion, far);
      if (unlike <= kAlike) exact = static_cast<double>(far) / static_cast<double>(count);
      if (std::isfinite(unlike) && unlike > kAlike) break;
    }
    return exact;
  }
  return std::nullopt;
}

// The lag at which motion b is like a; nullopt if it never is.
std::optional<long> lag_between(const LoggedMotion& a, const LoggedMotion& b) {
  if (std::max(a.rows(), b.rows()) > kMostRows) return std::nullopt;
  const long lag = best_lag(a, b, -a.rows(), b.rows());
  return difference(a, b, lag) <= kAlike ? std::optional(lag) : std::nullopt;
}

// A log as a part of a motion: index `start` is the motion's beginning.
struct Placed {
  std::size_t motion = 0;
  double start = 0;
};

}  // namespace

bool Repetition::any() const {
  return std::any_of(motions.begin(), motions.end(), [](const RepeatedMotion& each) { return each.count > 1; });
}

Repetition repetition_of(const Observations& observations) {
  Repetition result;
  if (observations.instants.empty()) return result;
  const std::vector<LoggedMotion> logged = logged_motions(observations);
  std::vector<std::size_t> first_of;  // by motion, the log that shows it first
  for (std::size_t k = 0; k < logged.size(); ++k) {
    const LoggedMotion& own = logged[k];
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(own.log)];
    // Without a filter rows may lie far apart.
    const bool can_repeat = shape.run > 1 && own.q_variance > 0 && own.qd_variance > 0;
    std::optional<Placed> placed;
    for (std::size_t m = 0; m < first_of.size() && !placed && can_repeat; ++m) {
      const LoggedMotion& other = logged[first_of[m]];
      if (!(std::abs(other.interval() / own.interval() - 1) < kSameInterval)) continue;
      const std::optional<long> lag = lag_between(other, own);
      if (lag) placed = {m, static_cast<double>(own.first + *lag)};
    }
    const auto rows = static_cast<double>(own.rows());
    if (!placed) {
      const std::optional<double> period = can_repeat ? period_of(own) : std::nullopt;
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
