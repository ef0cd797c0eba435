// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/contact_rank.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/diagnostics.hpp"
#include "graph/mod_p.hpp"
#include "symbolic/dynamics/contacts.hpp"
#include "symbolic/kernel/elimination.hpp"

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

const Contact& contact_of_row(const Mechanism& mechanism, int row) {
  const auto found = std::find_if(mechanism.contacts.begin(), mechanism.contacts.end(), [&row](const Contact& contact) {
    row -= contact.rows();
    return row < 0;
  });
  return *found;
}

}  // namespace

void require_independent(const Mechanism& mechanism) {
  const std::vector<std::size_t> pivots =
      reduced_echelon(contact_columns(mechanism), [](const FieldEntry& x) { return x.value() == 0; }).pivots;
  const int rows = mechanism.contact_rows();
  if (static_cast<int>(pivots.size()) == rows) return;
  int first = 0;
  while (first < static_cast<int>(pivots.size()) &&
         static_cast<int>(pivots[static_cast<std::size_t>(first)]) == first) {
    ++first;
  }
  throw Failure(ExitCode::unsupported,
                fmt::format("contacts: their forces are not determined, because what \"{}\" holds follows from the "
                            "contacts before it",
                            contact_of_row(mechanism, first).name),
                "take fewer contacts, or let `contact_damping` of the scene choose: 1e-3");
}

}  // namespace flatdyn
