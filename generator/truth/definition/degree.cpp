// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/degree.hpp"

#include <algorithm>
#include <cmath>

#include "derivation/parameters/base_parameters.hpp"
#include "graph/evaluate.hpp"
#include "truth/definition/lagrangian_regressor.hpp"
#include "truth/definition/written_energies.hpp"

namespace flatdyn {

Degree Degree::of(double degree) {
  Degree result(1);
  result.degree_ = degree;
  return result;
}

Degree& Degree::operator+=(const Degree& b) {
  is_zero_ = is_zero_ && b.is_zero_;
  degree_ = std::max(degree_, b.degree_);
  return *this;
}

namespace {

// The degree of an angle's cosine and sine in those of the angles that are drawn; multiples are expanded by the
// addition theorems.
double angle_degree(const Graph& graph, NodeId angle) {
  const Node& node = graph[angle];
  if (node.op != Op::sum) return 1;
  double degree = node.value == 0 ? 0 : 1;
  for (const Term& term : node.terms) {
    degree += std::ceil(std::abs(term.coefficient.truncated())) * angle_degree(graph, term.node);
  }
  return degree;
}

struct DegreeArithmetic {
  using Scalar = Degree;
  Degree constant(const Rational& value) const { return Degree(value == 0 ? 0 : 1); }
  Degree input(const Input&) const { return Degree::of(1); }
  Degree divide(const Degree& a, const Degree& b) {
    reciprocals += b.value();
    return a * Degree::of(1);
  }
  Degree sin(const Graph& graph, NodeId angle, const Degree&) const { return Degree::of(angle_degree(graph, angle)); }
  Degree cos(const Graph& graph, NodeId angle, const Degree&) const { return Degree::of(angle_degree(graph, angle)); }
  Degree tanh(const Degree&) const { return Degree::of(1); }  // degree_of_dry_friction() counts it

  double reciprocals = 0;
};

// The degrees of all denominators, by number.
using Denominators = std::vector<double>;

// The degree of a quotient N / Π D_k^e_k. Denominators are kept apart by the quotient that introduced them, so that a
// sum of terms with equal denominators does not multiply them.
struct RationalDegree {
  bool is_zero = true;
  double numerator = 0;
  std::map<std::size_t, double> exponents;
  std::shared_ptr<const Denominators> denominators;

  // The degree of Π D_k^(common_k - e_k).
  double missing(const std::map<std::size_t, double>& common, const Denominators& degrees) const {
    double total = 0;
    for (const auto& [k, exponent] : common) {
      const auto own = exponents.find(k);
      total += (exponent - (own == exponents.end() ? 0 : own->second)) * degrees[k];
    }
    return total;
  }

  RationalDegree& operator+=(const RationalDegree& b) {
    if (b.is_zero) return *this;
    if (is_zero) return *this = b;
    if (!denominators) denominators = b.denominators;
    std::map<std::size_t, double> common = exponents;
    for (const auto& [k, exponent] : b.exponents) common[k] = std::max(common[k], exponent);
    if (!common.empty()) {
      numerator = std::max(numerator + missing(common, *denominators), b.numerator + b.missing(common, *denominators));
    } else {
      numerator = std::max(numerator, b.numerator);
    }
    exponents = std::move(common);
    return *this;
  }

  RationalDegree& operator*=(const RationalDegree& b) {
    is_zero = is_zero || b.is_zero;
    if (!denominators) denominators = b.denominators;
    numerator += b.numerator;
    for (const auto& [k, exponent] : b.exponents) exponents[k] += exponent;
    return *this;
  }
  friend RationalDegree operator*(RationalDegree a, const RationalDegree& b) { return a *= b; }
};

class RationalDegreeArithmetic {
 public:
  using Scalar = RationalDegree;

