// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/contact_rank.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/contacts.hpp"
#include "derivation/kernel/elimination.hpp"
#include "graph/mod_p.hpp"

namespace flatdyn {
namespace {

using FieldEntry = ModP<kMersenne61>;

// The contacts' rows at a random point of a large prime field, as columns by joint.
std::vector<std::vector<FieldEntry>> contact_columns(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  const std::vector<NodeId> entries = context.nodes(contact_jacobian(context));
  const Function jacobian =
      finished(context, {matrix_output("J_c", mechanism.contact_rows(), context.size(), entries, "")});
  constexpr std::uint64_t kSeed = 1;
  ModPArithmetic<kMersenne61> arithmetic(kSeed);
  const std::vector<FieldEntry> values = evaluate(jacobian, arithmetic);
  const Output& J = jacobian.outputs.front();
  std::vector<std::vector<FieldEntry>> columns(static_cast<std::size_t>(J.cols));
  for (std::size_t k = 0; k < J.entries.size(); ++k) {
    columns[k % columns.size()].push_back(values[static_cast<std::size_t>(J.entries[k])]);
  }
  return columns;
}

std::vector<std::size_t> independent_columns(std::vector<std::vector<FieldEntry>> rows) {
  return reduced_echelon(std::move(rows), [](const FieldEntry& x) { return x.value() == 0; }).pivots;
}

const Contact& contact_of_row(const Mechanism& mechanism, int row) {
  const auto found = std::find_if(mechanism.contacts.begin(), mechanism.contacts.end(), [&row](const Contact& contact) {
    row -= contact.rows();
    return row < 0;
  });
  return *found;
}

}  // namespace

void require_independent(const Mechanism& mechanism) {
  const std::vector<std::size_t> pivots = independent_columns(contact_columns(mechanism));
  const auto rows = static_cast<std::size_t>(mechanism.contact_rows());
  if (pivots.size() == rows) return;
  std::size_t first = 0;
  while (first < pivots.size() && pivots[first] == first) ++first;
  const Contact& contact = contact_of_row(mechanism, static_cast<int>(first));
  const bool is_first = &contact == mechanism.contacts.data();
  throw Failure(
      FailureKind::unsupported,
      fmt::format("contacts: their forces are not determined, because {}",
                  is_first ? fmt::format("\"{}\" holds more than the robot can move there", contact.name)
                           : fmt::format("what \"{}\" holds follows from the contacts before it", contact.name)),
      "take fewer contacts, or let `contact_damping` of the scene choose: 1e-3");
}

void require_support(const Mechanism& mechanism) {
  constexpr std::size_t kOfTwist = 6;
  std::vector<std::vector<FieldEntry>> columns = contact_columns(mechanism);
  columns.resize(kOfTwist);
  if (independent_columns(std::move(columns)).size() == kOfTwist) return;
  throw Failure(FailureKind::unsupported,
                "contact_inverse_dynamics: the contacts cannot carry the base, because their points are on one line",
                "take a third point beside the line, or a surface");
}

}  // namespace flatdyn
