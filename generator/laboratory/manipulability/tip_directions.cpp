// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/manipulability/tip_directions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/task_rows.hpp"
#include "derivation/kernel/elimination.hpp"
#include "graph/mod_p.hpp"

namespace flatdyn {
namespace {

using Element = ModP<kMersenne61>;
using ElementMatrix = std::vector<std::vector<Element>>;  // by rows

bool is_zero(const Element& x) { return x.value() == 0; }

// The function's matrix at a random point of a large prime field, the same one for all functions: what is independent,
// or not zero, anywhere, is so at this point, except with a probability of about 1e-17.
ElementMatrix drawn_matrix(const Function& function, const Mechanism& mechanism) {
  const auto arithmetic = ModPArithmetic<kMersenne61>(1).with_quaternions(mechanism.quaternions());
  const auto values = evaluate(function, arithmetic);
  const Output& output = function.outputs.front();
  ElementMatrix rows(static_cast<std::size_t>(output.rows));
  for (std::size_t k = 0; k < output.entries.size(); ++k) {
    rows[k / static_cast<std::size_t>(output.cols)].push_back(values[static_cast<std::size_t>(output.entries[k])]);
  }
  return rows;
}

// The accelerations of the base by those of the joints while nothing holds it: -B_bb^-1 B_bq.
ElementMatrix motion_of_free_base(ElementMatrix B, std::size_t base) {
  B.resize(base);
  const Echelon<Element> solved = reduced_echelon(std::move(B), is_zero);
  if (solved.pivots.size() < base || solved.pivots.back() != base - 1) {
    throw Failure(FailureKind::unsupported, "forces or moments on the floating base move no inertia",
                  "give the base link, or links on it, mass and moments of inertia about all axes");
  }
  ElementMatrix motion = solved.rows;
  for (std::vector<Element>& row : motion) {
    row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(base));
    for (Element& entry : row) entry = -entry;
  }
  return motion;
}

// The columns, by joint, of the tip's Jacobian; with a floating base, of the generalised one.
ElementMatrix columns_by_joint(const Mechanism& mechanism, const Function& B, const Function& J) {
  const auto base = static_cast<std::size_t>(mechanism.base_bodies());
  const ElementMatrix all = drawn_matrix(J, mechanism);
  const ElementMatrix motion = base > 0 ? motion_of_free_base(drawn_matrix(B, mechanism), base) : ElementMatrix();
  ElementMatrix columns(mechanism.joints().size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (const std::vector<Element>& row : all) {
      Element entry = row[base + k];
      for (std::size_t b = 0; b < base; ++b) entry += row[b] * motion[b][k];
      columns[k].push_back(entry);
    }
  }
  return columns;
}

// Those of the rows, in this order, that are independent of the ones before.
std::vector<int> independent(const ElementMatrix& columns, const std::vector<int>& rows) {
  ElementMatrix chosen;
  for (const std::vector<Element>& column : columns) {
    chosen.emplace_back();
    for (const int row : rows) chosen.back().push_back(column[static_cast<std::size_t>(row)]);
  }
  std::vector<int> kept;
  for (const std::size_t k : reduced_echelon(std::move(chosen), is_zero).pivots) kept.push_back(rows[k]);
  return kept;
}

std::vector<int> moved_directions(const ElementMatrix& columns) {
  std::vector<int> moved;
  for (const int row : {0, 1, 2}) {
    const auto moves = [row](const auto& column) { return !is_zero(column[static_cast<std::size_t>(row)]); };
    if (std::any_of(columns.begin(), columns.end(), moves)) moved.push_back(row);
  }
  return moved;
}

void refuse_dependent(const Mechanism& mechanism, const std::vector<int>& wanted, const std::vector<int>& found) {
  if (found == wanted) return;
  throw Failure(FailureKind::unsupported,
                fmt::format("joints cannot accelerate the tip \"{}\" along {} independently{}", mechanism.tip.link,
                            task_text(wanted), mechanism.floating_base ? " while the base floats" : ""),
                found.empty() ? "no joint moves it: choose another with --tip"
                              : fmt::format("of the scene's `task` they can along {}", task_text(found)));
}

}  // namespace

TipDirections tip_directions(const Mechanism& mechanism, const Function& B, const Function& J) {
  const ElementMatrix columns = columns_by_joint(mechanism, B, J);
  TipDirections directions{mechanism.task.rows};
  if (mechanism.task.empty()) directions.rows = moved_directions(columns);
  if (directions.rows.empty()) {
    throw Failure(FailureKind::unsupported, "no joint moves the tip's origin",
                  "name directions of rotation in the scene's `task`, or another link with --tip");
  }
  const std::vector<int> kept = independent(columns, directions.rows);
  if (!mechanism.task.empty()) refuse_dependent(mechanism, directions.rows, kept);
  directions.rank = static_cast<int>(kept.size());
  return directions;
}

}  // namespace flatdyn