  RationalDegree constant(const Rational& value) const { return {value == 0, 0, {}, nullptr}; }
  RationalDegree input(const Input&) const { return {false, 1, {}, nullptr}; }
  RationalDegree sin(const Graph& graph, NodeId angle, const RationalDegree&) const {
    return {false, angle_degree(graph, angle), {}, nullptr};
  }
  RationalDegree cos(const Graph& graph, NodeId angle, const RationalDegree& value) const {
    return sin(graph, angle, value);
  }
  RationalDegree sign(const RationalDegree&) const { return {false, 1, {}, nullptr}; }
  // sqrt(N / D) = sqrt(N D) / D; a root counts at least as much as its argument.
  RationalDegree sqrt(RationalDegree x) const {
    for (const auto& [k, exponent] : x.exponents) x.numerator += exponent * (*denominators_)[k];
    return x;
  }

  // (N_a / Π D^e_a) / (N_b / Π D^e_b): N_b becomes a denominator.
  RationalDegree divide(RationalDegree a, const RationalDegree& b) {
    a.denominators = denominators_;
    for (const auto& [k, exponent] : b.exponents) {
      const double cancelled = std::min(a.exponents[k], exponent);
      a.exponents[k] -= cancelled;
      a.numerator += (exponent - cancelled) * (*denominators_)[k];
    }
    a.exponents[denominators_->size()] = 1;
    denominators_->push_back(b.numerator);
    return a;
  }

  const Denominators& denominators() const { return *denominators_; }

 private:
  std::shared_ptr<Denominators> denominators_ = std::make_shared<Denominators>();
};

// The denominators of smooth signs and of their Stribeck weights count as reciprocals, and so do the numerators of
// smooth signs, which count as drawn values.
double degree_of_dry_friction(const Mechanism& mechanism) {
  RationalDegreeArithmetic arithmetic;
  const RationalDegree sign = rational_tanh(arithmetic, arithmetic.input({}));
  double of_sign = sign.numerator;
  for (const auto& [k, exponent] : sign.exponents) of_sign += exponent * arithmetic.denominators()[k];
  double total = 0;
  for (const Body& body : mechanism.bodies) {
    if (body.dry.is_smooth()) total += (vanishes(body.dry.offset) ? 2 : 3) * of_sign;  // of sums over a speed, and s_0
    if (body.dry.has_excess()) total += 4;
  }
  return total;
}

// The degrees of every body's joint position: of the cosine and sine of a sum of multiples of coordinates.
std::vector<JointPoint<Degree>> joint_degrees(const Mechanism& mechanism) {
  std::vector<JointPoint<Degree>> degrees;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    if (mechanism.is_around_pose(i)) {
      degrees.emplace_back();
      continue;
    }
    double turns = 0;
    for (int p = 0; p < mechanism.position_count(); ++p) {
      turns += std::ceil(std::abs(nearest_double(mechanism.position_factor(i, p))));
    }
    degrees.push_back({Degree::of(turns), Degree::of(turns), Degree::of(1)});
  }
  return degrees;
}

// The mechanism with gravity as an argument if the base floats and there is any.
MechanismOver<Degree> mechanism_with_drawn_gravity(const Mechanism& mechanism, DegreeArithmetic& arithmetic) {
  MechanismOver<Degree> field = mechanism_over(mechanism, arithmetic);
  const Degree drawn = Degree::of(1);
  if (mechanism.has_base_gravity()) field.gravity = {drawn, drawn, drawn};
  return field;
}

// Accelerations of coordinates around the present pose have products of velocities.
std::vector<Degree> accelerations_of_coordinates(const Mechanism& mechanism) {
  const Degree drawn = Degree::of(1);
  return std::vector<Degree>(static_cast<std::size_t>(mechanism.size()),
                             mechanism.has_quasi_velocities() ? drawn * drawn : drawn);
}

}  // namespace

