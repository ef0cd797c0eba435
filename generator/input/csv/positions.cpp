// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/csv/positions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "input/common/units.hpp"
#include "model/unit_plausibility.hpp"

namespace flatdyn {
namespace {

// The first row that is asked about. Doubles tell most rows apart from those that may be, quickly.
std::optional<std::size_t> odd_row(const CsvTable& table, const CsvSource& source, const Body& joint) {
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double roughly = std::strtod(table.rows[row][source.column].c_str(), nullptr);
    if (std::abs(roughly) <= 2 * std::numbers::pi) continue;
    if (may_be_degrees(exact_value(table, row, source), joint.limits, true)) return row;
  }
  return std::nullopt;
}

}  // namespace

void warn_of_positions(const CsvTable& table, const std::vector<std::optional<CsvSource>>& q,
                       const Mechanism& mechanism, const std::string& file, Diagnostics& diagnostics) {
  for (std::size_t p = 0; p < q.size(); ++p) {
    const Body& joint = mechanism.joint_at(static_cast<int>(p));
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
