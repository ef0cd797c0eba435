// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/snap_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "symbolic/notation/number_text.hpp"

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

std::string summary(const std::vector<Snap>& snaps, const std::vector<double>& torque_changes) {
  std::map<Snap::Kind, int> count_of;
  for (const Snap& snap : snaps) ++count_of[snap.kind];
  std::vector<std::string> counts;
  for (const auto& [kind, count] : count_of) counts.push_back(counted(kind, count));
  return fmt::format("{} ({}); the largest torque change is {:.1g} N m; -v lists them\n",
                     snaps.size() == 1 ? "1 number was snapped to an exact one near it"
                                       : fmt::format("{} numbers were snapped to exact ones near them", snaps.size()),
                     fmt::join(counts, ", "), *std::max_element(torque_changes.begin(), torque_changes.end()));
}

}  // namespace

std::string snap_text(const Snap& snap, double torque_change) {
  const std::string unit = snap.kind == Snap::Kind::axis ? "" : fmt::format(" {}", unit_of(snap.kind));
  return fmt::format("{}: {} snapped to {}: off by {:.1e}{}, changes torques by up to {:.1e}", snap.what, snap.written,
                     plain_number_text(snap.exact), nearest_double(snap.difference), unit, torque_change);
}

std::string describe_snaps(const std::vector<Snap>& snaps, const std::vector<double>& torque_changes,
                           SnapDetail detail) {
  if (snaps.empty()) return "";
  if (detail == SnapDetail::one_line) return "\n" + summary(snaps, torque_changes);
  std::string text =
      "\nnumbers snapped to exact ones near them (--snap 0 leaves them; torques in N m, at random states within "
      "limits):\n";
  for (std::size_t k = 0; k < snaps.size(); ++k) {
    const Place& place = snaps[k].place;
    text += fmt::format("  {}:{}: {}\n", place.file, place.line, snap_text(snaps[k], torque_changes[k]));
  }
  return text;
}

nlohmann::ordered_json snaps_json(const std::vector<Snap>& snaps, const std::vector<double>& torque_changes) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < snaps.size(); ++k) {
    const Snap& snap = snaps[k];
    json.push_back({{"line", snap.place.line},
                    {"kind", name_of(snap.kind)},
                    {"what", snap.what},
                    {"written", snap.written},
                    {"taken_for", plain_number_text(snap.exact)},
                    {"largest_torque_change", torque_changes[k]}});
  }
  return json;
}

}  // namespace flatdyn
