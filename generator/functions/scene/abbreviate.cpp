// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/scene/abbreviate.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "graph/arithmetic.hpp"
#include "robot/model/rounded_up.hpp"
#include "robot/model/spherical_joint.hpp"
#include "robot/model/states.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {
namespace {

// The largest norms, within the limits, of ω, ω̇ and p̈ - g_0 of a body, and of its origin's displacement from its
// parent's.
struct LargestMotion {
  double omega = 0, domega = 0, ddp = 0, step = 0;

  double swing() const { return domega + omega * omega; }  // the largest acceleration of a point at distance 1
};

// The absolute value of a limit.
double limit_of(const Mechanism& mechanism, int k, std::optional<Value> Limits::*limit) {
  try {
    return required_limit(mechanism, k, limit);
  } catch (const Failure& failure) {
    throw Failure(failure.kind(), std::string("error budget: ") + failure.what(), failure.hint());
  }
}

double reach_of(const Body& body) {
  try {
    return required_reach(body);
  } catch (const Failure& failure) {
    throw Failure(failure.kind(), std::string("error budget: ") + failure.what(), failure.hint());
  }
}

double norm(const Vec3& v) { return std::hypot(nearest_double(v[0]), nearest_double(v[1]), nearest_double(v[2])); }

// The limit of a joint's motion; of a spherical joint, of which k is the first body, that of the vector whose three
// components have limits.
double rate_limit_of(const Mechanism& mechanism, int k, std::optional<Value> Limits::*limit) {
  if (!mechanism.is_of_spherical(k)) return limit_of(mechanism, k, limit);
  double squares = 0;
  for (int i = k; i < k + kSphericalBodies; ++i) squares += std::pow(limit_of(mechanism, i, limit), 2);
  return std::sqrt(squares) * kRoundingMargin;
}

// The bodies of a spherical joint have the motion of its link, all but the step to the first of them.
LargestMotion moved(const LargestMotion& parent, const Mechanism& mechanism, int k, bool at_rest) {
  const Body& body = mechanism.joint(k);
  LargestMotion motion = parent;
  if (body.spherical > 1) {
    motion.step = 0;
    return motion;
  }
  const double qd = at_rest ? 0 : rate_limit_of(mechanism, k, &Limits::velocity);
  const double qdd = rate_limit_of(mechanism, k, &Limits::acceleration);
  motion.step = norm(body.p);
  if (body.prismatic) {
    motion.step += reach_of(body);
    motion.ddp += motion.step * parent.swing() + 2 * qd * parent.omega + qdd;
    return motion;
  }
  motion.ddp += motion.step * parent.swing();
  motion.omega += qd;
  motion.domega += qdd + qd * parent.omega;
  return motion;
}

// The motion of a floating base, which all of its bodies are given. The length of a vector is at most √3 times its
// components' limit.
LargestMotion motion_of_floating_base(const Mechanism& mechanism, bool at_rest) {
  constexpr int kLinear = 0, kAngular = 3;
  const double root_3 = std::sqrt(3.0) * kRoundingMargin;
  const auto largest = [&](int k, std::optional<Value> Limits::*limit) {
    return root_3 * limit_of(mechanism, k, limit);
  };
  LargestMotion motion;
  if (!at_rest) {
    motion.omega = largest(kAngular, &Limits::velocity);
    motion.ddp = motion.omega * largest(kLinear, &Limits::velocity);  // |ω × v|
  }
  motion.domega = largest(kAngular, &Limits::acceleration);
  motion.ddp += largest(kLinear, &Limits::acceleration) + norm(mechanism.gravity);
  return motion;
}

std::vector<LargestMotion> largest_motions(const Mechanism& mechanism, bool at_rest) {
  std::vector<LargestMotion> motions;
  if (mechanism.floating_base) {
    motions.assign(static_cast<std::size_t>(mechanism.base_bodies()), motion_of_floating_base(mechanism, at_rest));
  }
  for (int k = mechanism.base_bodies(); k < mechanism.body_count(); ++k) {
    const int parent = mechanism.joint(k).parent;
    LargestMotion before;
    if (parent < 0) {
      before.ddp = norm(mechanism.gravity);
    } else {
      before = motions[static_cast<std::size_t>(parent)];
    }
    motions.push_back(moved(before, mechanism, k, at_rest));
  }
  return motions;
}

struct Pull {
  double force = 0, moment = 0;  // about the origin of the body's frame
};

// The largest force and moment of a unit of the parameter. For a unit moment of inertia about an axis a, ω × Î ω is ω_a
// (ω × a), of length ω²/2 at most.
Pull unit_pull(Parameter parameter, const LargestMotion& motion) {
  switch (parameter) {
    case Parameter::m:
      return {motion.ddp, 0};
    case Parameter::mlx:
    case Parameter::mly:
    case Parameter::mlz:
      return {motion.swing(), motion.ddp};
    case Parameter::Ixx:
    case Parameter::Iyy:
    case Parameter::Izz:
      return {0, motion.domega + motion.omega * motion.omega / 2};
    default:
      return {0, motion.swing()};
  }
}

// The rough share of the recursion's arithmetic that a parameter causes: a mass makes a force, a first moment acts on
// forces and moments, a moment of inertia on moments only.
double weight(Parameter parameter) {
  switch (parameter) {
    case Parameter::m:
    case Parameter::Ixy:
    case Parameter::Ixz:
    case Parameter::Iyz:
      return 6;
    case Parameter::mlx:
    case Parameter::mly:
    case Parameter::mlz:
      return 8;
    default:
      return 3;
  }
}

bool is_inertia(Parameter parameter) { return parameter >= Parameter::Ixx; }

// The mechanism without position limits of revolute joints, as B should be positive definite beyond the limits, too.
Mechanism turning_freely(Mechanism mechanism) {
  for (Body& body : mechanism.bodies) {
    if (!body.prismatic) body.limits.lower = body.limits.upper = std::nullopt;
  }
  return mechanism;
}

// Checks whether B of a model is positive definite at random positions.
class InertiaCheck {
 public:
  explicit InertiaCheck(const Mechanism& mechanism) {
    constexpr int kPositions = 200;
    for (State& state : random_states(turning_freely(mechanism), kPositions, 1)) {
      points_.push_back(points_of(mechanism, state));
      states_.push_back(std::move(state));
    }
  }

