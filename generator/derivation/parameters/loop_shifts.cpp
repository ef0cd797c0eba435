// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/loop_shifts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "derivation/kernel/elimination.hpp"
#include "flatdyn/reference/real50.hpp"
#include "graph/arithmetic.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

using reference::Real50;
using IsZero = std::function<bool(const Number&)>;

Number product(const ParameterForm& a, const ParameterForm& b) {
  Number sum = 0;
  for (const auto& [index, coefficient] : a) {
    if (const auto other = b.find(index); other != b.end()) sum += coefficient * other->second;
  }
  return simplified<Number>(sum);
}

ParameterForm sum(ParameterForm a, const Number& factor, const ParameterForm& b) {
  for (const auto& [index, coefficient] : b) a[index] = simplified<Number>(a[index] + factor * coefficient);
  std::erase_if(a, [](const auto& term) { return vanishes(term.second); });
  return a;
}

// Whether a shift δ is possible: it may contain parameters that the model does not have only if no form depends on
// them.
bool is_possible(const ParameterForm& shift, const std::vector<ParameterForm>& forms, const std::vector<bool>& present,
                 const IsZero& is_zero) {
  ParameterForm absent = shift;
  std::erase_if(absent, [&](const auto& term) { return present[static_cast<std::size_t>(term.first)]; });
  return std::all_of(forms.begin(), forms.end(),
                     [&](const ParameterForm& form) { return is_zero(product(form, absent)); });
}

// The size of numbers. Frames rotated by arbitrary angles are rational approximations to 40 digits, so that numbers
// that should be zero are merely tiny. They must not be used as divisors.
class Size {
 public:
  explicit Size(const Mechanism& mechanism) : arithmetic_(somewhere), value_(mechanism.symbols, arithmetic_) {}

  bool is_trifling(const Number& x) const { return abs(value_(x)) < Real50("1e-30"); }

 private:
  static Real50 somewhere(const Input& input) { return Real50(7 * input.index + 11) / 13; }

  RealArithmetic<Real50> arithmetic_;
  NumberMap<RealArithmetic<Real50>> value_;
};

// The rank of a parameter in the order in which parameters are kept.
int preference_rank(int index) {
  const auto* place = std::find(std::begin(kPreference), std::end(kPreference), parameter_of(index));
  return kParametersPerJoint * joint_of(index) + static_cast<int>(place - std::begin(kPreference));
}

// The row of K to be removed.
std::optional<std::size_t> last_row(const BaseParameters& base, const std::vector<Number>& amounts, const Size& size) {
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < amounts.size(); ++k) {
    if (size.is_trifling(amounts[k])) continue;
    if (!last || preference_rank(base.columns[k]) > preference_rank(base.columns[*last])) last = k;
  }
  return last;
}

Vec3 third_axis(const LoopClosure& loop) { return {loop.axes[0][2], loop.axes[1][2], loop.axes[2][2]}; }

// The third of the loop's axes in the frame of an end's body, if the joints on the path keep its direction: they turn
// about it, or slide. Otherwise nothing.
std::optional<Vec3> carried_axis(const Mechanism& mechanism, const LoopClosure& loop, const LoopClosure::End& end,
                                 const Size& size) {
  Vec3 axis = third_axis(loop);
  for (const int body : path_to(mechanism, end.body, loop.carrier)) {
    const Body& joint = mechanism.bodies[static_cast<std::size_t>(body)];
    axis = expanded(transpose(joint_axes(joint)) * axis);
    if (joint.prismatic) continue;
    if (!size.is_trifling(axis[0]) || !size.is_trifling(axis[1])) return std::nullopt;
    axis = {0, 0, axis[2]};
  }
  return axis;
}

// The parameters of masses on the line p + z axis with ∫ z^power = 1 and all other moments 0.
InertialParameters masses_on_line(const Vec3& p, const Vec3& axis, std::size_t power) {
  switch (power) {
    case 0:
      return {1, p, steiner(1, p)};
    case 1:
      return {0, axis, inertia_between(p, axis)};
    default:
      return {0, zero_vector(), steiner(1, axis)};
  }
}

void add(int body, const InertialParameters& parameters, int sign, ParameterForm& shift) {
  if (body < 0) return;
  const std::vector<Number> entries = entries_of(parameters);
  for (int k = 0; k < kInertialPerBody; ++k) {
    const Number& entry = entries[static_cast<std::size_t>(k)];
    if (!vanishes(entry)) shift[index_of(body, static_cast<Parameter>(k))] += sign * entry;
  }
}

// Products of inertia with the loop's direction n, as of ∫ z r = n × v. Their sum over all links is n × the closed path
// round the loop, which is zero. The sign of n does not matter.
InertialParameters products_of(const Vec3& n, const Vec3& v) {
  return {0, zero_vector(), inertia_between(n, cross(n, v))};
}

