// SPDX-License-Identifier: GPL-2.0-or-later
// The sum over bodies in (7.32) is taken from the tips inwards, in link frames: with joints k+1 … n held still, joint k
// and its descendants are one augmented link, and b_jk is the product of column j of that link's Jacobian with the
// link's momentum at a unit rate of joint k. The column depends on q_{j+1} … q_k only, the momentum on q_{k+1} … q_n
// only, so hardly any terms cancel.
#include "derivation/closed_form/closed_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/closed_form/velocity_terms.hpp"
#include "derivation/kernel/axis_rotations.hpp"
#include "derivation/kernel/jacobian_column.hpp"
#include "robot/model/angles.hpp"
#include "robot/model/rational_rotation.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

Vec3 expanded_vector(const Vec3& v) { return {v[0].expand(), v[1].expand(), v[2].expand()}; }

// Rz T Rzᵀ for symmetric T, with s² already replaced by 1 - c².
Mat3 rotate_z(const PlanarRotation& a, const Mat3& T) {
  const Number shift = a.c * a.c * (T[0][0] - T[1][1]) - 2 * a.c * a.s * T[0][1];
  Mat3 result = T;
  result[0][0] = T[1][1] + shift;
  result[1][1] = T[0][0] - shift;
  result[0][1] = result[1][0] = a.c * a.s * (T[0][0] - T[1][1]) + (2 * a.c * a.c - 1) * T[0][1];
  const Vec3 column = rotate_z(a, Vec3{T[0][2], T[1][2], 0});
  result[0][2] = result[2][0] = column[0];
  result[1][2] = result[2][1] = column[1];
  for (Vec3& row : result) row = expanded_vector(row);
  return result;
}
Mat3 rotate_x(const PlanarRotation& a, const Mat3& T) {
  return with_axes_cycled(with_axes_cycled(rotate_z(a, with_axes_cycled(T))));
}

class Lagrange {
 public:
  Lagrange(const Mechanism& mechanism, std::size_t most_terms) : mechanism_(mechanism), most_terms_(most_terms) {
    const auto n = at(mechanism.body_count());
    add_symbols();
    for (int i = 0; i < mechanism.body_count(); ++i) {
      const bool is_still = mechanism.is_around_pose(i), slides = mechanism.bodies[at(i)].prismatic;
      angle_.push_back(slides || is_still ? PlanarRotation{} : turn_of_joint(i));
      slide_.push_back(slides && !is_still ? slide_of_joint(i) : Number(0));
      composite_.push_back(mechanism.bodies[at(i)].inertia);
    }
    form_.B.assign(n, std::vector<Number>(n, 0));
    form_.g.assign(n, 0);
  }

  ClosedForm run() {
    for (int i = 0; i < mechanism_.body_count(); ++i) add_columns(i);
    for (int k = mechanism_.body_count() - 1; k >= 0; --k) {
      add_momentum_products(k);
      refuse_long_matrices();
      gather(k);
    }
    for (int i = 0; i < mechanism_.body_count(); ++i) add_rotor(i);
    if (mechanism_.is_coupled()) gather_at_coordinates();
    reduce_all();
    if (mechanism_.has_quasi_velocities()) {
      form_.h = velocity_terms(mechanism_, form_);
    } else {
      add_christoffel_symbols();
    }
    return std::move(form_);
  }

 private:
  const Body& body(int i) const { return mechanism_.bodies[at(i)]; }

  void add_symbols() {
    form_.joints = joints_of_entries(mechanism_);
    const int joints = joint_count(mechanism_);
    for (int k = 0; k < joints; ++k) form_.d.emplace_back("d_" + std::to_string(k + 1));
    for (int k = 0; k < joints + static_cast<int>(mechanism_.angles.size()); ++k) {
      form_.c.emplace_back("c_" + std::to_string(k + 1));
      form_.s.emplace_back("s_" + std::to_string(k + 1));
    }
    for (const int first : mechanism_.spherical) {
      const std::string n = "_" + std::to_string(form_.joints[at(first)] + 1);
      form_.quaternions.push_back(
          {GiNaC::symbol("w" + n), GiNaC::symbol("x" + n), GiNaC::symbol("y" + n), GiNaC::symbol("z" + n)});
      const ClosedForm::Quaternion& q = form_.quaternions.back();
      free_[first] = with_columns_cycled(rotation_of_quaternion<Number>({q[0], q[1], q[2], q[3]}));
    }
    if (!mechanism_.has_base_gravity()) return;
    for (const char* const name : {"g_x", "g_y", "g_z"}) form_.g_b.emplace_back(name);
  }

