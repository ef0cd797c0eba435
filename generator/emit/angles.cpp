// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/angles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "emit/writer.hpp"
#include "model/field_mechanism.hpp"
#include "symbolic/notation/number_text.hpp"

namespace flatdyn {
namespace {

const MultipleOfPosition& multiple(int index, const HeaderScope& scope) {
  return scope.angles[static_cast<std::size_t>(index - scope.positions)];
}

std::string fill_name(const HeaderScope& scope) { return scope.dialect.global("angles"); }

std::string function_of(const std::string& name, const std::vector<std::string>& lines, const HeaderScope& scope) {
  const Dialect& dialect = scope.dialect;
  std::string text =
      list_line(dialect.part_begin(name), {dialect.input("q"), dialect.output("angle")}, dialect.function_end(), 0);
  for (const std::string& line : lines) text += line;
  return text + "}";
}

}  // namespace

std::vector<MultipleOfPosition> multiples_of_positions(const Mechanism& mechanism) {
  std::vector<MultipleOfPosition> multiples;
  for (const CoordinateMultiple& angle : mechanism.angles)
    multiples.push_back({angle.position, to_rational(angle.factor)});
  return multiples;
}

int angle_index(const Graph& graph, NodeId id, const HeaderScope& scope) {
  const Term angle = angle_of(graph, id);
  const Input& input = graph[angle.node].input;
  if (input.kind == InputKind::q && angle.coefficient == 1) return input.index;
  for (std::size_t k = 0; k < scope.angles.size() && input.kind == InputKind::q; ++k) {
    const MultipleOfPosition& other = scope.angles[k];
    if (other.position == input.index && other.factor == angle.coefficient)
      return scope.positions + static_cast<int>(k);
  }
  throw std::logic_error("sine or cosine of what is no joint's position");
}

std::string angle_text(int index, const HeaderScope& scope) {
  if (index < scope.positions) return fmt::format("q[{}]", index);
  const MultipleOfPosition& angle = multiple(index, scope);
  return fmt::format("{} * q[{}]", scope.dialect.literal(angle.factor), angle.position);
}

std::string angle_count_name(const HeaderScope& scope) {
  if (!scope.angles.empty()) return scope.dialect.count_name("angle_count");
  const int of_base = scope.floating_base ? 6 : 0;
  return scope.dialect.count_name(of_base + scope.positions == scope.joints ? "joint_count" : "position_count");
}

std::string angle_array(const HeaderScope& scope) { return scope.angles.empty() ? "q" : "angle"; }

std::string angles_call(const HeaderScope& scope) {
  return code_line(scope.dialect.part_call(fill_name(scope)) + "q, angle);", kStatementIndent);
}

// If functions may have only so many lines, the lines are put into parts.
std::string angles_definition(const HeaderScope& scope) {
  constexpr std::size_t kAround = 2;
  const std::string name = fill_name(scope);
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < scope.angle_count(); ++k) {
    const int index = static_cast<int>(k);
    lines.push_back(code_line(fmt::format("angle[{}] = {};", k, angle_text(index, scope)), kStatementIndent));
  }
  const std::size_t most = scope.most_lines > 0 ? static_cast<std::size_t>(scope.most_lines) - kAround : lines.size();
  if (lines.size() <= most) return function_of(name, lines, scope);
  std::string text;
  std::vector<std::string> calls;
  for (std::size_t first = 0; first < lines.size(); first += most) {
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(most, lines.size() - first);
    const std::string part = fmt::format("{}_{}", name, calls.size() + 1);
    text += function_of(part, {begin, begin + static_cast<std::ptrdiff_t>(count)}, scope) + "\n\n" +
            scope.dialect.before_part();
    calls.push_back(code_line(part + "(q, angle);", kStatementIndent));
  }
  return text + function_of(name, calls, scope);
}

std::vector<std::string> angles_comment(const HeaderScope& scope) {
  std::string text = "Sines and cosines, by index, are those of so many angles: of q's entries, and then of ";
  for (std::size_t k = 0; k < scope.angles.size(); ++k) {
    const MultipleOfPosition& angle = scope.angles[k];
    text += fmt::format("{}{} q[{}]", k == 0 ? "" : ", ", exact_number_text(GiNaC::numeric(angle.factor.str().c_str())),
                        angle.position);
  }
  return wrapped_words(text + ", by which coupled joints turn.", kCommentWidth);
}

}  // namespace flatdyn
