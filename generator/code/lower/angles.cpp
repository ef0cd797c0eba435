// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/angles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "code/lower/arguments.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {

using code::kAngles;

std::vector<MultipleOfPosition> multiples_of_positions(const Mechanism& mechanism) {
  std::vector<MultipleOfPosition> multiples;
  for (const CoordinateMultiple& angle : mechanism.angles)
    multiples.push_back({angle.position, to_rational(angle.factor)});
  return multiples;
}

int angle_index(const Graph& graph, NodeId id, const Scope& scope) {
  const Term angle = angle_of(graph, id);
  const Input& input = graph[angle.node].input;
  if (input.kind == InputKind::q && angle.coefficient == 1) return input.index;
  for (std::size_t k = 0; k < scope.angles.size() && input.kind == InputKind::q; ++k) {
    const MultipleOfPosition& other = scope.angles[k];
    if (other.position == input.index && other.factor == angle.coefficient)
      return scope.counts.positions + static_cast<int>(k);
  }
  throw std::logic_error("sine or cosine of what is no joint's position");
}

code::Expression angle_of_index(int index, const Scope& scope) {
  const std::string q = input_argument(InputKind::q, 0).name;
  if (index < scope.counts.positions) return code::Element{q, index};
  const MultipleOfPosition& angle = scope.angles[static_cast<std::size_t>(index - scope.counts.positions)];
  return code::Product{{code::Literal{angle.factor}, code::Element{q, angle.position}}};
}

std::string angle_array(const Scope& scope) {
  return scope.angles.empty() ? input_argument(InputKind::q, 0).name : kAngles;
}

std::vector<code::Argument> arguments_of_angles(const Scope& scope) {
  const InputArgument q = input_argument(InputKind::q, scope.counts);
  return {{code::Argument::Role::input, q.name, static_cast<std::size_t>(q.length)},
          {code::Argument::Role::output, kAngles, scope.angle_count()}};
}

std::vector<code::Part> parts_of_angles(const std::string& name, const Scope& scope) {
  constexpr std::size_t kAround = 2;  // lines around statements
  const std::vector<code::Argument> arguments = arguments_of_angles(scope);
  code::Part whole{name, arguments, {}};
  for (int k = 0; k < static_cast<int>(scope.angle_count()); ++k) {
    whole.statements.emplace_back(code::Store{{code::Element{kAngles, k}}, angle_of_index(k, scope)});
  }
  const std::size_t most =
      scope.most_lines > 0 ? static_cast<std::size_t>(scope.most_lines) - kAround : whole.statements.size();
  if (whole.statements.size() <= most) return {whole};
  std::vector<code::Part> parts;
  code::Part last{name, arguments, {}};
  for (std::size_t first = 0; first < whole.statements.size(); first += most) {
    const auto begin = whole.statements.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = static_cast<std::ptrdiff_t>(std::min(most, whole.statements.size() - first));
    parts.push_back({fmt::format("{}_{}", name, parts.size() + 1), arguments, {begin, begin + count}});
    last.statements.emplace_back(code::CallPart{parts.back().name, arguments, true});
  }
  parts.push_back(std::move(last));
  return parts;
}

std::string angle_count_name(const Scope& scope) {
  if (!scope.angles.empty()) return "angle_count";
  const int of_base = scope.counts.base;
  return of_base + scope.counts.positions == scope.counts.joints ? "joint_count" : "position_count";
}

code::Statements filling_sines(const std::set<int>& angles, const std::string& function, const Scope& scope) {
  const std::string count = angle_count_name(scope);
  code::Declare arrays;
  if (!scope.angles.empty()) arrays.arrays.push_back({kAngles, scope.angle_count(), count});
  for (const char* name : {kSines, kCosines}) arrays.arrays.push_back({name, scope.angle_count(), count});
  code::Statements statements = {std::move(arrays)};
  if (!scope.angles.empty()) statements.emplace_back(code::CallPart{function, arguments_of_angles(scope)});
  statements.emplace_back(code::FillSines{angle_array(scope), angles});
  return statements;
}

}  // namespace flatdyn
