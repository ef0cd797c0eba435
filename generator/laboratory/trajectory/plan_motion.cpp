// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/plan_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "laboratory/trajectory/tip_line.hpp"

namespace flatdyn {
namespace {

constexpr double kMostSamples = 1e7;
constexpr double kSameSample = 1e-9;  // as a share of the time between samples, or of the duration

struct JointState {
  Eigen::VectorXd q, qd, qdd;
};

// The motion during one segment.
struct Piece {
  double begin = 0, duration = 0;
  std::function<JointState(double t, Side side)> at;  // t from its beginning; may throw Unreachable
  std::vector<double> jumps{};                        // the times at which accelerations jump, from its beginning
  Place place{};
};

constexpr const char* kLineHint = "shorten or move the line, or start it in another posture";

// Thrown after a segment is reported with its place; later ones would only repeat the message.
struct Refused {};

class PieceMaker {
 public:
  PieceMaker(const TipKinematics& tip, Diagnostics& diagnostics) : tip_(tip), diagnostics_(diagnostics) {}

  // The segments of the plan. Throws Refused.
  std::vector<Piece> pieces(const TrajectoryPlan& plan) {
    q_ = Eigen::VectorXd::Zero(tip_.joints());
    q_ = reached(plan.start);
    std::vector<Piece> all;
    double begin = 0;
    for (const Segment& segment : plan.segments) {
      place_ = segment.place;
      all.push_back(std::visit([this](const auto& motion) { return piece(motion); }, segment.motion));
      all.back().begin = begin;
      all.back().place = segment.place;
      begin += all.back().duration;
    }
    return all;
  }

 private:
  [[noreturn]] void refuse(const Place& place, const std::string& message, const std::string& hint) {
    diagnostics_.error(place, message, hint);
    throw Refused();
  }

  Eigen::VectorXd reached(const Posture& posture) {
    if (const auto* joints = std::get_if<JointPosture>(&posture)) return with(*joints);
    const TipPosture& wanted = std::get<TipPosture>(posture);
    try {
      const std::optional<TwoLinkArm> arm = TwoLinkArm::of(tip_);
      if (arm && !wanted.guess) return near_present(arm->positions(wanted.p, wanted.elbow.value_or(arm->elbow_of(q_))));
      if (wanted.elbow) {
        refuse(wanted.place, "elbow: the robot is no planar arm of two links, or a guess is given, too",
               "give the positions from which the posture is found, guess = [q_1, ...], instead");
      }
      return inverse_kinematics(tip_, {wanted.p, {}}, wanted.guess ? with(*wanted.guess) : q_);
    } catch (const Unreachable& failure) {
      refuse(wanted.place, failure.what(),
             "choose a place within reach; or another guess, away from stretched postures");
    }
  }

  Eigen::VectorXd with(const JointPosture& joints) const {
    Eigen::VectorXd q = q_;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i]) q[static_cast<Eigen::Index>(i)] = *joints[i];
    }
    return q;
  }

  // The same angles without needless turns: of two values a turn apart, the one nearer to the joint's present angle.
  Eigen::VectorXd near_present(const Eigen::VectorXd& q) const {
    return q_ + (q - q_).unaryExpr([](double angle) { return std::remainder(angle, 2 * std::numbers::pi); });
  }

  VelocityProfile profile(const PlacedProfile& written, std::size_t index, double distance) {
    const auto number = [&](const char* key) -> std::optional<double> {
      const auto found = written.given.find(key);
      return found == written.given.end() ? std::nullopt : std::optional(found->second[index]);
    };
    try {
      return {
          distance,
          {written.shape, number("duration"), number("acceleration"), number("speed"), number("acceleration_time")}};
    } catch (const ProfileConflict& conflict) {
      const auto place = written.places.find(conflict.key());
      refuse(place == written.places.end() ? written.place : place->second, conflict.what(), conflict.hint());
    }
  }

  Piece piece(const JointMove& move) {
    const Eigen::VectorXd from = q_;
    q_ = move.relative ? Eigen::VectorXd(from + moved_by(std::get<JointPosture>(move.to))) : reached(move.to);
    std::vector<VelocityProfile> profiles;
    Piece piece;
    for (Eigen::Index i = 0; i < q_.size(); ++i) {
      profiles.push_back(profile(move.profile, static_cast<std::size_t>(i), q_[i] - from[i]));
      piece.duration = std::max(piece.duration, profiles.back().duration());
      const std::vector<double> jumps = profiles.back().jumps();
      piece.jumps.insert(piece.jumps.end(), jumps.begin(), jumps.end());
    }
    if (piece.duration == 0) refuse(place_, "segment: no joint moves", "to wait, write dwell = SECONDS");
    piece.at = [from, profiles](double t, Side side) {
      JointState state{from, Eigen::VectorXd(from.size()), Eigen::VectorXd(from.size())};
      for (std::size_t i = 0; i < profiles.size(); ++i) {
        const Progression here = profiles[i].at(t, side);
        const auto k = static_cast<Eigen::Index>(i);
        state.q[k] += here.position;
        state.qd[k] = here.speed;
        state.qdd[k] = here.acceleration;
      }
      return state;
    };
    return piece;
  }

  static Eigen::VectorXd moved_by(const JointPosture& joints) {
    Eigen::VectorXd by(static_cast<Eigen::Index>(joints.size()));
    for (std::size_t i = 0; i < joints.size(); ++i) by[static_cast<Eigen::Index>(i)] = joints[i].value_or(0);
    return by;
  }

  // q̇ = q' σ̇, q̈ = q'' σ̇² + q' σ̈ with the arc length σ(t).
  Piece piece(const LineMove& move) {
    const Eigen::Vector3d by = move.relative ? move.to : Eigen::Vector3d(move.to - tip_.pose(q_).p);
    if (by.norm() == 0) refuse(place_, "segment: the line has no length", "to wait, write dwell = SECONDS");
    const VelocityProfile way = profile(move.profile, 0, by.norm());
    try {
      const auto line = std::make_shared<TipLine>(tip_, q_, by, move.hold_orientation);
      q_ = line->end();
      return {0, way.duration(),
              [line, way](double t, Side side) {
                const Progression here = way.at(t, side);
                const LinePoint point = line->at(std::clamp(here.position, 0.0, line->length()));
                return JointState{point.q, point.slope * here.speed,
                                  point.curvature * here.speed * here.speed + point.slope * here.acceleration};
              },
              way.jumps()};
    } catch (const Unreachable& failure) {
      refuse(place_, failure.what(), kLineHint);
    }
  }

  Piece piece(const Dwell& dwell) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(q_.size());
    return {0, dwell.duration, [state = JointState{q_, zero, zero}](double, Side) { return state; }};
  }

  const TipKinematics& tip_;
  Diagnostics& diagnostics_;
  Eigen::VectorXd q_;  // the joints' positions at the end of the last segment
  Place place_;
};