  bool is_positive(const Mechanism& mechanism) const {
    std::optional<MechanismOver<double>> field;
    for (std::size_t k = 0; k < states_.size(); ++k) {
      // Quaternions are in the mechanism's own numbers.
      if (!field || mechanism.has_spherical_joints()) field = mechanism_at(mechanism, states_[k]);
      Lagrangian<double> at_position(*field, points_[k]);
      const Matrix<double>& B = at_position.inertia();
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      const Eigen::Map<const RowMajor> entries(B.entries().data(), B.rows(), B.cols());
      if (entries.llt().info() != Eigen::Success) return false;
    }
    return true;
  }

 private:
  static MechanismOver<double> mechanism_at(const Mechanism& mechanism, const State& state) {
    RealArithmetic<double> numbers([&state](const Input& input) {
      return input.kind == InputKind::q ? state.q[static_cast<std::size_t>(input.index)] : 0.0;
    });
    return mechanism_over(mechanism, numbers);
  }

  // Coordinates around the present pose are zero.
  static std::vector<JointPoint<double>> points_of(const Mechanism& mechanism, const State& state) {
    std::vector<JointPoint<double>> points;
    for (int k = 0; k < mechanism.body_count(); ++k) {
      const double q = mechanism.is_around_pose(k) ? 0 : state.q[static_cast<std::size_t>(mechanism.position_of(k))];
      points.push_back({std::cos(q), std::sin(q), q});
    }
    return points;
  }

  std::vector<State> states_;
  std::vector<std::vector<JointPoint<double>>> points_;
};

class Abbreviator {
 public:
  // `values`: the base parameters' values in their places, and zeros elsewhere.
  Abbreviator(const Mechanism& mechanism, std::vector<InertialParameters> values, const ErrorBudget& budget,
              const TorqueScope& scope)
      : values_(std::move(values)),
        has_inertias_(!scope.only_gravity),
        motions_(largest_motions(mechanism, scope.at_rest)),
        check_(mechanism) {
    result_.mechanism = mechanism;
    for (int k = 0; k < mechanism.size(); ++k) {
      result_.budget.push_back(budget.relative ? budget.value * limit_of(mechanism, k, &Limits::effort) : budget.value);
    }
    result_.bound.assign(mechanism.bodies.size(), 0);
  }

