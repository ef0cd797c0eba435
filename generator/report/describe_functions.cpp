// SPDX-License-Identifier: GPL-2.0-or-later
// Functions and stages with their operation counts.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/diagnostics/table.hpp"
#include "code/emit/argument_text.hpp"
#include "code/languages/emit.hpp"
#include "code/lower/arguments.hpp"
#include "derivation/notation/number_text.hpp"
#include "graph/passes/fuse_products.hpp"
#include "report/describe.hpp"

namespace flatdyn {

namespace {

// The heads of a table's columns with numbers of operations, after the first column; and these cells of a function.
std::vector<std::string> count_heads(const std::string& first, bool fuses) {
  if (fuses) return {first, "mul", "add", "fma", "div", "sin/cos"};
  return {first, "mul", "add", "div", "sin/cos"};
}
std::vector<std::string> count_cells(const std::string& name, const Function& function, bool fuses) {
  const OperationCount count = operations_as_written(function, fuses);
  std::vector<std::string> cells = {name, std::to_string(count.multiplications), std::to_string(count.additions)};
  if (fuses) cells.push_back(std::to_string(count.fused));
  cells.insert(cells.end(), {std::to_string(count.divisions), std::to_string(count.trigonometric)});
  return cells;
}

nlohmann::ordered_json count_json(const std::string& name, const Function& function, bool fuses) {
  const OperationCount count = operations_as_written(function, fuses);
  nlohmann::ordered_json json = {
      {"name", name}, {"multiplications", count.multiplications}, {"additions", count.additions}};
  if (fuses) json["fused_multiply_adds"] = count.fused;
  json["divisions"] = count.divisions;
  json["sin_cos"] = count.trigonometric;
  return json;
}

}  // namespace

namespace {

const char* name_of(Grouping grouping) {
  switch (grouping) {
    case Grouping::i_yy:
      return "i_yy";
    case Grouping::i_xx:
      return "i_xx";
    case Grouping::sigma_zz:
      return "sigma_zz";
    case Grouping::none:
      break;
  }
  return "none";
}

const char* name_of(Balance balance) { return balance == Balance::no ? "none" : balance == Balance::x ? "x" : "y"; }

nlohmann::ordered_json search_json(const SearchRecord& search) {
  nlohmann::ordered_json json = {{"candidates", search.candidates}};
  json["before"] = {{"multiplications", search.before.multiplications}, {"additions", search.before.additions}};
  json["order_of_factoring"] = search.choices.order;
  json["formulation"] = search.is_closed_form ? "closed form" : "recursive";
  if (search.is_closed_form) return json;
  json["length_unit"] = plain_number_text(search.choices.length_unit);
  for (const JointChoice& joint : search.choices.joints) {
    json["joints"].push_back({{"origin_raised_by", plain_number_text(joint.axial_shift)},
                              {"cancelled_inertia", name_of(joint.grouping.grouping)},
                              {"cancelled_first_moment_of_parent", name_of(joint.grouping.balance)},
                              {"axes", joint.axes == Axes::still ? "still" : "turning"}});
  }
  return json;
}

// Multiplications and additions before the search, "308 / 290"; functions made together are not searched.
std::string before_search(const OptimisedFunction& each) {
  if (!each.search) return "";
  return fmt::format("{} / {}", each.search->before.multiplications, each.search->before.additions);
}

// As people count joints, and the columns of CSV files: "q_2 to q_4, m_p".
std::string list_as_counted(const std::vector<Input>& inputs, const std::vector<std::string>& symbols) {
  std::vector<std::string> parts;
  for (std::size_t first = 0, last = 0; first < inputs.size(); first = last + 1) {
    last = first;
    while (inputs[first].kind != InputKind::parameter && last + 1 < inputs.size() &&
           inputs[last + 1].kind == inputs[first].kind && inputs[last + 1].index == inputs[last].index + 1) {
      ++last;
    }
    parts.push_back(variable_of_input(inputs[first], symbols));
    if (last > first) parts.back() += (last > first + 1 ? " to " : ", ") + variable_of_input(inputs[last], symbols);
  }
  return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

bool is_searched(const std::vector<OptimisedFunction>& functions) {
  return !functions.empty() && functions.front().search;
}

}  // namespace

std::string describe_functions(const std::vector<OptimisedFunction>& functions, const std::vector<std::string>& symbols,
                               bool fuses) {
  std::vector<std::vector<std::string>> rows = {count_heads("function", fuses)};
  rows[0].insert(rows[0].end(), {"as derived", "zeros", "reads"});
  if (is_searched(functions)) rows[0].insert(rows[0].begin() + 3, "before search");
  for (const OptimisedFunction& each : functions) {
    rows.push_back(count_cells(each.function.name, each.function, fuses));
    if (is_searched(functions)) rows.back().insert(rows.back().begin() + 3, before_search(each));
    for (const int number : {count_operations(each.derived).arithmetic(), count_written_zeros(each.function)}) {
      rows.back().push_back(std::to_string(number));
    }
    rows.back().push_back(list_as_counted(inputs_read(each.function), symbols));
  }
  return aligned_table(rows);
}

std::string describe_formulations(const std::vector<OptimisedFunction>& functions) {
  std::map<std::string, std::vector<std::string>> by_formulation;
  for (const OptimisedFunction& each : functions) {
    const std::string& formulation = each.function.formulation;
    if (!formulation.empty() && formulation != kRecursion) by_formulation[formulation].push_back(each.function.name);
  }
  std::vector<std::string> parts;
  for (const auto& [formulation, names] : by_formulation) {
    parts.push_back(fmt::format("{} for {}", formulation, fmt::join(names, ", ")));
  }
  return parts.empty() ? "" : fmt::format("cheapest of several formulations: {}\n\n", fmt::join(parts, "; "));
}

std::vector<StagePiece> stage_pieces(const Stages& stages) {
  std::vector<StagePiece> pieces = {{"at", &stages.configuration.make}};
  for (const Function& member : stages.configuration.members)
    pieces.push_back({"Configuration::" + member.name, &member});
  if (stages.motion.members.empty()) return pieces;
  pieces.push_back({"with", &stages.motion.make});
  for (const Function& member : stages.motion.members) pieces.push_back({"Motion::" + member.name, &member});
  return pieces;
}

std::string describe_stages(const Stages& stages, bool fuses) {
  std::vector<std::vector<std::string>> rows = {count_heads("stage", fuses)};
  rows[0].emplace_back("stores");
  for (const StagePiece& piece : stage_pieces(stages)) {
    rows.push_back(count_cells(piece.name, *piece.function, fuses));
    const Output& output = piece.function->outputs[0];
    rows.back().push_back(output.layout == Layout::fields ? std::to_string(output.entries.size()) : "");
  }
  return aligned_table(rows);
}

nlohmann::ordered_json stages_json(const Stages& stages, bool fuses) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const StagePiece& piece : stage_pieces(stages)) {
    json.push_back(count_json(piece.name, *piece.function, fuses));
  }
  return json;
}

nlohmann::ordered_json functions_json(const std::vector<OptimisedFunction>& functions, const Mechanism& mechanism,
                                      bool fuses) {
  const std::vector<std::string> symbols = symbol_names(mechanism);
  const std::unique_ptr<const PageDialect> dialect = dialect_of(mechanism, {});
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const OptimisedFunction& each : functions) {
    nlohmann::ordered_json item = count_json(each.function.name, each.function, fuses);
    item["operations_as_derived"] = count_operations(each.derived).arithmetic();
    if (!each.function.formulation.empty()) item["formulation"] = each.function.formulation;
    item["structural_zeros"] = count_written_zeros(each.function);
    item["reads"] = list_of_inputs(inputs_read(each.function), symbols, *dialect);
    if (each.function.proven_pivot_share > 0) {
      item["pivots"] = {{"proven_share", each.function.proven_pivot_share}};
    } else if (compares_pivots(each.function)) {
      const auto loops = static_cast<std::size_t>(each.function.loop_conditions);
      item["pivots"] = {{"compared", each.function.pivot_scales.size() - loops}};
    }
    if (each.search) item["search"] = search_json(*each.search);
    json.push_back(item);
  }
  return json;
}

}  // namespace flatdyn