std::vector<double> list_of(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

std::vector<double> in_base_axes(const TipForce& force, const TipKinematics& tip, const Eigen::VectorXd& q) {
  Eigen::Matrix<double, 6, 1> h_e(force.h_e.data());
  if (force.in_tip_axes) {
    const Eigen::Matrix3d R = tip.pose(q).R;
    h_e.head<3>() = R * h_e.head<3>();
    h_e.tail<3>() = R * h_e.tail<3>();
  }
  return list_of(h_e);
}

std::vector<double> sample_times(double duration, double rate) {
  std::vector<double> times;
  const double last = duration - kSameSample * std::min(1 / rate, duration);
  for (double k = 0; k / rate < last; ++k) times.push_back(k / rate);
  times.push_back(duration);
  return times;
}

// The acceleration just before time t if it jumps there; else empty.
std::vector<double> acceleration_before(const std::vector<Piece>& pieces, std::vector<Piece>::const_iterator piece,
                                        double t, double tolerance) {
  const auto is_here = [&](double jump) { return std::abs(piece->begin + jump - t) <= tolerance; };
  const bool begins = is_here(0) && piece != pieces.begin();
  if (!begins && std::none_of(piece->jumps.begin(), piece->jumps.end(), is_here)) return {};
  const Piece& leading = begins ? *std::prev(piece) : *piece;
  return list_of(leading.at(t - leading.begin, Side::before).qdd);
}

std::vector<double> times_between_jumps(const std::vector<Piece>& pieces, double duration, int intervals) {
  std::vector<double> jumps = {0, duration};
  for (const Piece& piece : pieces) {
    jumps.push_back(piece.begin);
    for (const double jump : piece.jumps) jumps.push_back(piece.begin + jump);
  }
  std::sort(jumps.begin(), jumps.end());
  std::vector<double> times = {0};
  for (const double jump : jumps) {
    const double from = times.back(), span = jump - from;
    if (span <= kSameSample * duration) continue;
    const double pairs = std::ceil(intervals * span / duration / 2 - kSameSample);
    for (double k = 1; k <= 2 * pairs; ++k) times.push_back(k < 2 * pairs ? from + span * k / (2 * pairs) : jump);
  }
  times.back() = duration;
  return times;
}

}  // namespace

Trajectory planned_motion(const TrajectoryPlan& plan, const TipKinematics& tip, Diagnostics& diagnostics,
                          std::optional<int> intervals) {
  Trajectory result;
  std::vector<Piece> pieces;
  try {
    pieces = PieceMaker(tip, diagnostics).pieces(plan);
  } catch (const Refused&) {
    return result;
  }
  const double duration = pieces.back().begin + pieces.back().duration;
  const double rate = intervals ? *intervals / duration : plan.rate;
  if (duration * rate > kMostSamples) {
    diagnostics.error({plan.file, 0}, fmt::format("{:g} s at {:g} samples per second are too many", duration, rate),
                      fmt::format("a lower rate: at most {:g} samples", kMostSamples));
    return result;
  }
  const std::vector<double> times =
      intervals ? times_between_jumps(pieces, duration, *intervals) : sample_times(duration, rate);
  const double tolerance = kSameSample * std::min(1 / rate, duration);
  auto piece = pieces.cbegin();
  try {
    for (const double t : times) {
      while (std::next(piece) != pieces.cend() && t >= std::next(piece)->begin - tolerance) ++piece;
      const JointState here = piece->at(t - piece->begin, t < duration ? Side::after : Side::before);
      result.points.push_back({t, list_of(here.q), list_of(here.qd), list_of(here.qdd), {}});
      if (t > 0 && t < duration) {
        result.points.back().qdd_before = acceleration_before(pieces, piece, t, tolerance);
      }
      if (plan.tip_force) result.points.back().h_e = in_base_axes(*plan.tip_force, tip, here.q);
    }
  } catch (const Unreachable& failure) {
    diagnostics.error(piece->place, failure.what(), kLineHint);
  }
  return result;
}

}  // namespace flatdyn