  // The multiples of coordinates by which joint i moves.
  std::vector<Number> factors_of(int i) const {
    if (mechanism_.is_coupled()) return mechanism_.coupling[at(i)];
    std::vector<Number> own(form_.d.size(), 0);
    own[at(form_.joints[at(i)])] = 1;
    return own;
  }

  Number slide_of_joint(int i) const {
    const std::vector<Number> factors = factors_of(i);
    Number sum = 0;
    for (std::size_t k = 0; k < factors.size(); ++k) sum += factors[k] * form_.d[k];
    return sum;
  }

  // The cosine and sine of joint i's angle, a sum of multiples, by the addition theorems.
  PlanarRotation turn_of_joint(int i) const {
    const std::vector<Number> turns = mechanism_.is_coupled() ? angle_factors(mechanism_, i) : factors_of(i);
    PlanarRotation total;
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const int times = GiNaC::ex_to<GiNaC::numeric>(turns[k]).to_int();
      const PlanarRotation step{form_.c[k], times < 0 ? Number(-form_.s[k]) : Number(form_.s[k])};
      for (int turn = 0; turn < std::abs(times); ++turn) total = total * step;
    }
    return {total.c.expand(), total.s.expand()};
  }

  // Replaces B and g by Aᵀ B A and Aᵀ g, where A is the coupling.
  void gather_at_coordinates() {
    const auto n = at(mechanism_.size());
    const Rows A = mechanism_.rate_coupling();
    Rows B(n, std::vector<Number>(n, 0));
    std::vector<Number> g(n, 0);
    for (std::size_t r = 0; r < A.size(); ++r) {
      for (std::size_t k = 0; k < n; ++k) {
        g[k] += A[r][k] * form_.g[r];
        for (std::size_t t = 0; t < A.size(); ++t) {
          for (std::size_t l = 0; l < n; ++l) B[k][l] += A[r][k] * A[t][l] * form_.B[r][t];
        }
      }
    }
    form_.B = std::move(B);
    form_.g = std::move(g);
  }

  // The displacement of frame i in its parent's frame, including the slide of a prismatic joint.
  Vec3 displacement(int i) const {
    const Body& b = body(i);
    if (!b.prismatic) return b.p;
    return b.p + rotate_z(b.beta, rotate_x(b.alpha, Vec3{0, 0, slide_[at(i)]}));
  }

  // A free vector of the parent, rotated to frame i by the transpose of Rz(beta) Rx(alpha) Rz(theta) Rz(q).
  Vec3 to_child(int i, const Vec3& v) const {
    const Body& b = body(i);
    const Vec3 fixed =
        expanded_vector(rotate_z(inverse(b.theta), rotate_x(inverse(b.alpha), rotate_z(inverse(b.beta), v))));
    if (b.prismatic) return fixed;
    if (b.spherical == 1) return reduced_vector(transpose(free_.at(i)) * fixed);
    return expanded_vector(rotate_z(inverse(angle_[at(i)]), fixed));
  }

  Vec3 reduced_vector(const Vec3& v) const {
    return {reduced(v[0], form_), reduced(v[1], form_), reduced(v[2], form_)};
  }

  // A vector or symmetric tensor of a spherical joint's first frame, as the joint turns it.
  Vec3 turned_freely(int i, const Vec3& v) const { return reduced_vector(free_.at(i) * v); }
  Mat3 turned_freely(int i, const Mat3& T) const {
    Mat3 half = T * transpose(free_.at(i));
    for (Vec3& row : half) row = reduced_vector(row);
    Mat3 result = free_.at(i) * half;
    for (Vec3& row : result) row = reduced_vector(row);
    return result;
  }

  template <class Quantity>  // a vector or symmetric tensor of frame i, in its parent's axes
  Quantity to_parent(int i, Quantity v) const {
    const Body& b = body(i);
    if (b.spherical == 1) {
      v = turned_freely(i, v);
    } else if (!b.prismatic) {
      v = rotate_z(angle_[at(i)], v);
    }
    return rotate_z(b.beta, rotate_x(b.alpha, rotate_z(b.theta, v)));
  }

  // Adds the columns j of the Jacobians of frame i, in its own axes, for all joints between it and the base: (7.18),
  // (7.19).
  void add_columns(int i) {
    std::map<int, JacobianColumn> columns;
    if (body(i).parent >= 0) {
      const Vec3 p = displacement(i);
      for (const auto& [j, column] : columns_[at(body(i).parent)]) {
        columns[j] = {to_child(i, column.linear + cross(column.angular, p)), to_child(i, column.angular)};
      }
    }
    JacobianColumn& own = columns[i];
    (body(i).prismatic ? own.linear : own.angular) = {0, 0, 1};
    columns_.push_back(std::move(columns));

    // The direction of gravity is rotated likewise: g_k = -g_0ᵀ J_P summed over the composite link, (7.39).
    gravity_.push_back(to_child(i, body(i).parent < 0 ? gravity_of_base() : gravity_[at(body(i).parent)]));
  }

  Vec3 gravity_of_base() const {
    if (form_.g_b.empty()) return mechanism_.gravity;
    return {form_.g_b[0], form_.g_b[1], form_.g_b[2]};
  }

  void add_momentum_products(int k) {
    const InertialParameters& link = composite_[at(k)];
    const JacobianColumn& own = columns_[at(k)].at(k);
    const JacobianColumn momentum{link.mass * own.linear + cross(own.angular, link.first_moment),
                                  link.inertia * own.angular + cross(link.first_moment, own.linear)};
    for (const auto& [j, column] : columns_[at(k)]) {
      const Number b = (dot(column.linear, momentum.linear) + dot(column.angular, momentum.angular)).expand();
      form_.B[at(j)][at(k)] = form_.B[at(k)][at(j)] = b;
      terms_ += b.nops();
    }
    form_.g[at(k)] = (-dot(gravity_[at(k)], momentum.linear)).expand();
  }

  // The terms in products of velocities, which are ten times as many, would take minutes.
  void refuse_long_matrices() const {
    if (!mechanism_.has_quasi_velocities() || terms_ <= most_terms_) return;
    throw Failure(
        FailureKind::unsupported,
        fmt::format("the closed form is too long: B alone has more than {} terms", most_terms_),
        "flatdyn generate makes code of such robots; with --base fixed, fewer joints or joints at right angles "
        "it is shorter");
  }

  // Adds the composite link i to its parent's.
  void gather(int i) {
    const int parent = body(i).parent;
    if (parent < 0) return;
    const InertialParameters& link = composite_[at(i)];
    const InertialParameters turned{link.mass, expanded_vector(to_parent(i, link.first_moment)),
                                    to_parent(i, link.inertia)};
    composite_[at(parent)] = composite_[at(parent)] + transformed(turned, identity_matrix(), displacement(i));
  }

  // Adds the spinning rotor of joint i, the last two terms of (7.64), and the armature.
  void add_rotor(int i) {
    Number& own = form_.B[at(i)][at(i)];
    own += body(i).armature;
    if (!body(i).rotor) return;
    const Rotor& rotor = *body(i).rotor;
    own += rotor.gear_ratio * rotor.gear_ratio * rotor.inertia;
    if (rotor.carrier < 0) return;
    for (const auto& [j, column] : columns_[at(rotor.carrier)]) {
      const Number b = rotor.gear_ratio * rotor.inertia * dot(rotor.axis, column.angular);
      form_.B[at(i)][at(j)] += b;
      form_.B[at(j)][at(i)] += b;
    }
  }

  void reduce_all() {
    for (std::size_t i = 0; i < form_.B.size(); ++i) {
      form_.g[i] = reduced(form_.g[i], form_);
      for (std::size_t j = 0; j <= i; ++j) form_.B[i][j] = form_.B[j][i] = reduced(form_.B[i][j], form_);
    }
  }

  void add_christoffel_symbols() {
    const int n = mechanism_.size();
    form_.c_ijk.assign(at(n), std::vector<Number>(at(n * (n + 1) / 2), 0));
    // ∂b_ij/∂q_k for i <= j; in a tree it is zero unless joint k comes after joint i.
    std::vector<Rows> db(at(n));
    for (int k = 0; k < n; ++k) {
      db[at(k)].assign(at(n), std::vector<Number>(at(n), 0));
      for (int i = 0; i < (mechanism_.is_coupled() ? n : k); ++i) {
        for (int j = i; j < n; ++j) {
          db[at(k)][at(i)][at(j)] = db[at(k)][at(j)][at(i)] =
              reduced(rate_along(form_.B[at(i)][at(j)], k, mechanism_, form_), form_);
        }
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        for (int j = 0; j <= k; ++j) {
          const Number twice = db[at(k)][at(i)][at(j)] + db[at(j)][at(i)][at(k)] - db[at(i)][at(j)][at(k)];
          form_.c_ijk[at(i)][at(k * (k + 1) / 2 + j)] = (twice / 2).expand();
        }
      }
    }
  }

  const Mechanism& mechanism_;
  ClosedForm form_;
  std::vector<PlanarRotation> angle_;  // by body: its joint's angle
  std::vector<Number> slide_;
  std::map<int, Mat3> free_;  // by the first body of a spherical joint: its rotation
  std::vector<std::map<int, JacobianColumn>> columns_;
  std::vector<Vec3> gravity_;
  std::vector<InertialParameters> composite_;
  std::size_t most_terms_;
  std::size_t terms_ = 0;  // about as many as B has so far
};

