// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/absent_limits.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>

#include "robot/model/exact_sign.hpp"

namespace flatdyn {
namespace {

constexpr int kFarthest = 10000;       // rad, m
constexpr int kLargestRate = 1000000;  // of rates and efforts

struct NamedLimit {
  const char* name;
  std::optional<Value>* limit;
};

using NamedLimits = std::array<NamedLimit, 5>;

// Positions first.
NamedLimits named_limits(Limits& limits) {
  return {{{"lower", &limits.lower},
           {"upper", &limits.upper},
           {"velocity", &limits.velocity},
           {"acceleration", &limits.acceleration},
           {"effort", &limits.effort}}};
}

// Takes away those of which `is_absent` is true of the index and the value; a note that begins with `what`.
void remove_limit(Joint& joint, const std::function<bool(std::size_t, const Number&)>& is_absent,
                  const std::string& what, const char* kind, Diagnostics& diagnostics) {
  std::vector<std::string> taken;
  Place place;
  const NamedLimits all = named_limits(joint.limits);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::optional<Value>& limit = *all[i].limit;
    if (!limit || has_symbols(limit->number) || !is_absent(i, limit->number)) continue;
    if (taken.empty()) place = limit->place;
    taken.emplace_back(all[i].name);
    limit.reset();
  }
  if (taken.empty()) return;
  diagnostics.note(place,
                   fmt::format("joint \"{}\": {} are taken as not given: {}", joint.name, what, fmt::join(taken, ", ")),
                   "give the limits, or leave them out", kind);
}

bool is_exactly(const std::optional<Value>& limit, int number) {
  return limit && !has_symbols(limit->number) && vanishes(limit->number - number);
}

}  // namespace

void remove_absent_limits(Joint& joint, Diagnostics& diagnostics) {
  const Limits& limits = joint.limits;
  const bool is_zero_range = is_exactly(limits.lower, 0) && is_exactly(limits.upper, 0);
  remove_limit(
      joint, [&](std::size_t i, const Number& limit) { return vanishes(limit) && (i > 1 || is_zero_range); },
      "limits of 0", "joints with limits of 0, which are taken as not given", diagnostics);
  remove_limit(
      joint,
      [](std::size_t i, const Number& limit) { return is_below(i > 1 ? kLargestRate : kFarthest, absolute(limit)); },
      "limits beyond what a joint reaches", "joints with huge limits, which are taken as not given", diagnostics);
  if (!is_exactly(limits.lower, 1) || !is_exactly(limits.upper, 0)) return;
  remove_limit(
      joint, [](std::size_t i, const Number&) { return i <= 1; }, "limits from 1 to 0, Bullet's word for none,",
      "joints with limits from 1 to 0, which are taken as not given", diagnostics);
}

}  // namespace flatdyn
