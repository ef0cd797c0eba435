// SPDX-License-Identifier: GPL-2.0-or-later
// A Mechanism whose numbers are elements of a field: real numbers, or integers modulo a prime.
#pragma once

#include <optional>
#include <vector>

#include "graph/graph.hpp"
#include "robot/model/field_vector.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {

template <class F>
struct FieldInertia {
  F mass;
  Vector3<F> first_moment;
  Matrix3<F> inertia;
};

template <class F>
struct FieldRotor {
  int carrier;
  F gear_ratio, inertia;
  Vector3<F> axis;
};

template <class F>
struct FieldFrame {
  int body;
  Matrix3<F> R;
  Vector3<F> p;
};

template <class F>
struct FieldDryFriction {
  F speed, offset, at_rest, excess, stribeck_speed, asymmetry, load;
  bool is_smooth = false, has_excess = false;
};

template <class F>
struct FieldBody {
  int parent;
  bool prismatic;
  Matrix3<F> R;  // rotation in the parent's frame while the joint is at zero, with that of a spherical joint
  Vector3<F> p;
  FieldInertia<F> inertia;
  std::optional<FieldRotor<F>> rotor;
  F armature, viscous, coulomb;
  F stiffness, spring_reference;
  FieldDryFriction<F> dry;
};

template <class F>
struct FieldLoop {
  int bodies[2];
  Vector3<F> points[2];
  int carrier;
  Matrix3<F> axes;
  int components;
  Vector3<F> across[2], axis;
  std::vector<std::size_t> rows;
  std::vector<int> dependent;
};

template <class F>
struct MechanismOver {
  std::vector<FieldBody<F>> bodies;
  std::vector<FieldFrame<F>> links;
  FieldFrame<F> tip;
  Vector3<F> gravity;
  FieldInertia<F> base;
  std::vector<std::vector<F>> coupling;  // by body and entry of q̇; empty: q_i is the position of body i's joint
  // With closed loops, `coupling` holds at one position and has a column for each entry of q̇; `tree_coupling` has one
  // for each entry of q. The first entries of q̇, and the first bodies, are the motion of a floating base.
  int base_bodies = 0;
  std::vector<FieldLoop<F>> loops;
  std::vector<int> independent;
  std::vector<std::vector<F>> tree_coupling;
  std::vector<FieldFrame<F>> contacts;

  bool is_coupled() const { return !coupling.empty(); }
  bool has_loops() const { return !loops.empty(); }
  // Entries of q, with closed loops.
  int position_count() const { return static_cast<int>(tree_coupling.front().size()); }
  int body_count() const { return static_cast<int>(bodies.size()); }
  int size() const { return is_coupled() ? static_cast<int>(coupling.front().size()) : body_count(); }  // entries of q̇
};

// The rates or accelerations of all joints from those of the coordinates: Σ_k coupling[i][k] q_k for every body i.
template <class F>
std::vector<F> joint_values(const MechanismOver<F>& mechanism, const std::vector<F>& coordinates) {
  if (!mechanism.is_coupled()) return coordinates;
  std::vector<F> result;
  for (const std::vector<F>& row : mechanism.coupling) {
    F sum = F(0);
    for (std::size_t k = 0; k < row.size(); ++k) sum += row[k] * coordinates[k];
    result.push_back(sum);
  }
  return result;
}

