// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

constexpr double kPi = 3.141592653589793, kUsualGravity = 9.81;
constexpr double kShortStep = 1e-3, kLongStep = 2e-2;  // s
constexpr double kChangeOfRate = 0.2;                  // rad/s or m/s, over a step
// These streams are separate, so that the inputs of the other functions do not depend on them.
constexpr unsigned kReferenceSeed = 0x7265666e, kBaseSeed = 0x62617365, kGravitySeed = 0x67726176,
                   kWeightSeed = 0x77656967, kDirectionSeed = 0x64697265, kStepSeed = 0x73746570;

constexpr int kNoPosition = -1;

// std::uniform_real_distribution differs between standard libraries; this one does not.
class Uniform {
 public:
  explicit Uniform(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    constexpr double kScale = 1.0 / 9007199254740992.0;  // 2^-53
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * kScale);
  }

 private:
  std::mt19937_64 engine_;
};

double limit_or(const std::optional<Value>& value, double otherwise) {
  return value && !has_symbols(value->number) ? nearest_double(value->number) : otherwise;
}

struct Range {
  double low, high;
};

Range position_range(const Body& body) {
  const double widest = body.prismatic ? 1 : kPi;
  const Range range{limit_or(body.limits.lower, -widest), limit_or(body.limits.upper, widest)};
  if (range.low <= range.high) return range;  // else one limit alone is beyond them
  return body.limits.lower ? Range{range.low, range.low + 2 * widest} : Range{range.high - 2 * widest, range.high};
}

// A limit's size, or `otherwise` if there is none. A limit of zero means that nobody filled it in.
double bound(const std::optional<Value>& limit, double otherwise) {
  const double value = limit_or(limit, otherwise);
  return value > 0 ? value : otherwise;
}

double magnitude_of_gravity(const Vec3& v) {
  if (std::any_of(v.begin(), v.end(), has_symbols)) return kUsualGravity;
  return std::hypot(nearest_double(v[0]), nearest_double(v[1]), nearest_double(v[2]));
}

// Says which limit of a floating base is missing, as the scene calls it.
[[noreturn]] void refuse_motion_of_base(const Body& body, const std::string& what) {
  const bool slides = body.prismatic;
  const std::string key =
      what == "effort" ? (slides ? "force" : "moment") : fmt::format("{}_{}", slides ? "linear" : "angular", what);
  throw Failure(FailureKind::unsupported, fmt::format("the floating base has no limit `{}`", key),
                "give it in [base_limits] of the scene: the largest size of each component");
}

constexpr unsigned kQuaternionSeed = 0x62616c6c;

// Draws a random point of the unit sphere in four dimensions: one of a ball, scaled.
void draw_quaternion(std::vector<double>& q, std::size_t first, Uniform& uniform) {
  constexpr double kLeast = 1e-2;
  for (double square = 0; square > 1 || square < kLeast;) {
    square = 0;
    for (std::size_t k = first; k < first + 4; ++k) {
      q[k] = uniform(-1, 1);
      square += q[k] * q[k];
    }
    if (square > 1 || square < kLeast) continue;
    for (std::size_t k = first; k < first + 4; ++k) q[k] /= std::sqrt(square);
  }
}

// The motion of reference, which no limits are for.
constexpr MotionRange kReferenceRange{-kPi, kPi, 5, 20, 100};

// The largest size of a quantity by joint.
double size_in(const MotionRange& range, ArgumentQuantity quantity) {
  switch (quantity) {
    case ArgumentQuantity::velocity:
      return range.speed;
    case ArgumentQuantity::acceleration:
      return range.acceleration;
    default:
      return range.effort;
  }
}

// A vector of this length in a random direction: a random point of a ball of radius 1, scaled.
std::vector<double> in_any_direction(double length, Uniform& uniform) {
  for (;;) {
    std::vector<double> v = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    constexpr double kLeast = 1e-2;
    if (square > 1 || square < kLeast) continue;
    const double factor = length / std::sqrt(square);
    for (double& entry : v) entry *= factor;
    return v;
  }
}

}  // namespace

