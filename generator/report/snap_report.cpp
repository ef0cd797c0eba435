// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/snap_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "derivation/notation/number_text.hpp"
#include "robot/model/rounded_up.hpp"

namespace flatdyn {
namespace {

// A count of snaps with its noun: "1 angle", "3 products of inertia".
std::string counted(Snap::Kind kind, int count) {
  const char* const s = count == 1 ? "" : "s";
  switch (kind) {
    case Snap::Kind::axis:
      return fmt::format("{} component{} of axes", count, s);
    case Snap::Kind::gravity:
      return fmt::format("{} component{} of gravity", count, s);
    case Snap::Kind::product_of_inertia:
      return fmt::format("{} product{} of inertia", count, s);
    case Snap::Kind::angle:
    case Snap::Kind::length:
    case Snap::Kind::first_moment:
      break;
  }
  return fmt::format("{} {}{}", count, name_of(kind), s);
}

std::string largest_change(const SnapEffects& effects) {
  if (effects.bound) {
    return fmt::format("together they change no torque by more than {:.1g} N m", rounded_up(*effects.bound, 1));
  }
  double largest = 0;
  for (const SnapEffect& effect : effects.each) largest = std::max(largest, effect.seen);
  return fmt::format("the largest torque change at random states is {:.1g} N m", largest);
}

std::string summary(const std::vector<Snap>& snaps, const SnapEffects& effects) {
  std::map<Snap::Kind, int> count_of;
  for (const Snap& snap : snaps) ++count_of[snap.kind];
  std::vector<std::string> counts;
  for (const auto& [kind, count] : count_of) counts.push_back(counted(kind, count));
  return fmt::format("{} ({}); {}; -v lists them\n",
                     snaps.size() == 1 ? "1 number was snapped to an exact one near it"
                                       : fmt::format("{} numbers were snapped to exact ones near them", snaps.size()),
                     fmt::join(counts, ", "), largest_change(effects));
}

}  // namespace

std::string snap_text(const Snap& snap, const SnapEffect& effect) {
  const std::string unit = snap.kind == Snap::Kind::axis ? "" : fmt::format(" {}", unit_of(snap.kind));
  const std::string change = !effect.bound ? fmt::format("torques by up to {:.1e} N m at random states", effect.seen)
                             : *effect.bound == 0
                                 ? "no torque"
                                 : fmt::format("no torque by more than {:.1e} N m", rounded_up(*effect.bound, 2));
  return fmt::format("{}: {} snapped to {}: off by {:.1e}{}, changes {}", snap.what, snap.written,
                     plain_number_text(snap.exact), nearest_double(snap.difference), unit, change);
}

std::string describe_snaps(const std::vector<Snap>& snaps, const SnapEffects& effects, SnapDetail detail) {
  if (snaps.empty()) return "";
  if (detail == SnapDetail::one_line) return "\n" + summary(snaps, effects);
  std::string text =
      "\nnumbers snapped to exact ones near them (--snap 0 leaves them), at any motion within the limits or, without "
      "any,\n"
      "within 5 rad/s and 20 rad/s^2, or 1 m, 1 m/s and 10 m/s^2; forces of prismatic joints in N:\n";
  for (std::size_t k = 0; k < snaps.size(); ++k) {
    const Place& place = snaps[k].place;
    const std::string where = place.file.empty() ? "command line" : fmt::format("{}:{}", place.file, place.line);
    text += fmt::format("  {}: {}\n", where, snap_text(snaps[k], effects.each[k]));
  }
  return text;
}

nlohmann::ordered_json snaps_json(const std::vector<Snap>& snaps, const SnapEffects& effects) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < snaps.size(); ++k) {
    const Snap& snap = snaps[k];
    const SnapEffect& effect = effects.each[k];
    json.push_back({{"line", snap.place.line},
                    {"kind", name_of(snap.kind)},
                    {"what", snap.what},
                    {"written", snap.written},
                    {"taken_for", plain_number_text(snap.exact)},
                    {"largest_torque_change", effect.seen}});
    if (effect.bound) json.back()["torque_change_bound"] = rounded_up(*effect.bound, 2);
  }
  return json;
}

}  // namespace flatdyn