// An expression that a factor's square is replaced by: 1 - c_i² for s_i, 1 - cos(x)² for sin(x), 1 - x² - y² - z² for w
// of a quaternion; 0 if it stays.
Number square_of(const Number& factor, const ClosedForm& form) {
  if (GiNaC::is_a<GiNaC::symbol>(factor)) {
    const auto& symbol = GiNaC::ex_to<GiNaC::basic>(factor);
    for (std::size_t i = 0; i < form.s.size(); ++i) {
      if (form.s[i].is_equal(symbol)) return 1 - form.c[i] * form.c[i];
    }
    for (const auto& [w, x, y, z] : form.quaternions) {
      if (w.is_equal(symbol)) return 1 - x * x - y * y - z * z;
    }
    return 0;
  }
  const bool is_sine =
      GiNaC::is_a<GiNaC::function>(factor) && GiNaC::ex_to<GiNaC::function>(factor).get_name() == "sin";
  return is_sine ? Number(1 - GiNaC::cos(factor.op(0)) * GiNaC::cos(factor.op(0))) : Number(0);
}

// A factor of a term with powers of sines and of w reduced; `changed` is set if it was such a power.
Number reduced_factor(const Number& factor, const ClosedForm& form, bool& changed) {
  if (!GiNaC::is_a<GiNaC::power>(factor) || !factor.op(1).info(GiNaC::info_flags::posint)) return factor;
  const Number square = square_of(factor.op(0), form);
  if (square.is_zero()) return factor;
  const int exponent = GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int();
  changed = true;
  return GiNaC::pow(square, exponent / 2) * GiNaC::pow(factor.op(0), exponent % 2);
}