MotionRange motion_range(const Body& body) {
  const Range position = position_range(body);
  return {position.low, position.high, bound(body.limits.velocity, body.prismatic ? 1 : 5),
          bound(body.limits.acceleration, body.prismatic ? 10 : 20), bound(body.limits.effort, 100)};
}

double required_limit(const Mechanism& mechanism, int k, std::optional<Value> Limits::*limit) {
  const Body& body = mechanism.joint(k);
  const std::optional<Value>& given = body.limits.*limit;
  if (given && !has_symbols(given->number) && !vanishes(given->number)) return std::abs(nearest_double(given->number));
  const std::string what = limit == &Limits::velocity       ? "velocity"
                           : limit == &Limits::acceleration ? "acceleration"
                                                            : "effort";
  if (mechanism.is_of_base(k)) refuse_motion_of_base(body, what);
  throw Failure(FailureKind::unsupported, fmt::format("joint \"{}\" has no limit of {}", body.joint, what),
                "give it in the robot file, or in [limits] of the scene");
}

double required_reach(const Body& body) {
  const std::optional<Value>&lower = body.limits.lower, &upper = body.limits.upper;
  if (!lower || !upper || has_symbols(lower->number) || has_symbols(upper->number)) {
    throw Failure(FailureKind::unsupported, fmt::format("joint \"{}\" has no limit of position", body.joint),
                  "give it in the robot file, or in [limits] of the scene");
  }
  return std::max(std::abs(nearest_double(lower->number)), std::abs(nearest_double(upper->number)));
}

State in_float(State state) {
  for (const InputKind kind : kStateKinds) {
    for (double& x : state.of(kind)) x = static_cast<double>(static_cast<float>(x));
  }
  return state;
}

StateSource::StateSource(const Mechanism& mechanism) {
  for (int k = 0; k < mechanism.position_count(); ++k) {
    const MotionRange range = motion_range(mechanism.joint_at(k));
    positions_.emplace_back(range.lower, range.upper);
  }
  for (int k = 0; k < mechanism.size(); ++k) {
    const int position = mechanism.is_around_pose(k) ? kNoPosition : mechanism.position_of(k);
    joints_.push_back({position, motion_range(mechanism.joint(k))});
  }
  quaternions_ = mechanism.quaternions();
  if (mechanism.floating_base) gravity_ = magnitude_of_gravity(mechanism.gravity);
  for (const LoopClosure& loop : mechanism.loops) {
    dependent_.insert(dependent_.end(), loop.dependent.begin(), loop.dependent.end());
  }
}

std::vector<State> StateSource::draw(int count, unsigned seed) const {
  Uniform uniform(seed), reference(seed + kReferenceSeed), orientation(seed + kGravitySeed),
      of_joints(seed + kQuaternionSeed), step(seed + kStepSeed);
  std::vector<State> states;
  for (int k = 0; k < count; ++k) {
    State state;
    state.q.resize(positions_.size());
    const auto draw_position = [&](std::size_t p) { state.q[p] = uniform(positions_[p].first, positions_[p].second); };
    for (const Joint& joint : joints_) {
      const auto symmetric = [&uniform](double b) { return uniform(-b, b); };
      if (joint.position != kNoPosition) draw_position(static_cast<std::size_t>(joint.position));
      for (const InputKind kind : kMotionKinds) {
        const ArgumentRow& row = argument_row(kind);
        if (row.length != ArgumentLength::velocities || kind == InputKind::qd_end) continue;
        const double own = size_in(joint.range, row.quantity), other = size_in(kReferenceRange, row.quantity);
        state.of(kind).push_back(row.is_reference ? reference(-other, other) : symmetric(own));
      }
    }
    for (double& h : state.h_e) h = uniform(-50, 50);
    for (const int p : dependent_) draw_position(static_cast<std::size_t>(p));
    for (const int first : quaternions_) draw_quaternion(state.q, static_cast<std::size_t>(first), of_joints);
    if (gravity_ > 0) state.g_b = in_any_direction(gravity_, orientation);
    state.h = {step(kShortStep, kLongStep)};
    for (const double qd : state.qd) state.qd_end.push_back(qd + step(-1, 1) * kChangeOfRate);
    states.push_back(std::move(state));
  }
  return states;
}

