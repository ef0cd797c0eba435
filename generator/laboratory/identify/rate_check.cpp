// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/rate_check.hpp"

#include <fmt/format.h>

#include <numbers>

#include "robot/input/csv/clock.hpp"

namespace flatdyn {
namespace {

bool is_near(double value, double expected) { return value > expected / 2 && value < expected * 2; }

}  // namespace

RateCheck::RateCheck(const Mechanism& mechanism, const LogHeading& heading, double dt, bool moves)
    : dt_(dt), names_(heading.channel_names()), last_(names_.size()) {
  const LogLayout& layout = heading.layout;
  for (int i = 0; i < mechanism.position_count(); ++i) {
    if (moves && !mechanism.joint_at(i).prismatic) angles_.push_back(LogLayout::q() + i);
  }
  const auto add_pair = [this](int channel, int rate) {
    pairs_.push_back(
        {channel, rate, names_[static_cast<std::size_t>(channel)], names_[static_cast<std::size_t>(rate)]});
  };
  for (int i = 0; i < LogLayout::kTwist && layout.has_twist_rates; ++i) {
    add_pair(layout.twist() + i, layout.twist_rates() + i);
  }
  for (int i = 0; i < layout.joints && layout.has_rates; ++i) {
    const bool is_turn = layout.spherical_of(layout.base + i).has_value();
    if (!is_turn) add_pair(LogLayout::q() + mechanism.position_of(layout.base + i), layout.qd() + i);
    if (layout.has_accelerations) add_pair(layout.qd() + i, layout.qdd() + i);
  }
}

void RateCheck::finish(const Place& place, Diagnostics& diagnostics) const {
  if (dt_ >= kFarApart) return;
  for (const RatePair& pair : pairs_) pair.finish(place, diagnostics);
}

const char* RateCheck::unit_of_times() const {
  for (const auto& [unit, seconds] : {std::pair{"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}) {
    const auto is_odd = [seconds = seconds](const RatePair& pair) {
      return pair.squares > 0 && !is_near(pair.slope(), seconds);
    };
    const auto is_moved = [](const RatePair& pair) { return pair.squares > 0; };
    if (std::any_of(pairs_.begin(), pairs_.end(), is_moved) && std::none_of(pairs_.begin(), pairs_.end(), is_odd)) {
      return unit;
    }
  }
  return nullptr;
}

void RateCheck::RatePair::finish(const Place& place, Diagnostics& diagnostics) const {
  constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
  constexpr double kAlike = 0.5;  // squared correlation
  if (squares == 0 || is_near(slope(), 1)) return;
  const bool is_alike = likeness() > kAlike;
  if (!is_alike && is_held()) return;
  const std::string what =
      fmt::format("{0} is not the rate of change of {1}: {1} changes {2:.3g} times as fast", rate_name, name, slope());
  const auto in_degrees = [](const std::string& column) {
    return fmt::format("is {} in degrees? Write its unit into the heading", column);
  };
  if (is_alike && is_near(slope(), kDegreesPerRadian)) {
    diagnostics.error(place, what, in_degrees(name));
  } else if (is_alike && is_near(slope(), 1 / kDegreesPerRadian)) {
    diagnostics.error(place, what, in_degrees(rate_name));
  } else if (is_alike) {
    diagnostics.warning(place, what, "check units, signs and delays of the columns");
  } else {
    diagnostics.warning(place, what,
                        fmt::format("the two are hardly alike: check units, signs and delays of the columns; where {0} "
                                    "is mostly noise, leave out all columns of its kind, which are then made from the "
                                    "positions or velocities",
                                    rate_name));
  }
}

void RateCheck::report_jump(int channel, const double* channels, const Place& place, Diagnostics& diagnostics) const {
  const auto q = static_cast<std::size_t>(channel);
  diagnostics.warning(
      place,
      fmt::format("{} changes by {:.3g} rad in {:.3g} s", names_[q], channels[q] - last_[q], channels[0] - last_[0]),
      fmt::format("are these degrees? Then write the column's heading as {} [deg]; and an angle must not jump by "
                  "whole turns",
                  names_[q]));
}

}  // namespace flatdyn
