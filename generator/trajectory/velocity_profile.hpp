// SPDX-License-Identifier: GPL-2.0-or-later
// From rest to rest with a triangular or trapezoidal velocity: a constant acceleration, a constant speed (none of a
// triangle), the opposite acceleration for as long. With distance D, duration T, acceleration time t_a, speed v and
// acceleration a
//   v = a t_a,   D = v (T − t_a),   0 < t_a ≤ T / 2.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace flatdyn {

enum class VelocityShape { triangular, trapezoidal };

// What of a profile is given; magnitudes, SI. A triangle needs one of the four, a trapezium two.
struct ProfileRequest {
  VelocityShape shape = VelocityShape::triangular;
  std::optional<double> duration, acceleration, speed, acceleration_time;
};

// No profile is so. `key` names the member of the request that is at fault ("" if members are missing).
class ProfileConflict : public std::invalid_argument {
 public:
  ProfileConflict(std::string key, const std::string& message, std::string hint)
      : std::invalid_argument(message), key_(std::move(key)), hint_(std::move(hint)) {}
  const std::string& key() const { return key_; }
  const std::string& hint() const { return hint_; }

 private:
  std::string key_, hint_;
};

// One coordinate along its path.
struct Progression {
  double position = 0, speed = 0, acceleration = 0;  // rad or m, and per s, s²
};

// Of an instant: where a limit comes from.
enum class Side { after, before };

class VelocityProfile {
 public:
  // distance may be negative, or zero for what rests. What is given beyond need must agree. Throws ProfileConflict.
  VelocityProfile(double distance, const ProfileRequest& request);

  double distance() const { return distance_; }
  double duration() const { return duration_; }
  double acceleration_time() const { return acceleration_time_; }
  double speed() const;         // the largest, a magnitude
  double acceleration() const;  // a magnitude
  // Where the acceleration jumps, from the start on.
  std::vector<double> jumps() const;
  // Where the acceleration jumps it is the one that follows, or the one before. Outside of the duration the coordinate
  // rests.
  Progression at(double t, Side side = Side::after) const;

 private:
  void solve_triangle(const ProfileRequest& request);
  void solve_trapezium(const ProfileRequest& request);
  void check(const ProfileRequest& request) const;

  double distance_ = 0, duration_ = 0, acceleration_time_ = 0;
};

}  // namespace flatdyn
