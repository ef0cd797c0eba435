// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/base_gravity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "robot/input/csv/positions.hpp"

namespace flatdyn {

std::vector<CsvSource> base_orientation(CsvHeading& heading) {
  const std::vector<std::optional<CsvSource>> pose = heading.find(CsvQuantity::pose);
  const auto quaternion = pose.end() - 4;
  if (!std::all_of(quaternion, pose.end(), [](const auto& source) { return source.has_value(); })) return {};
  std::vector<CsvSource> columns;
  for (auto each = quaternion; each != pose.end(); ++each) columns.push_back(**each);
  return columns;
}

BaseGravity::BaseGravity(CsvHeading& heading, const Mechanism& mechanism, const Place& place, const std::string& why,
                         Diagnostics& diagnostics)
    : g_0_{mechanism.gravity[0], mechanism.gravity[1], mechanism.gravity[2]} {
  const std::vector<std::optional<CsvSource>> found = heading.find(CsvQuantity::g_b);
  std::vector<std::string> missing;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (found[k]) {
      gravity_.push_back(*found[k]);
    } else {
      missing.push_back(base_name_of(CsvQuantity::g_b, static_cast<int>(k), mechanism));
    }
  }
  const bool is_known = std::none_of(g_0_.begin(), g_0_.end(), has_symbols);
  if (gravity_.empty() && is_known) orientation_ = base_orientation(heading);
  if (missing.empty() || !orientation_.empty()) return;
  diagnostics.error(place,
                    fmt::format("{} {} missing: {}", fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are", why),
                    std::string(kBaseGravityHint) + "; --gravity off leaves it out");
}

std::vector<CsvSource> BaseGravity::sources() const { return orientation_.empty() ? gravity_ : orientation_; }

void BaseGravity::check(const CsvTable& table, const std::string& file, Diagnostics& diagnostics) const {
  if (orientation_.empty()) return;
  const std::vector<std::optional<CsvSource>> quaternion(orientation_.begin(), orientation_.end());
  warn_of_quaternion(table, quaternion, "floating base", file, diagnostics);
}

std::array<double, 3> BaseGravity::at(const CsvTable& table, std::size_t row) const {
  std::array<Number, 4> read;
  const std::vector<CsvSource> columns = sources();
  for (std::size_t k = 0; k < columns.size(); ++k) read[k] = exact_value(table, row, columns[k]);
  const bool is_told = orientation_.empty();
  const std::array<Number, 3> g_b =
      is_told ? std::array<Number, 3>{read[0], read[1], read[2]} : gravity_in_base_axes(read, g_0_);
  return {nearest_double(g_b[0]), nearest_double(g_b[1]), nearest_double(g_b[2])};
}

}  // namespace flatdyn
