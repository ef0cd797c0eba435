// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/kernel/regroup.hpp"

#include <algorithm>
#include <optional>

#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

Number movable_inertia(const Mat3& I, Grouping grouping) {
  switch (grouping) {
    case Grouping::i_yy:
      return I[1][1];
    case Grouping::i_xx:
      return I[0][0];
    case Grouping::sigma_zz:
      return ((I[0][0] + I[1][1] - I[2][2]) / 2).expand();
    case Grouping::none:
      break;
  }
  return 0;
}

// The part of link i that may as well be fixed to its parent. Revolute: the part that is symmetric about z and that the
// joint's own rate does not move, i.e. a mass, a first moment along z, a transverse inertia. Prismatic: the inertia
// tensor, because the link does not turn relative to its parent. Spherical: the mass, at the joint's point.
InertialParameters movable(const Body& body, Grouping grouping) {
  InertialParameters part;
  if (body.prismatic) {
    part.inertia = body.inertia.inertia;
    return part;
  }
  part.mass = body.inertia.mass;
  if (body.spherical > 0) return part;
  part.first_moment[2] = body.inertia.first_moment[2];
  part.inertia[0][0] = part.inertia[1][1] = movable_inertia(body.inertia.inertia, grouping);
  return part;
}

InertialParameters negative(const InertialParameters& a) {
  InertialParameters result{-a.mass, Number(-1) * a.first_moment, a.inertia};
  for (Vec3& row : result.inertia) row = Number(-1) * row;
  return result;
}

std::size_t entry_of(Balance balance) { return balance == Balance::x ? 0 : 1; }

// The mass of every body with all its descendants.
std::vector<Number> carried_masses(const Mechanism& mechanism) {
  std::vector<Number> masses;
  for (const Body& body : mechanism.bodies) masses.push_back(body.inertia.mass);
  for (std::size_t i = masses.size(); i-- > 0;) {
    const int parent = mechanism.bodies[i].parent;
    if (parent >= 0) masses[static_cast<std::size_t>(parent)] += masses[i];
  }
  return masses;
}

// Whether a mass is too large to be moved. The negative that the link gets has to cancel in every torque; if the mass
// is far above those that move, its rounding errors remain.
bool is_too_heavy(const Number& mass, const Number& carried) {
  constexpr int kMost = 2;
  if (!is_rational(mass) || !is_rational(carried)) return false;
  return GiNaC::ex_to<GiNaC::numeric>(GiNaC::abs(mass) - kMost * carried).is_positive();
}

// The mass that cancels an entry of the parent's first moment after `part` has been moved to the parent; nothing if
// none does. `carried`: the mass that the joint carries.
std::optional<Number> balancing_mass(const Body& body, const Body& parent, const InertialParameters& part,
                                     Balance balance, const Number& carried) {
  if (balance == Balance::no || body.prismatic || !can_balance(body.p, balance)) return std::nullopt;
  const std::size_t entry = entry_of(balance);
  const Number& arm = body.p[entry];
  if (!is_rational(arm)) return std::nullopt;
  const Vec3 moved = constant_rotation(body) * part.first_moment;
  const Number mass = (-(parent.inertia.first_moment[entry] + moved[entry]) / arm).expand();
  if (is_too_heavy(mass, carried)) return std::nullopt;
  return mass;
}

}  // namespace

bool can_balance(const Vec3& p, Balance balance) {
  constexpr int kLeast = 1000;                             // the arm must be at least 1/kLeast of the largest entry
  static const Number kShortest = exact_decimal("1e-12");  // m
  if (balance == Balance::no) return false;
  const Number& arm = p[entry_of(balance)];
  if (!is_rational(arm)) return !vanishes(arm);
  const GiNaC::numeric least = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(arm)) * kLeast;
  if (least < kLeast * GiNaC::ex_to<GiNaC::numeric>(kShortest)) return false;
  return std::all_of(p.begin(), p.end(), [&least](const Number& entry) {
    return !is_rational(entry) || GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(entry)) <= least;
  });
}

Mechanism regrouped(const Mechanism& mechanism, const std::vector<JointGrouping>& groupings) {
  Mechanism result = mechanism;
  const std::vector<Number> carried = carried_masses(mechanism);
  for (int i = result.size() - 1; i >= result.base_bodies(); --i) {
    const JointGrouping& chosen = groupings[static_cast<std::size_t>(i)];
    Body& body = result.bodies[static_cast<std::size_t>(i)];
    if (chosen.grouping == Grouping::none || is_inside_joint(body)) continue;
    const Body& joint = result.bodies[static_cast<std::size_t>(first_body_of_joint(result, i))];
    InertialParameters part = movable(body, chosen.grouping);
    if (joint.parent >= 0) {
      const Body& parent = result.bodies[static_cast<std::size_t>(joint.parent)];
      const Number& with_all = carried[static_cast<std::size_t>(i)];
      part.mass = balancing_mass(joint, parent, part, chosen.balance, with_all).value_or(part.mass);
    }
    body.inertia = body.inertia + negative(part);
    InertialParameters& parent =
        joint.parent < 0 ? result.base : result.bodies[static_cast<std::size_t>(joint.parent)].inertia;
    // The part does not change when the joint turns, so it is moved with the frame at q = 0. A prismatic joint's tensor
    // has no mass, so its place does not matter.
    parent = parent + transformed(part, constant_rotation(joint), joint.p);
  }
  return result;
}

Mechanism regrouped(const Mechanism& mechanism, Grouping grouping) {
  return regrouped(mechanism, std::vector<JointGrouping>(mechanism.bodies.size(), {grouping, Balance::no}));
}

}  // namespace flatdyn
