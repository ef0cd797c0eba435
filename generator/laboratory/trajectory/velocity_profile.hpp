// SPDX-License-Identifier: GPL-2.0-or-later
// A motion from rest to rest with a triangular or trapezoidal velocity: a constant acceleration, a constant speed (not
// in a triangle), and the opposite acceleration for the same time. With distance D, duration T, acceleration time t_a,
// speed v and acceleration a
//   v = a t_a,   D = v (T − t_a),   0 < t_a ≤ T / 2.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace flatdyn {

enum class VelocityShape { triangular, trapezoidal };

// The given values of a profile; magnitudes, SI. A triangle needs one of the four, a trapezium two.
struct ProfileRequest {
  VelocityShape shape = VelocityShape::triangular;
  std::optional<double> duration, acceleration, speed, acceleration_time;
};

// The request has no profile. `key` names the faulty member of the request ("" if members are missing).
class ProfileConflict : public std::invalid_argument {
 public:
  ProfileConflict(std::string key, const std::string& message, std::string hint)
      : std::invalid_argument(message), key_(std::move(key)), hint_(std::move(hint)) {}
  const std::string& key() const { return key_; }
  const std::string& hint() const { return hint_; }

 private:
  std::string key_, hint_;
};

// A coordinate along its path at one time.
struct Progression {
  double position = 0, speed = 0, acceleration = 0;  // rad or m, and per s, s²
};

// The side of an instant from which a limit is taken.
enum class Side { after, before };

class VelocityProfile {
 public:
  // distance: rad or m; may be negative, or zero for rest. Redundant values must agree. Throws ProfileConflict.
  VelocityProfile(double distance, const ProfileRequest& request);

  double distance() const { return distance_; }
  double duration() const { return duration_; }
  double acceleration_time() const { return acceleration_time_; }
  double speed() const;         // the largest, a magnitude
  double acceleration() const;  // a magnitude
  // The times in s at which the acceleration jumps, from the start on.
  std::vector<double> jumps() const;
  // The state at time t in s. At a jump, `side` selects the acceleration. Outside the duration the coordinate rests.
  Progression at(double t, Side side = Side::after) const;

 private:
  void solve_triangle(const ProfileRequest& request);
  void solve_trapezium(const ProfileRequest& request);
  void check(const ProfileRequest& request) const;

  double distance_ = 0, duration_ = 0, acceleration_time_ = 0;
};

}  // namespace flatdyn
