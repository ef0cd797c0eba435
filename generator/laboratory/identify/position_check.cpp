// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/position_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot/model/number.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

double lower_of(const Body& body) { return nearest_double(body.limits.lower->number); }
double upper_of(const Body& body) { return nearest_double(body.limits.upper->number); }

// The largest plausible position: twice the limits is no overshoot. Limits of 0 and 0 at a prismatic joint are ones
// that nobody has filled in.
double largest_of(const Body& body) {
  if (!body.limits.lower || !body.limits.upper) return body.prismatic ? kNone : kManyTurns;
  const double reach = std::max(std::abs(lower_of(body)), std::abs(upper_of(body)));
  if (body.prismatic) return reach > 0 ? 2 * reach : kNone;
  return 2 * std::max(reach, std::numbers::pi);
}

}  // namespace

PositionCheck::PositionCheck(const Mechanism& mechanism, const LogHeading& heading)
    : mechanism_(mechanism), names_(heading.channel_names()) {
  for (int i = 0; i < mechanism.position_count(); ++i) {
    const Body& body = mechanism.joint_at(i);
    largest_.push_back(largest_of(body));
    limited_.push_back(body.limits.lower && body.limits.upper);
  }
}

bool PositionCheck::accepts(const double* channels, const Place& place, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < largest_.size(); ++i) {
    const Body& body = mechanism_.joint_at(static_cast<int>(i));
    const std::size_t channel = static_cast<std::size_t>(LogLayout::q()) + i;
    const double q = channels[channel];
    if (std::abs(q) <= largest_[i]) continue;
    const std::string& name = names_[channel];
    const char* unit = body.prismatic ? "m" : "rad";
    const std::string hint =
        fmt::format("are these {}? Then write the column's heading as {} [{}]",
                    body.prismatic ? "millimetres" : "degrees", name, body.prismatic ? "mm" : "deg");
    if (limited_[i]) {
      diagnostics.error(place,
                        fmt::format("{} = {} {} is far outside the limits of joint \"{}\", {} to {} {}", name, q, unit,
                                    body.joint, lower_of(body), upper_of(body), unit),
                        hint);
      return false;
    }
    diagnostics.warning(place,
                        fmt::format("{} = {:.6g} rad: joint \"{}\" has turned {:.0f} times", name, q, body.joint,
                                    std::abs(q) / (2 * std::numbers::pi)),
                        hint);
    largest_[i] = kNone;
  }
  return true;
}

}  // namespace flatdyn
