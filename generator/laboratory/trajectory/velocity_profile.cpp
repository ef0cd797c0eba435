// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/velocity_profile.hpp"

#include <fmt/format.h>

#include <cmath>

namespace flatdyn {
namespace {

// The relative tolerance of redundant values: people round.
constexpr double kAgreement = 1e-6;
// The share of a duration within which an instant counts as that of a change of acceleration.
constexpr double kSameInstant = 1e-9;

constexpr const char* kTooShort = "give it more time, or a higher acceleration";

void require_positive(const char* key, const std::optional<double>& value) {
  if (value && !(*value > 0)) {
    throw ProfileConflict(key, fmt::format("{} is {:g}", key, *value), "it is a magnitude, greater than 0");
  }
}

int given(const ProfileRequest& request) {
  return int(request.duration.has_value()) + int(request.acceleration.has_value()) + int(request.speed.has_value()) +
         int(request.acceleration_time.has_value());
}

// The root t_a ≤ T / 2 of a t_a (T − t_a) = D.
double acceleration_time_of(double distance, double duration, double acceleration) {
  const double room = duration * duration / 4 - distance / acceleration;
  if (room < -kAgreement * duration * duration) {
    throw ProfileConflict("acceleration",
                          fmt::format("an acceleration of {:g} is too low for {:g} in {:g} s: at least {:.6g}",
                                      acceleration, distance, duration, 4 * distance / (duration * duration)),
                          kTooShort);
  }
  return duration / 2 - std::sqrt(std::max(room, 0.0));
}

}  // namespace

VelocityProfile::VelocityProfile(double distance, const ProfileRequest& request) : distance_(distance) {
  require_positive("duration", request.duration);
  require_positive("acceleration", request.acceleration);
  require_positive("speed", request.speed);
  require_positive("acceleration_time", request.acceleration_time);
  if (distance == 0) {
    duration_ = request.duration.value_or(0);
    acceleration_time_ = duration_ / 2;
    return;
  }
  if (request.shape == VelocityShape::triangular) {
    solve_triangle(request);
  } else {
    solve_trapezium(request);
  }
  check(request);
}

void VelocityProfile::solve_triangle(const ProfileRequest& request) {
  const double D = std::abs(distance_);
  if (given(request) == 0) {
    throw ProfileConflict("", "a triangular profile needs its duration",
                          "give duration, acceleration, speed or acceleration_time");
  }
  if (request.duration) {
    duration_ = *request.duration;
  } else if (request.acceleration) {
    duration_ = 2 * std::sqrt(D / *request.acceleration);
  } else {
    duration_ = request.speed ? 2 * D / *request.speed : 2 * *request.acceleration_time;
  }
  acceleration_time_ = duration_ / 2;
}

void VelocityProfile::solve_trapezium(const ProfileRequest& request) {
  const double D = std::abs(distance_);
  if (given(request) < 2) {
    throw ProfileConflict("", "a trapezoidal profile needs two numbers",
                          "give two of duration, acceleration, speed and acceleration_time");
  }
  const auto& [shape, T, a, v, t_a] = request;
  if (T && t_a) {
    acceleration_time_ = *t_a;
  } else if (T && v) {
    acceleration_time_ = *T - D / *v;
  } else if (T) {
    acceleration_time_ = acceleration_time_of(D, *T, *a);
  } else {
    acceleration_time_ = t_a ? *t_a : *v / *a;
  }
  duration_ = T ? *T : D / (v ? *v : *a * *t_a) + acceleration_time_;
  if (acceleration_time_ <= 0) {
    throw ProfileConflict("speed", fmt::format("at a speed of {:g}, {:g} s are too short for {:g}", *v, *T, D),
                          fmt::format("more than {:.6g}, up to {:.6g} of a triangular profile", D / *T, 2 * D / *T));
  }
  if (acceleration_time_ > duration_ / 2 * (1 + kAgreement)) {
    throw ProfileConflict(
        v ? "speed" : "acceleration_time",
        fmt::format("it would accelerate for {:.6g} s, which is more than half of {:.6g} s", acceleration_time_,
                    duration_),
        "the distance is too short for that; a triangular profile is as fast as its acceleration lets it be");
  }
  acceleration_time_ = std::min(acceleration_time_, duration_ / 2);
}

void VelocityProfile::check(const ProfileRequest& request) const {
  const auto agree = [](const char* key, const std::optional<double>& wanted, double is) {
    if (!wanted || std::abs(*wanted - is) <= kAgreement * is) return;
    throw ProfileConflict(key, fmt::format("{} is given as {:g}, but from the rest it is {:.6g}", key, *wanted, is),
                          "leave out one of them");
  };
  agree("duration", request.duration, duration_);
  agree("acceleration", request.acceleration, acceleration());
  agree("speed", request.speed, speed());
  agree("acceleration_time", request.acceleration_time, acceleration_time_);
}

double VelocityProfile::speed() const {
  return distance_ == 0 ? 0 : std::abs(distance_) / (duration_ - acceleration_time_);
}

double VelocityProfile::acceleration() const { return distance_ == 0 ? 0 : speed() / acceleration_time_; }

std::vector<double> VelocityProfile::jumps() const {
  if (distance_ == 0) return {};
  return {0, acceleration_time_, duration_ - acceleration_time_, duration_};
}

Progression VelocityProfile::at(double t, Side side) const {
  if (distance_ == 0) return {};
  const bool after = side == Side::after;
  const double same = kSameInstant * duration_, change = after ? -same : same;
  const double sign = distance_ > 0 ? 1 : -1, v = sign * speed(), a = sign * acceleration();
  const double left = duration_ - t;
  if (t <= same) return {0, 0, after && t >= -same ? a : 0};
  if (left <= same) return {distance_, 0, !after && left >= -same ? -a : 0};
  if (t < acceleration_time_ + change) return {a * t * t / 2, a * t, a};
  if (left > acceleration_time_ - change) return {v * (t - acceleration_time_ / 2), v, 0};
  return {distance_ - a * left * left / 2, a * left, -a};
}

}  // namespace flatdyn
