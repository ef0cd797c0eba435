// SPDX-License-Identifier: GPL-2.0-or-later
#include "planning/formulations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "definition/pivot_share.hpp"
#include "diagnostics/diagnostics.hpp"
#include "diagnostics/nearest.hpp"
#include "graph/count.hpp"
#include "symbolic/functions.hpp"

namespace flatdyn {
namespace {

const FunctionEntry& entry_of(const std::string& name) {
  const auto& table = function_table();
  const auto found = std::find_if(table.begin(), table.end(), [&](const FunctionEntry& e) { return name == e.name; });
  if (found != table.end()) return *found;
  std::vector<std::string> known;
  for (const FunctionEntry& entry : table) known.emplace_back(entry.name);
  throw Failure(ExitCode::usage, "unknown function \"" + name + "\"", hint_for_unknown(name, known, "functions"));
}

const LinkFrame& link_of(const Mechanism& mechanism, const std::string& name) {
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [&](const LinkFrame& frame) { return frame.link == name; });
  if (found != mechanism.links.end()) return *found;
  std::vector<std::string> known;
  for (const LinkFrame& frame : mechanism.links) known.push_back(frame.link);
  throw Failure(ExitCode::usage, "no link named \"" + name + "\"", hint_for_unknown(name, known, "links"));
}

// The function that a name asks for: "jacobian", or "jacobian:hand" for a link.
struct Request {
  const FunctionEntry* entry = nullptr;
  const LinkFrame* link = nullptr;
};

Request parsed(const Mechanism& mechanism, const std::string& name) {
  const std::size_t colon = name.find(':');
  Request request{&entry_of(name.substr(0, colon)), nullptr};
  if (colon == std::string::npos) return request;
  if (link_derivation(request.entry->name) == nullptr) {
    throw Failure(ExitCode::usage, fmt::format("function \"{}\" is not one of a link", request.entry->name),
                  "those of a link are forward_kinematics, jacobian and jacobian_dot_qd");
  }
  request.link = &link_of(mechanism, name.substr(colon + 1));
  return request;
}

// The summary "Pose of the tip", or "Pose of link hand".
std::string summary_of(const Request& request) {
  std::string summary = request.entry->summary;
  const std::string tip = "the tip";
  const std::size_t place = summary.find(tip);
  if (request.link != nullptr && place != std::string::npos) {
    summary.replace(place, tip.size(), "link \"" + request.link->link + "\"");
  }
  return summary;
}

}  // namespace

void check_function_name(const Mechanism& mechanism, const std::string& name) { parsed(mechanism, name); }

std::optional<Function> formulation(const Mechanism& mechanism, const std::string& name, FormulationIndex way,
                                    const Choices& choices) {
  const Request request = parsed(mechanism, name);
  const FunctionEntry& entry = *request.entry;
  std::optional<Function> result;
  if (way == 0) {
    result = request.link != nullptr ? link_derivation(entry.name)(mechanism, *request.link)
                                     : entry.derive(mechanism, choices);
  } else if (request.link == nullptr && way <= entry.alternatives.size()) {
    result = entry.alternatives[way - 1](mechanism, choices);
  }
  if (!result) return result;
  result->name = name;
  result->summary = summary_of(request);
  result->equation = entry.equation;
  return result;
}

bool may_lose_pivots(const Mechanism& mechanism, const std::string& name) {
  // In float, about 2^-17 is lost beside 1; results are poor well before that.
  constexpr double kLeast = 0x1p-14;
  return parsed(mechanism, name).entry->divides_by_pivots() && smallest_pivot_share(mechanism) < kLeast;
}

bool has_choices(const Mechanism& mechanism, const std::string& name) {
  const Request request = parsed(mechanism, name);
  const FunctionKind kind = request.entry->kind;
  return kind != FunctionKind::kinematics && kind != FunctionKind::regressor && kind != FunctionKind::loops;
}

namespace {

Choices plain_choices(const Mechanism& mechanism) { return uniform_choices(mechanism, Grouping::i_yy); }

std::optional<Formulation> cheapest_formulation(const Mechanism& mechanism, const std::string& name,
                                                FormulationIndex way, bool guards_pivots) {
  std::optional<Formulation> best;
  int fewest = 0;
  const auto consider = [&](Choices choices) {
    choices.guards_pivots = guards_pivots;
    std::optional<Function> made = formulation(mechanism, name, way, choices);
    if (!made) return 0;  // other choices yield none, either
    const int operations = count_operations(*made).arithmetic();
    if (!best || operations < fewest) {
      best = Formulation{way, choices, std::move(*made)};
      fewest = operations;
    }
    return operations;
  };
  if (has_choices(mechanism, name)) {
    cheapest_choices(mechanism, consider);
  } else {
    consider(plain_choices(mechanism));
  }
  return best;
}

}  // namespace

std::vector<Formulation> formulations(const Mechanism& mechanism, const std::string& name) {
  std::vector<Formulation> result;
  const bool guards_pivots = may_lose_pivots(mechanism, name);
  for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
    std::optional<Formulation> made = cheapest_formulation(mechanism, name, way, guards_pivots);
    if (made) result.push_back(std::move(*made));
  }
  return result;
}

Function derive_function(const Mechanism& mechanism, const std::string& name) {
  return *formulation(mechanism, name, 0, plain_choices(mechanism));
}

}  // namespace flatdyn
