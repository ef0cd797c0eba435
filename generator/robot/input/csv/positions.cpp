// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/positions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "robot/input/common/units.hpp"
#include "robot/model/spherical_joint.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {
namespace {

// The first row whose position may be in degrees. Doubles quickly rule out most rows.
std::optional<std::size_t> odd_row(const CsvTable& table, const CsvSource& source, const Body& joint) {
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double roughly = std::strtod(table.rows[row][source.column].c_str(), nullptr);
    if (std::abs(roughly) <= 2 * std::numbers::pi) continue;
    if (may_be_degrees(exact_value(table, row, source), joint.limits, true)) return row;
  }
  return std::nullopt;
}

// `q`: the columns of a quaternion.
double norm_in(const CsvTable& table, std::size_t row, const std::vector<std::optional<CsvSource>>& q) {
  double squares = 0;
  for (const std::optional<CsvSource>& entry : q) {
    const double value = std::strtod(table.rows[row][entry->column].c_str(), nullptr);
    squares += value * value;
  }
  return std::sqrt(squares);
}

}  // namespace

void warn_of_quaternion(const CsvTable& table, const std::vector<std::optional<CsvSource>>& q, const std::string& of,
                        const std::string& file, Diagnostics& diagnostics) {
  constexpr double kSmall = 1e-6;
  std::size_t row = 0;
  double norm = 1;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const double found = norm_in(table, r, q);
    if (std::abs(found - 1) <= std::abs(norm - 1)) continue;
    row = r;
    norm = found;
  }
  if (std::abs(norm - 1) <= kSmall) return;
  diagnostics.warning({file, table.lines[row]},
                      fmt::format("the quaternion of the {} has norm {:.6g}: functions hold for norm 1", of, norm),
                      "divide the four numbers by their norm");
}

void warn_of_positions(const CsvTable& table, const std::vector<std::optional<CsvSource>>& q,
                       const Mechanism& mechanism, const std::string& file, Diagnostics& diagnostics) {
  for (const int first : mechanism.quaternions()) {
    if (q.empty()) break;
    const std::vector<std::optional<CsvSource>> entries(q.begin() + first, q.begin() + first + 4);
    const bool is_whole =
        std::all_of(entries.begin(), entries.end(), [](const auto& entry) { return entry.has_value(); });
    const std::string joint = spherical_joint_name(mechanism.joint_at(first).joint);
    if (is_whole) warn_of_quaternion(table, entries, "spherical joint \"" + joint + "\"", file, diagnostics);
  }
  for (std::size_t p = 0; p < q.size(); ++p) {
    const int position = static_cast<int>(p);
    if (mechanism.is_of_quaternion(position)) continue;
    const Body& joint = mechanism.joint_at(position);
    if (joint.prismatic || !q[p] || !q[p]->factor.is_equal(1)) continue;
    const std::string& column = table.columns[q[p]->column];
    if (column.find_first_of("[(") != std::string::npos) continue;  // it has a unit
    const std::optional<std::size_t> row = odd_row(table, *q[p], joint);
    if (!row) continue;
    warn_of_degrees(exact_value(table, *row, *q[p]), {{file, table.lines[*row]}, column},
                    fmt::format("if so, write the column's heading as {} [deg]", column), diagnostics);
  }
}

}  // namespace flatdyn
