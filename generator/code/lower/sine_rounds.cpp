// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/sine_rounds.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace flatdyn {
namespace {

// "sine_2": the array of a round, the first of which is 1 in the text.
std::string array_of_round(const char* array, std::size_t round) { return fmt::format("{}_{}", array, round + 1); }

}  // namespace

SineRounds::SineRounds(const Graph& graph, const Schedule& schedule) : graph_(graph) {
  const std::vector<int> numbers = rounds_of_sines(graph);
  for (const Statement& statement : schedule.statements) {
    if (!statement.targets.empty() || !is_of_computed_angle(graph, statement.node)) continue;
    const auto number = static_cast<std::size_t>(numbers[static_cast<std::size_t>(statement.node)]);
    rounds_.resize(std::max(rounds_.size(), number));
    Round& round = rounds_[number - 1];
    const NodeId angle = graph[statement.node].operands[0];
    const bool is_new = places_.emplace(angle, Place(number - 1, static_cast<int>(round.angles.size()))).second;
    if (is_new) round.angles.push_back(angle);
    round.sines.push_back(statement.node);
  }
}

code::Element SineRounds::entry(NodeId sine) const {
  const auto& [round, place] = place_of(sine);
  return {array_of_round(graph_[sine].op == Op::sin ? code::kSines : code::kCosines, round), place};
}

code::Declare SineRounds::arrays(std::size_t round) const {
  code::Declare declare;
  for (const char* array : {code::kAngles, code::kSines, code::kCosines}) {
    declare.arrays.push_back({array_of_round(array, round), rounds_[round].angles.size()});
  }
  return declare;
}

std::vector<std::string> SineRounds::names() const {
  std::vector<std::string> names;
  for (std::size_t round = 0; round < rounds_.size(); ++round) {
    for (const code::Declare::Array& each : arrays(round).arrays) names.push_back(each.name);
  }
  return names;
}

code::Statements SineRounds::filling(std::size_t round, const NodeExpressions& expressions) const {
  code::FillSines fill{array_of_round(code::kAngles, round),
                       {},
                       array_of_round(code::kSines, round),
                       array_of_round(code::kCosines, round),
                       true};
  code::Statements statements;
  for (const NodeId angle : rounds_[round].angles) {
    const int place = places_.at(angle).second;
    statements.emplace_back(code::Store{{code::Element{fill.array, place}}, expressions.use(angle)});
    fill.angles.insert(place);
  }
  statements.emplace_back(std::move(fill));
  return statements;
}

}  // namespace flatdyn