MechanismDegrees lagrangian_degrees(const Mechanism& mechanism) {
  DegreeArithmetic arithmetic;
  const Degree drawn = Degree::of(1);
  const auto n = static_cast<std::size_t>(mechanism.size());
  const auto bodies = static_cast<std::size_t>(mechanism.body_count());
  Lagrangian<Degree> lagrangian(mechanism_with_drawn_gravity(mechanism, arithmetic), joint_degrees(mechanism));
  const std::vector<Degree> rates(n, drawn), signs(bodies, drawn),
      accelerations = accelerations_of_coordinates(mechanism);
  Degree largest = lagrangian.potential_energy() + lagrangian.kinetic_energy(rates);
  for (const Degree& torque : lagrangian.inverse_dynamics(rates, accelerations, signs)) largest += torque;
  for (const Degree& torque : lagrangian.tip_torques(std::vector<Degree>(6, drawn))) largest += torque;
  for (const FieldFrame<Degree>& link : lagrangian.mechanism().links) {
    for (const Degree& entry : lagrangian.jacobian_dot_qd(link, rates)) largest += entry;
  }
  return {largest.value(), arithmetic.reciprocals + degree_of_dry_friction(mechanism)};
}

double in_drawn_values(double degree, double angles, double reciprocals) {
  return degree * (1 + 2 * angles + reciprocals);
}

double energy_degree(const Robot& robot, const Mechanism& mechanism) {
  DegreeArithmetic arithmetic;
  const Degree drawn = Degree::of(1);
  const std::vector<JointPoint<Degree>> q = joint_degrees(mechanism);
  const std::vector<Degree> qd(static_cast<std::size_t>(mechanism.size()), drawn), rates(q.size(), drawn);
  Lagrangian<Degree> lagrangian(mechanism_over(mechanism, arithmetic), q);
  const Energies<Degree> written =
      WrittenEnergies<DegreeArithmetic>(robot, lagrangian.mechanism(), arithmetic, q, rates, mechanism.offsets).sum();
  const Degree largest =
      lagrangian.kinetic_energy(qd) + lagrangian.potential_energy() + written.kinetic + written.potential;
  const double angles = static_cast<double>(mechanism.position_count()) + static_cast<double>(mechanism.symbols.size());
  return in_drawn_values(largest.value(), angles, arithmetic.reciprocals);
}

MechanismDegrees regressor_degrees(const Mechanism& mechanism) {
  DegreeArithmetic arithmetic;
  const Degree drawn = Degree::of(1);
  const auto n = static_cast<std::size_t>(mechanism.size());
  const auto bodies = static_cast<std::size_t>(mechanism.body_count());
  const LagrangianRegressor<Degree> lagrangian(mechanism_with_drawn_gravity(mechanism, arithmetic),
                                               joint_degrees(mechanism));
  const std::vector<Degree> rates(n, drawn), signs(bodies, drawn);
  Degree largest, factor = drawn;
  const Matrix<Degree> Y = lagrangian.adaptive(rates, rates, accelerations_of_coordinates(mechanism), signs);
  for (const Degree& entry : Y.entries()) largest += entry;
  const NumberMap<DegreeArithmetic> number(mechanism.symbols, arithmetic);
  const BaseParameters base = base_parameters(mechanism);
  for (const ParameterForm& form : base.combination) {
    for (const auto& [index, coefficient] : form) factor += number(coefficient);
  }
  return {(largest * factor).value(), arithmetic.reciprocals + degree_of_dry_friction(mechanism)};
}

FunctionDegrees function_degrees(const Function& function) {
  RationalDegreeArithmetic arithmetic;
  const std::vector<RationalDegree> values = evaluate(function, arithmetic);
  RationalDegree all;
  for (const NodeId root : roots(function)) all += values[static_cast<std::size_t>(root)];
  FunctionDegrees result{all.numerator, 0};
  for (const auto& [k, exponent] : all.exponents) result.denominator += exponent * arithmetic.denominators()[k];
  return result;
}

// A value with square roots is a polynomial A + B r with r² = f; it vanishes where A² = B² f does, which has twice its
// degree. Moreover, points are drawn until f has a root, which it has at half of them.
double root_factor(const Function& function) {
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    if (function.graph[id].op == Op::sqrt) return 4;
  }
  return 1;
}

double drawn_angles(const Function& function, const Mechanism& mechanism) {
  double count = static_cast<double>(mechanism.position_count()) + static_cast<double>(mechanism.symbols.size());
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const Op op = function.graph[id].op;
    if (op == Op::sin || op == Op::cos) count += 1;
  }
  return count;
}

}  // namespace flatdyn
