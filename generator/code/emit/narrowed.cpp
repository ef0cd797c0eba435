// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/narrowed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "code/emit/literals.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kMostNamed = 4;

bool is_narrowed(double value, float becomes) {
  if (std::isinf(becomes)) return true;
  return becomes < std::numeric_limits<float>::min() && std::abs(double(becomes) - value) > 0;
}

// The severity of the loss: 2 for infinity, 1 for zero, 0 for some digits.
int loss(const NarrowedConstant& constant) { return std::isinf(constant.becomes) ? 2 : constant.becomes > 0 ? 0 : 1; }

template <class Visit>
void for_each_constant(const Function& function, Visit visit) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    if (!alive[static_cast<std::size_t>(id)]) continue;
    visit(function.graph[id].value);
    for (const Term& term : function.graph[id].terms) visit(term.coefficient);
  }
}

std::string named(const NarrowedConstant& constant) {
  return fmt::format("{:.6g} becomes {} ({})", constant.value,
                     std::isinf(constant.becomes) ? "infinite" : fmt::format("{:.6g}", constant.becomes),
                     constant.function);
}

}  // namespace

std::vector<NarrowedConstant> narrowed_constants(const std::vector<Function>& functions) {
  std::map<double, NarrowedConstant> found;
  for (const Function& function : functions) {
    for_each_constant(function, [&](const Rational& constant) {
      const double value = std::abs(nearest_double(constant));
      const auto becomes = static_cast<float>(value);
      if (is_narrowed(value, becomes)) found.try_emplace(value, NarrowedConstant{value, becomes, function.name});
    });
  }
  std::vector<NarrowedConstant> constants;
  for (const auto& [value, constant] : found) constants.push_back(constant);
  std::stable_sort(constants.begin(), constants.end(),
                   [](const NarrowedConstant& a, const NarrowedConstant& b) { return loss(a) > loss(b); });
  return constants;
}

void warn_of_narrowed(const std::vector<NarrowedConstant>& constants, const Place& place, Diagnostics& findings) {
  if (constants.empty()) return;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(constants.size(), kMostNamed); ++k) names.push_back(named(constants[k]));
  if (constants.size() > kMostNamed) names.push_back(fmt::format("and {} more", constants.size() - kMostNamed));
  findings.warning(place, fmt::format("float is too narrow for constants of the code: {}", fmt::join(names, ", ")),
                   "generate code in double, or write the robot in units in which masses, lengths and moments of "
                   "inertia are nearer to 1");
}

}  // namespace flatdyn
