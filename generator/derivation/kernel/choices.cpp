// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/kernel/choices.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

bool contains(const std::vector<Number>& numbers, const Number& number) {
  return std::any_of(numbers.begin(), numbers.end(), [&](const Number& each) { return vanishes(each - number); });
}

void add_axial_shift(std::vector<Number>& axial_shifts, const Number& axial_shift) {
  const Number value = axial_shift.expand();
  if (is_rational(value) && !vanishes(value) && !contains(axial_shifts, value)) axial_shifts.push_back(value);
}

Vec3 axis_of(const Body& body) {
  const Mat3 R = constant_rotation(body);
  return {R[0][2], R[1][2], R[2][2]};
}

// The point on the body's own axis, as z in its frame, where the common normal to a child's axis meets it.
Number foot_of_common_normal(const Body& child) {
  const Vec3 axis = axis_of(child), &p = child.p;
  if (child.spherical > 0) return p[2];
  const Number across = (axis[0] * axis[0] + axis[1] * axis[1]).expand();
  return vanishes(across) ? p[2] : p[2] - axis[2] * (p[0] * axis[0] + p[1] * axis[1]) / across;
}

}  // namespace

Mechanism with_shifted_frames(const Mechanism& mechanism, const Choices& choices) {
  Mechanism result = mechanism;
  for (std::size_t k = 0; k < choices.joints.size(); ++k) {
    const Number& axial_shift = choices.joints[k].axial_shift;
    if (!vanishes(axial_shift)) result = with_frame_shifted(result, static_cast<int>(k), axial_shift);
  }
  return result;
}

Mechanism chosen(const Mechanism& mechanism, const Choices& choices) {
  Mechanism result = with_shifted_frames(mechanism, choices);
  if (!choices.length_unit.is_equal(1)) result = in_length_unit(result, choices.length_unit);
  std::vector<JointGrouping> groupings;
  for (const JointChoice& joint : choices.joints) groupings.push_back(joint.grouping);
  return regrouped(result, groupings);
}

Choices uniform_choices(const Mechanism& mechanism, Grouping grouping) {
  const JointChoice each = {0, {grouping, Balance::no}, Axes::turning};
  return {std::vector<JointChoice>(mechanism.bodies.size(), each)};
}

Choices with_still_frames(const Mechanism& mechanism, Choices choices, StillFrames which) {
  std::vector<bool> is_leaf(choices.joints.size(), true);
  for (const Body& body : mechanism.bodies) {
    if (body.parent >= 0) is_leaf[static_cast<std::size_t>(body.parent)] = false;
  }
  for (std::size_t k = 0; k < choices.joints.size(); ++k) {
    const bool is_one = which == StillFrames::all || which == (is_leaf[k] ? StillFrames::leaves : StillFrames::inner);
    const bool is_still = is_one && can_be_still(mechanism, static_cast<int>(k));
    choices.joints[k].axes = is_still ? Axes::still : Axes::turning;
  }
  return choices;
}

std::vector<Choices> with_other_still_frames(const Mechanism& mechanism, const Choices& choices) {
  std::vector<Choices> others;
  std::vector<std::vector<Axes>> known = {axes_of(choices)};
  for (const StillFrames which : {StillFrames::none, StillFrames::leaves, StillFrames::inner, StillFrames::all}) {
    Choices other = with_still_frames(mechanism, choices, which);
    if (std::find(known.begin(), known.end(), axes_of(other)) != known.end()) continue;
    known.push_back(axes_of(other));
    others.push_back(std::move(other));
  }
  return others;
}

std::vector<Axes> axes_of(const Choices& choices) {
  std::vector<Axes> axes;
  for (const JointChoice& joint : choices.joints) axes.push_back(joint.axes);
  return axes;
}

std::vector<Number> possible_axial_shifts(const Mechanism& mechanism, int i) {
  std::vector<Number> axial_shifts;
  const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
  if (body.prismatic || mechanism.is_around_pose(i)) return axial_shifts;
  const Vec3 axis = axis_of(body);
  add_axial_shift(axial_shifts, -dot(body.p, axis));
  for (std::size_t k = 0; k < 3; ++k) {
    if (!vanishes(axis[k])) add_axial_shift(axial_shifts, -body.p[k] / axis[k]);
  }
  for (const Body& child : mechanism.bodies) {
    if (child.parent == i && !child.prismatic) add_axial_shift(axial_shifts, foot_of_common_normal(child));
  }
  return axial_shifts;
}

std::vector<Number> possible_length_units(const Mechanism& mechanism) {
  std::vector<std::pair<Number, int>> lengths;  // with the number of their occurrences
  if (mechanism.has_lengths()) return {};
  for (const Body& body : mechanism.bodies) {
    if (body.parent < 0) continue;  // the distance of the first joint from the base has no effect
    for (const Number& entry : body.p) {
      if (!is_rational(entry) || vanishes(entry)) continue;
      const Number length = GiNaC::abs(entry);
      const auto known =
          std::find_if(lengths.begin(), lengths.end(), [&](const auto& each) { return each.first.is_equal(length); });
      if (known == lengths.end()) {
        lengths.emplace_back(length, 1);
      } else {
        ++known->second;
      }
    }
  }
  std::stable_sort(lengths.begin(), lengths.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<Number> units;
  for (const auto& [length, count] : lengths) units.push_back(length);
  return units;
}

std::vector<Choices> plain_variants(const Mechanism& mechanism, const Choices& choices) {
  std::vector<Choices> variants;
  for (const Grouping grouping : kGroupings) {
    variants.push_back(choices);
    const Choices plain = uniform_choices(mechanism, grouping);
    for (std::size_t k = 0; k < plain.joints.size(); ++k) variants.back().joints[k].grouping = plain.joints[k].grouping;
  }
  return variants;
}

std::vector<Choices> with_other_length_units(const Mechanism& mechanism, const Choices& choices) {
  constexpr std::size_t kUsual = 3;
  std::vector<Number> units = possible_length_units(mechanism);
  if (units.empty()) return {};
  units.resize(std::min(units.size(), kUsual));
  units.emplace_back(1);
  std::vector<Choices> others;
  for (const Number& unit : units) {
    if (unit.is_equal(choices.length_unit)) continue;
    others.push_back(choices);
    others.back().length_unit = unit;
  }
  return others;
}

namespace {

// Lets every joint's mass balance an entry of the parent's first moment, where that is possible.
Choices balanced(const Mechanism& mechanism, Choices choices, Balance first, Balance second) {
  for (std::size_t k = 0; k < choices.joints.size(); ++k) {
    const Vec3& p = mechanism.bodies[static_cast<std::size_t>(first_body_of_joint(mechanism, static_cast<int>(k)))].p;
    choices.joints[k].grouping.balance = can_balance(p, first) ? first : can_balance(p, second) ? second : Balance::no;
  }
  return choices;
}

}  // namespace

Choices cheapest_choices(const Mechanism& mechanism, const std::function<int(const Choices&)>& operations) {
  Choices best;
  std::optional<int> fewest;
  const auto consider = [&](const Choices& choices) {
    const int count = operations(choices);
    if (fewest && count >= *fewest) return;
    fewest = count;
    best = choices;
  };
  for (const Grouping grouping : kGroupings) consider(uniform_choices(mechanism, grouping));
  for (const Choices& other : with_other_still_frames(mechanism, best)) consider(other);
  for (const Choices& other : with_other_length_units(mechanism, best)) consider(other);
  consider(balanced(mechanism, best, Balance::x, Balance::y));
  consider(balanced(mechanism, best, Balance::y, Balance::x));
  return best;
}

}  // namespace flatdyn