  Abbreviation run() {
    std::vector<Candidate> candidates = all_candidates();
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.price < b.price; });
    for (const Candidate& candidate : candidates) drop_if_it_fits(candidate);
    return std::move(result_);
  }

 private:
  struct Candidate {
    DroppedParameter parameter;
    Parameter kind;
    double price = 0;  // largest fraction of a joint's budget per operation saved
  };

  std::vector<Candidate> all_candidates() const {
    std::vector<Candidate> candidates;
    for (int k = 0; k < result_.mechanism.size(); ++k) {
      const std::vector<Number> values = entries_of(values_[static_cast<std::size_t>(k)]);
      for (int p = 0; p < kInertialPerBody; ++p) {
        const auto kind = static_cast<Parameter>(p);
        const Number& value = values[static_cast<std::size_t>(p)];
        if (vanishes(value) || (is_inertia(kind) && !has_inertias_)) continue;
        candidates.push_back(candidate(k, kind, nearest_double(value)));
      }
    }
    return candidates;
  }

  Candidate candidate(int k, Parameter kind, double value) const {
    Candidate result{{k, parameter_name(index_of(k, kind), result_.mechanism.base_bodies()), value,
                      bounds(k, kind, std::abs(value))},
                     kind,
                     0};
    for (std::size_t i = 0; i < result_.budget.size(); ++i) {
      const double part = result.parameter.bound[i] == 0 ? 0 : result.parameter.bound[i] / result_.budget[i];
      result.price = std::max(result.price, part / weight(kind));
    }
    return result;
  }

  // The bounds by joint: the parameter has an effect only on the joints from body k to the base.
  std::vector<double> bounds(int k, Parameter kind, double value) const {
    std::vector<double> result(result_.budget.size(), 0);
    const Pull pull = unit_pull(kind, motions_[static_cast<std::size_t>(k)]);
    double lever = 0;
    for (int i = k; i >= 0;) {
      const auto at = static_cast<std::size_t>(i);
      const Body& body = result_.mechanism.bodies[at];
      result[at] = kRoundingMargin * value * (body.prismatic ? pull.force : pull.moment + lever * pull.force);
      lever += motions_[at].step;
      i = body.parent;
    }
    return result;
  }

  void drop_if_it_fits(const Candidate& candidate) {
    const DroppedParameter& parameter = candidate.parameter;
    for (std::size_t i = 0; i < result_.bound.size(); ++i) {
      if (kRoundingMargin * (result_.bound[i] + parameter.bound[i]) > result_.budget[i]) return;
    }
    InertialParameters& inertia = result_.mechanism.bodies[static_cast<std::size_t>(parameter.body)].inertia;
    const InertialParameters before = inertia;
    remove(inertia, candidate.kind, values_[static_cast<std::size_t>(parameter.body)]);
    if (!check_.is_positive(result_.mechanism)) {
      inertia = before;
      return;
    }
    for (std::size_t i = 0; i < result_.bound.size(); ++i) result_.bound[i] += parameter.bound[i];
    result_.dropped.push_back(parameter);
  }

  // Subtracts so much of the parameter that nothing of the base parameter is left.
  static void remove(InertialParameters& inertia, Parameter kind, const InertialParameters& values) {
    inertia = inertia + single_parameter(kind, -entries_of(values)[static_cast<std::size_t>(kind)]);
  }

  std::vector<InertialParameters> values_;
  bool has_inertias_;
  std::vector<LargestMotion> motions_;
  InertiaCheck check_;
  Abbreviation result_;
};

}  // namespace

// Only base parameters are dropped, so that no budget is spent on parameters without effect. The model keeps the other
// ones as they are: how they are grouped is chosen later.
std::vector<std::string> names_of_dropped(const Abbreviation& abbreviation) {
  std::vector<std::string> names;
  for (const DroppedParameter& dropped : abbreviation.dropped) names.push_back(dropped.name);
  return names;
}

Abbreviation abbreviated(const Mechanism& mechanism, const ErrorBudget& budget, const TorqueScope& scope) {
  if (!mechanism.symbols.empty()) {
    throw Failure(FailureKind::unsupported, "error budget: the robot has free symbols", "give them numbers");
  }
  if (mechanism.is_coupled()) {
    const char* what = mechanism.has_loops() ? "closed loops" : "coupled joints";
    throw Failure(FailureKind::unsupported, fmt::format("error budget: {} are not supported yet", what),
                  "leave the budget out");
  }
  const BaseParameters base = base_parameters(mechanism);
  std::vector<InertialParameters> values;
  for (const Body& body : with_base_parameters(mechanism, base, base_values(mechanism, base)).bodies) {
    values.push_back(body.inertia);
  }
  return Abbreviator(mechanism, std::move(values), budget, scope).run();
}

}  // namespace flatdyn