std::vector<State> random_states(const Mechanism& mechanism, int count, unsigned seed) {
  return StateSource(mechanism).draw(count, seed);
}

void turn_spherical_joints(const Mechanism& mechanism, double angle, State& state) {
  constexpr double kDirection[] = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (const int position : mechanism.quaternions()) {
    const auto first = static_cast<std::size_t>(position);
    state.q[first] = std::cos(angle / 2);
    for (std::size_t k = 0; k < 3; ++k) state.q[first + 1 + k] = std::sin(angle / 2) * kDirection[k];
  }
}

State child(const State& parent, const State& other, std::mt19937_64& random, const StateMutation& mutation) {
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::size_t one_in = std::size_t(1) << below(mutation.rarest + 1);
  const auto bits = mutation.coarsest + below(mutation.finest - mutation.coarsest + 1);
  const double part = std::ldexp(1.0, -static_cast<int>(bits));
  State child = parent;
  for (const InputKind kind : kMotionKinds) {
    std::vector<double>& x = child.of(kind);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (below(one_in) == 0) x[i] += part * (other.of(kind)[i] - x[i]);
    }
  }
  return child;
}

void draw_own_arguments(std::vector<State>& states, std::span<const Function> functions, unsigned seed) {
  constexpr std::pair<InputKind, unsigned> kKinds[] = {
      {InputKind::pi_b, kBaseSeed}, {InputKind::weights, kWeightSeed}, {InputKind::direction, kDirectionSeed}};
  for (const auto& [kind, own_seed] : kKinds) {
    int count = 0;
    for (const Function& function : functions) {
      const auto& inputs = function.inputs;
      if (std::find(inputs.begin(), inputs.end(), kind) == inputs.end()) continue;
      count = std::max(count, own_length(function, argument_row(kind).length));
    }
    Uniform uniform(seed + own_seed);
    for (State& state : states) {
      state.of(kind).clear();
      for (int k = 0; k < count; ++k) state.of(kind).push_back(uniform(-1, 1));
    }
  }
}

std::vector<State> with_parameters(std::vector<State> states, const std::vector<Number>& values) {
  std::vector<double> rounded;
  for (const Number& value : values) rounded.push_back(nearest_double(value));
  for (State& state : states) state.parameters.insert(state.parameters.end(), rounded.begin(), rounded.end());
  return states;
}

std::vector<State> edge_states(const Mechanism& mechanism) {
  std::vector<State> states;
  const auto n = static_cast<std::size_t>(mechanism.size());
  const auto positions = static_cast<std::size_t>(mechanism.position_count());
  for (const double q : {0.0, kPi / 2, -kPi / 2, kPi, -kPi, 2000 * kPi, 0.1 + 1000}) {
    for (const double qd : {0.0, 1.0, -1000.0}) {
      State state;
      state.q.assign(positions, q);
      turn_spherical_joints(mechanism, q, state);
      state.qd.assign(n, qd);
      state.qdd.assign(n, qd == 1.0 ? -2.0 : 0.0);
      state.tau.assign(n, 1.0);
      state.qd_r.assign(n, -qd);
      state.qdd_r.assign(n, 1.0);
      state.qd_end.assign(n, qd);
      if (mechanism.floating_base) state.g_b = {0.0, 0.0, -magnitude_of_gravity(mechanism.gravity)};
      states.push_back(std::move(state));
    }
  }
  return states;
}

}  // namespace flatdyn