// The shift of products of inertia for a loop whose joints share the direction of its third axis. Empty if one is
// prismatic, as the length of a link then varies.
ParameterForm products_round_loop(const Mechanism& mechanism, const LoopClosure& loop) {
  const Vec3 joint_axis = {0, 0, 1};
  ParameterForm shift;
  for (const bool is_second : {false, true}) {
    const LoopClosure::End& end = loop.ends[is_second];
    const int sign = is_second ? -1 : 1;
    Vec3 next = end.p;
    std::vector<int> way = path_to(mechanism, end.body, loop.carrier);
    for (; !way.empty(); way.pop_back()) {
      const Body& joint = mechanism.bodies[static_cast<std::size_t>(way.back())];
      if (joint.prismatic) return {};
      add(way.back(), products_of(joint_axis, next), sign, shift);
      next = joint.p;
    }
    add(loop.carrier, products_of(third_axis(loop), next), sign, shift);
  }
  std::erase_if(shift, [](const auto& term) { return vanishes(term.second); });
  return shift;
}

// As much on one axis as there is less on the other.
ParameterForm masses_on_axes(const LoopClosure& loop, const std::optional<Vec3> (&axes)[2], std::size_t power) {
  ParameterForm shift;
  for (const bool is_second : {false, true}) {
    const LoopClosure::End& end = loop.ends[is_second];
    const Vec3 axis = axes[is_second].value_or(zero_vector());
    add(end.body, masses_on_line(end.p, axis, power), is_second ? -1 : 1, shift);
  }
  return shift;
}

std::vector<ParameterForm> shifts_along_axes(const LoopClosure& loop) {
  const std::optional<Vec3> axes[] = {expanded(cross(loop.across[0], loop.across[1])),
                                      expanded(Number(loop.sense) * loop.axis)};
  const std::optional<Vec3> lines[] = {axes[0], loop.axis};
  std::vector<ParameterForm> shifts = {masses_on_axes(loop, lines, 0)};
  if (loop.sense != 0) shifts.push_back(masses_on_axes(loop, axes, 1));
  shifts.push_back(masses_on_axes(loop, lines, 2));
  return shifts;
}

std::vector<ParameterForm> shifts_of(const Mechanism& mechanism, const LoopClosure& loop, const Size& size) {
  const std::optional<Vec3> axes[] = {carried_axis(mechanism, loop, loop.ends[0], size),
                                      carried_axis(mechanism, loop, loop.ends[1], size)};
  const bool has_common_axis = axes[0] && axes[1];
  std::vector<ParameterForm> shifts;
  if (loop.aligns_axes()) {
    shifts = shifts_along_axes(loop);
  } else {
    for (std::size_t power = 0; power < (has_common_axis ? 3 : 1); ++power) {
      shifts.push_back(masses_on_axes(loop, axes, power));
    }
    if (has_common_axis) shifts.push_back(products_round_loop(mechanism, loop));
  }
  for (ParameterForm& shift : shifts) {
    std::erase_if(shift, [&size](const auto& term) { return size.is_trifling(term.second); });
  }
  return shifts;
}

// The shifts δ of all loops, loop by loop.
std::vector<ParameterForm> loop_shifts(const Mechanism& mechanism, const Size& size) {
  std::vector<ParameterForm> all;
  for (const LoopClosure& loop : mechanism.loops) {
    for (ParameterForm& shift : shifts_of(mechanism, loop, size)) all.push_back(std::move(shift));
  }
  return all;
}

}  // namespace

BaseParameters without_shifts(const Mechanism& mechanism, BaseParameters base, const std::vector<ParameterForm>& forms,
                              const std::vector<bool>& present, const IsZero& is_zero) {
  const Size size(mechanism);
  for (ParameterForm& shift : loop_shifts(mechanism, size)) {
    if (!is_possible(shift, forms, present, is_zero)) continue;
    for (const LoopShift& before : base.shifts) shift = sum(shift, -product(before.share, shift), before.shift);
    std::vector<Number> amounts;
    for (const ParameterForm& form : base.combination) amounts.push_back(product(form, shift));
    const std::optional<std::size_t> last = last_row(base, amounts, size);
    if (!last) continue;
    ParameterForm share;
    for (const auto& [index, coefficient] : base.combination[*last]) {
      share[index] = simplified<Number>(coefficient / amounts[*last]);
    }
    for (std::size_t k = 0; k < amounts.size(); ++k) {
      if (k != *last) base.combination[k] = sum(base.combination[k], -amounts[k], share);
    }
    base.columns.erase(base.columns.begin() + static_cast<std::ptrdiff_t>(*last));
    base.combination.erase(base.combination.begin() + static_cast<std::ptrdiff_t>(*last));
    base.shifts.push_back({std::move(shift), std::move(share)});
  }
  return base;
}

}  // namespace flatdyn