Number reduced_term(const Number& term, const ClosedForm& form, bool& changed) {
  if (!GiNaC::is_a<GiNaC::mul>(term)) return reduced_factor(term, form, changed);
  bool here = false;
  Number product = 1;
  for (const Number& factor : term) product *= reduced_factor(factor, form, here);
  if (!here) return term;
  changed = true;
  return product;
}

}  // namespace

int joint_count(const Mechanism& mechanism) {
  return mechanism.position_count() - kSphericalBodies * static_cast<int>(mechanism.spherical.size());
}

std::vector<int> joints_of_entries(const Mechanism& mechanism) {
  std::vector<int> joints;
  int next = 0;
  for (int k = 0; k < mechanism.size(); ++k) {
    const bool is_of_base = k < mechanism.base_bodies();
    joints.push_back(is_of_base ? -1 : next);
    if (!is_of_base && !is_inside_joint(mechanism.joint(k))) ++next;
  }
  return joints;
}

const Number& ClosedForm::christoffel(int i, int j, int k) const {
  if (j > k) std::swap(j, k);
  return c_ijk[at(i)][at(k * (k + 1) / 2 + j)];
}

Number reduced(const Number& expression, const ClosedForm& form) {
  const Number expanded = expression.expand();
  bool changed = false;
  if (!GiNaC::is_a<GiNaC::add>(expanded)) {
    const Number term = reduced_term(expanded, form, changed);
    return changed ? term.expand() : expanded;
  }
  GiNaC::exvector terms;
  for (const Number& term : expanded) terms.push_back(reduced_term(term, form, changed));
  return changed ? Number(GiNaC::add(terms)).expand() : expanded;
}

ClosedForm closed_form(const Mechanism& mechanism, std::size_t most_terms) {
  return Lagrange(mechanism, most_terms).run();
}

}  // namespace flatdyn