// Aᵀ M, where A is the coupling and M has a row for every body.
template <class F>
Matrix<F> rows_at_coordinates(const MechanismOver<F>& mechanism, const Matrix<F>& M) {
  if (!mechanism.is_coupled()) return M;
  Matrix<F> result(mechanism.size(), M.cols());
  for (int k = 0; k < result.rows(); ++k) {
    for (int i = 0; i < M.rows(); ++i) {
      const F& factor = mechanism.coupling[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      for (int j = 0; j < M.cols(); ++j) result(k, j) += factor * M(i, j);
    }
  }
  return result;
}

// M A, where A is the coupling and M has a column for every body.
template <class F>
Matrix<F> columns_at_coordinates(const MechanismOver<F>& mechanism, const Matrix<F>& M) {
  if (!mechanism.is_coupled()) return M;
  Matrix<F> result(M.rows(), mechanism.size());
  for (int i = 0; i < M.rows(); ++i) {
    for (int j = 0; j < M.cols(); ++j) {
      for (int k = 0; k < result.cols(); ++k) {
        result(i, k) += M(i, j) * mechanism.coupling[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
      }
    }
  }
  return result;
}

// Aᵀ M A, where A is the coupling: the matrix M of the bodies' joints at the coordinates.
template <class F>
Matrix<F> at_coordinates(const MechanismOver<F>& mechanism, const Matrix<F>& M) {
  return columns_at_coordinates(mechanism, rows_at_coordinates(mechanism, M));
}

// Aᵀ τ, where A is the coupling: the joint torques τ at the coordinates.
template <class F>
std::vector<F> at_coordinates(const MechanismOver<F>& mechanism, const std::vector<F>& tau) {
  if (!mechanism.is_coupled()) return tau;
  return rows_at_coordinates(mechanism, Matrix<F>(1, tau)).entries();
}

Rational to_rational(const Number& a);  // throws Failure(unsupported) if a is not rational
Number to_number(const Rational& a);

// A sum of multiples of free symbols and a constant as a node of `graph`, with the symbols as inputs of kind parameter.
// Throws Failure(unsupported) for any other expression.
NodeId linear_angle(const Number& angle, const std::vector<FreeSymbol>& symbols, Graph& graph);

// The index of a symbol among the robot's free symbols. Throws Failure(bug) if it is not one of them.
int index_of(const Number& symbol, const std::vector<FreeSymbol>& symbols);

[[noreturn]] void cannot_map(const Number& a);

// Maps a Number to the field by an Arithmetic as evaluate() takes it, so that a free symbol, and its sine, has the same
// value here as in any Graph.
template <class Arithmetic>
class NumberMap {
 public:
  using F = typename Arithmetic::Scalar;

  NumberMap(const std::vector<FreeSymbol>& symbols, Arithmetic& arithmetic)
      : symbols_(symbols), arithmetic_(arithmetic) {}

  F operator()(const Number& a) const {
    if (GiNaC::is_a<GiNaC::numeric>(a)) return arithmetic_.constant(to_rational(a));
    if (GiNaC::is_a<GiNaC::symbol>(a)) return arithmetic_.input({InputKind::parameter, index_of(a, symbols_)});
    if (GiNaC::is_a<GiNaC::add>(a)) return folded(a, F(0), [](F& total, const F& next) { total += next; });
    if (GiNaC::is_a<GiNaC::mul>(a)) return folded(a, F(1), [](F& total, const F& next) { total = total * next; });
    if (GiNaC::is_a<GiNaC::power>(a)) return power(a);
    if (GiNaC::is_a<GiNaC::function>(a)) return value_of_function(a);
    cannot_map(a);
  }

 private:
  template <class Join>
  F folded(const Number& a, F total, Join join) const {
    for (const Number& operand : a) join(total, (*this)(operand));
    return total;
  }

  F power(const Number& a) const {
    if (!a.op(1).info(GiNaC::info_flags::integer)) cannot_map(a);
    const int exponent = GiNaC::ex_to<GiNaC::numeric>(a.op(1)).to_int();
    const F base = (*this)(a.op(0));
    F result = F(1);
    for (int k = 0; k < std::abs(exponent); ++k) result = result * base;
    return exponent < 0 ? arithmetic_.divide(F(1), result) : result;
  }

  F value_of_function(const Number& a) const {
    const std::string name = GiNaC::ex_to<GiNaC::function>(a).get_name();
    if (name == "tanh") return tanh_in(arithmetic_, (*this)(a.op(0)));
    Graph graph;
    const NodeId angle = linear_angle(a.op(0), symbols_, graph);
    if (name == "sin") return arithmetic_.sin(graph, angle, (*this)(a.op(0)));
    if (name == "cos") return arithmetic_.cos(graph, angle, (*this)(a.op(0)));
    cannot_map(a);
  }

  const std::vector<FreeSymbol>& symbols_;
  Arithmetic& arithmetic_;
};

template <class Arithmetic>
class MechanismMap {
 public:
  using F = typename Arithmetic::Scalar;

  MechanismMap(const Mechanism& mechanism, Arithmetic& arithmetic)
      : mechanism_(mechanism), arithmetic_(arithmetic), number_(mechanism.symbols, arithmetic) {}

  // Spherical joints are part of the bodies' rotations, at the positions that the arithmetic draws.
  MechanismOver<F> operator()() const {
    MechanismOver<F> result;
    for (const Body& body : mechanism_.bodies) result.bodies.push_back(mapped(body));
    for (const int first : mechanism_.spherical) turn(first, result.bodies[static_cast<std::size_t>(first)].R);
    for (const LinkFrame& link : mechanism_.links) result.links.push_back(mapped(link));
    result.tip = mapped(mechanism_.tip);
    for (const Contact& contact : mechanism_.contacts) result.contacts.push_back(mapped(contact.frame));
    result.gravity = mapped(mechanism_.gravity);
    result.base = mapped(mechanism_.base);
    result.coupling = mapped(mechanism_.rate_coupling());
    result.base_bodies = mechanism_.base_bodies();
    for (const LoopClosure& loop : mechanism_.loops) result.loops.push_back(mapped(loop));
    result.independent = mechanism_.independent;
    if (mechanism_.has_loops()) result.tree_coupling = mapped(mechanism_.coupling);
    return result;
  }

 private:
  std::vector<std::vector<F>> mapped(const Rows& rows) const {
    std::vector<std::vector<F>> result;
    for (const std::vector<Number>& row : rows) {
      result.emplace_back();
      for (const Number& each : row) result.back().push_back(number_(each));
    }
    return result;
  }
  Vector3<F> mapped(const Vec3& v) const { return {number_(v[0]), number_(v[1]), number_(v[2])}; }
  Matrix3<F> mapped(const Mat3& m) const { return {mapped(m[0]), mapped(m[1]), mapped(m[2])}; }
  FieldInertia<F> mapped(const InertialParameters& a) const {
    return {number_(a.mass), mapped(a.first_moment), mapped(a.inertia)};
  }
  FieldFrame<F> mapped(const LinkFrame& a) const { return {a.body, mapped(a.R), mapped(a.p)}; }
  FieldLoop<F> mapped(const LoopClosure& a) const {
    return {{a.ends[0].body, a.ends[1].body},
            {mapped(a.ends[0].p), mapped(a.ends[1].p)},
            a.carrier,
            mapped(a.axes),
            a.components,
            {mapped(a.across[0]), mapped(a.across[1])},
            mapped(a.axis),
            a.rows,
            a.dependent};
  }

  // Rz(beta) Rx(alpha) Rz(theta), multiplied in the field.
  Matrix3<F> rotation(const Body& body) const {
    const auto about_z = [this](const PlanarRotation& a) {
      return mapped(Mat3{Vec3{a.c, -a.s, 0}, Vec3{a.s, a.c, 0}, Vec3{0, 0, 1}});
    };
    const PlanarRotation& a = body.alpha;
    const Matrix3<F> about_x = mapped(Mat3{Vec3{1, 0, 0}, Vec3{0, a.c, -a.s}, Vec3{0, a.s, a.c}});
    return times(times(about_z(body.beta), about_x), about_z(body.theta));
  }

  // Adds the rotation of a spherical joint at the position that the arithmetic draws, and the constant one after it.
  void turn(int first, Matrix3<F>& R) const {
    const int q = mechanism_.quaternion_of(first);
    const auto entry = [&](int k) { return arithmetic_.input({InputKind::q, q + k}); };
    R = with_columns_cycled(times(R, rotation_of_quaternion<F>({entry(0), entry(1), entry(2), entry(3)})));
  }

  FieldDryFriction<F> mapped(const DryFriction& dry) const {
    return {number_(dry.speed),
            number_(dry.offset),
            number_(dry.at_rest),
            number_(dry.excess),
            number_(dry.stribeck_speed),
            number_(dry.asymmetry),
            number_(dry.load),
            dry.is_smooth(),
            dry.has_excess()};
  }

  FieldBody<F> mapped(const Body& body) const {
    FieldBody<F> result{body.parent,
                        body.prismatic,
                        rotation(body),
                        mapped(body.p),
                        mapped(body.inertia),
                        std::nullopt,
                        number_(body.armature),
                        number_(body.viscous),
                        number_(body.coulomb),
                        number_(body.stiffness),
                        number_(body.spring_reference),
                        mapped(body.dry)};
    if (body.rotor) {
      result.rotor = FieldRotor<F>{body.rotor->carrier, number_(body.rotor->gear_ratio), number_(body.rotor->inertia),
                                   mapped(body.rotor->axis)};
    }
    return result;
  }

  const Mechanism& mechanism_;
  Arithmetic& arithmetic_;
  NumberMap<Arithmetic> number_;
};

// The mechanism over the field of the arithmetic.
template <class Arithmetic>
MechanismOver<typename Arithmetic::Scalar> mechanism_over(const Mechanism& mechanism, Arithmetic& arithmetic) {
  return MechanismMap<Arithmetic>(mechanism, arithmetic)();
}

}  // namespace flatdyn
