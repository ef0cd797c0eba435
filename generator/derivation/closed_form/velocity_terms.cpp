// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/closed_form/velocity_terms.hpp"

#include <algorithm>
#include <utility>

#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The rate of a function of the joint's angles and slide by its coordinate, with ∂c/∂q = -s and ∂s/∂q = c. A coordinate
// that turns one joint may move another, prismatic one.
Number rate_by_coordinate(const Number& function, int joint, const Mechanism& mechanism, const ClosedForm& form) {
  const auto turned = [&](int angle) {
    const GiNaC::symbol &c = form.c[at(angle)], &s = form.s[at(angle)];
    return c * function.diff(s) - s * function.diff(c);
  };
  Number result = turned(joint) + function.diff(form.d[at(joint)]);
  for (std::size_t a = 0; a < mechanism.angles.size(); ++a) {
    const CoordinateMultiple& angle = mechanism.angles[a];
    if (angle.position == joint) result += angle.factor * turned(joint_count(mechanism) + static_cast<int>(a));
  }
  return result;
}

// The rates of (w, x, y, z) for a unit angular velocity about one of the child's axes: those of ½ q (0, ω).
std::array<Number, 4> quaternion_rates(const ClosedForm::Quaternion& q, int axis) {
  const Number half(GiNaC::numeric(1, 2)), w = half * q[0], x = half * q[1], y = half * q[2], z = half * q[3];
  if (axis == 0) return {-x, w, z, -y};
  if (axis == 1) return {-y, -z, w, x};
  return {-z, y, -x, w};
}

Number rate_by_turn(const Number& function, const ClosedForm::Quaternion& q, int axis) {
  const std::array<Number, 4> rates = quaternion_rates(q, axis);
  Number result = 0;
  for (std::size_t k = 0; k < q.size(); ++k) result += rates[k] * function.diff(q[k]);
  return result;
}

// A term of s_k(v, p): sign v_i p_l.
struct TurningTerm {
  int velocity = 0, momentum = 0, sign = 1;
};
using TurningTerms = std::vector<std::vector<TurningTerm>>;  // by equation

// Adds a × b to three equations, a and b being three entries each.
void add_cross(TurningTerms& terms, int equation, int a, int b) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    terms[at(equation + k)].push_back({a + i, b + j, 1});
    terms[at(equation + k)].push_back({a + j, b + i, -1});
  }
}

TurningTerms turning_terms(const Mechanism& mechanism) {
  constexpr int kLinear = 0, kAngular = 3;
  TurningTerms terms(at(mechanism.size()));
  if (mechanism.floating_base) {
    add_cross(terms, kLinear, kAngular, kLinear);
    add_cross(terms, kAngular, kAngular, kAngular);
    add_cross(terms, kAngular, kLinear, kLinear);
  }
  for (const int first : mechanism.spherical) add_cross(terms, first, first, first);
  return terms;
}

}  // namespace

Number rate_along(const Number& function, int k, const Mechanism& mechanism, const ClosedForm& form) {
  if (k < mechanism.base_bodies()) return 0;
  const int part = mechanism.joint(k).spherical;
  if (part == 0) return rate_by_coordinate(function, form.joints[at(k)], mechanism, form);
  const auto first = std::find(mechanism.spherical.begin(), mechanism.spherical.end(), k + 1 - part);
  return rate_by_turn(function, form.quaternions[at(static_cast<int>(first - mechanism.spherical.begin()))], part - 1);
}

std::vector<VelocityProducts> velocity_terms(const Mechanism& mechanism, const ClosedForm& form) {
  const int n = mechanism.size();
  std::vector<Rows> db;  // X_k b_ij
  for (int k = 0; k < n; ++k) {
    db.emplace_back(at(n), std::vector<Number>(at(n), 0));
    for (int i = 0; i < n; ++i) {
      for (int j = i; j < n; ++j) {
        db.back()[at(i)][at(j)] = db.back()[at(j)][at(i)] =
            reduced(rate_along(form.B[at(i)][at(j)], k, mechanism, form), form);
      }
    }
  }
  const TurningTerms turning = turning_terms(mechanism);
  std::vector<VelocityProducts> h;
  for (int k = 0; k < n; ++k) {
    VelocityProducts products;
    for (int i = 0; i < n; ++i) {
      products[{i, i}] += db[at(i)][at(k)][at(i)] - db[at(k)][at(i)][at(i)] / 2;
      for (int j = i + 1; j < n; ++j) {
        products[{i, j}] += db[at(i)][at(k)][at(j)] + db[at(j)][at(k)][at(i)] - db[at(k)][at(i)][at(j)];
      }
    }
    for (const TurningTerm& term : turning[at(k)]) {
      for (int j = 0; j < n; ++j) {
        products[std::minmax(term.velocity, j)] += term.sign * form.B[at(term.momentum)][at(j)];
      }
    }
    for (auto& product : products) product.second = product.second.expand();
    std::erase_if(products, [](const auto& product) { return product.second.is_zero(); });
    h.push_back(std::move(products));
  }
  return h;
}

}  // namespace flatdyn
