// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/stress_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

std::string two_digits(double value) { return fmt::format("{:.2g}", value); }

std::vector<std::string> table_row(const StressReport& report, const StressRow& row) {
  const bool is_lost = row.lost.ratio > report.options.ratio;
  const bool is_large = row.worst.error.scaled > report.options.bound;
  const std::string verdict = is_lost ? "LOST" : is_large ? "LARGE" : "ok";
  return {row.function,
          row.scalar,
          two_digits(row.random.percentile_99),
          two_digits(row.random.largest),
          two_digits(row.edge),
          two_digits(row.worst.error.scaled),
          row.worst.where,
          row.worst.variant,
          two_digits(row.worst.error.condition),
          two_digits(row.worst.reference),
          two_digits(row.lost.ratio),
          row.refused > 0 ? fmt::format("{} ({} of {} refused)", verdict, row.refused, row.tried) : verdict};
}

ordered_json stress_row_json(const StressReport& report, const StressRow& row, const StressFinding& finding) {
  return {{"found", finding.where},
          {"variant", finding.variant},
          {"scaled_error", finding.error.scaled},
          {"condition", finding.error.condition},
          {"relative_error", finding.error.relative},
          {"around", finding.near},
          {"reference", finding.reference},
          {"ratio", finding.ratio},
          {"state", state_csv(report, row, finding.state)}};
}

ordered_json stress_row_json(const StressReport& report, const StressRow& row) {
  ordered_json json = {
      {"function", row.function}, {"scalar", row.scalar},
      {"states", row.states},     {"tried", row.tried},
      {"refused", row.refused},   {"random", {{"p99", row.random.percentile_99}, {"max", row.random.largest}}},
      {"edge_max", row.edge}};
  for (const auto& [name, largest] : row.variants) json["variants"][name] = largest;
  json["worst"] = stress_row_json(report, row, row.worst);
  json["lost"] = stress_row_json(report, row, row.lost);
  json["histogram"] = row.histogram;
  json["passed"] = row.passed;
  return json;
}

// The rows for `eval` to repeat: those that did not pass; of the others, the worst in double.
std::vector<const StressRow*> rows_to_show(const StressReport& report) {
  std::vector<const StressRow*> rows;
  const StressRow* worst = nullptr;
  for (const StressRow& row : report.rows) {
    if (!row.passed) {
      rows.push_back(&row);
    } else if (row.scalar == "double" && (worst == nullptr || row.worst.error.scaled > worst->worst.error.scaled)) {
      worst = &row;
    }
  }
  if (worst != nullptr) rows.push_back(worst);
  return rows;
}

std::string states_to_show(const StressReport& report) {
  std::string text;
  for (const StressRow* row : rows_to_show(report)) {
    const bool is_lost = row->lost.ratio > report.options.ratio;
    const StressFinding& finding = is_lost ? row->lost : row->worst;
    text += fmt::format("\n{}, {}: scaled error {:.2g}, {:.2g} times the reference's\n{}", row->function,
                        finding.variant, finding.error.scaled, finding.ratio, state_csv(report, *row, finding.state));
  }
  return text;
}

}  // namespace

std::string state_csv(const StressReport& report, const StressRow& row, const State& state) {
  std::vector<std::string> heading = row.columns;
  std::vector<double> values;
  for (const InputKind kind : row.inputs) {
    if (kind == InputKind::parameter) continue;
    const std::vector<double>& numbers = state.of(kind);
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  heading.insert(heading.end(), report.symbols.begin(), report.symbols.end());
  values.insert(values.end(), state.parameters.begin(), state.parameters.end());
  return fmt::format("{}\n{}\n", fmt::join(heading, ","), fmt::join(values, ","));
}

std::string stress_text(const StressReport& report) {
  std::vector<std::vector<std::string>> rows = {{"function", "scalar", "random: p99", "max", "edge", "worst", "found",
                                                 "variant", "condition", "reference", "ratio", ""}};
  std::size_t states = 0;
  for (const StressRow& row : report.rows) {
    rows.push_back(table_row(report, row));
    states = std::max(states, row.states);
  }
  std::string text = fmt::format("{}: up to {} random states each\n\n{}\n", report.robot, states, aligned_table(rows));
  text += fmt::format(
      "errors: scaled, in units of the last place of the scalar, of the size of the entry's own terms; every source "
      "of\n"
      "sines and cosines, one state per call and over lanes, the worst of them; \"worst\" against 50 digits\n"
      "condition: the size of the worst entry's terms over that entry: by so much relative errors have to grow\n"
      "reference: the recursive Newton-Euler reference in the same scalar, at and around that state\n"
      "ratio: the largest of code to reference, of which less than one unit counts as one; LOST: above {:g}\n",
      report.options.ratio);
  for (const std::string& line : report.left_out) text += "left out: " + line + "\n";
  return text + "\nthe worst state, and those that do not pass, for flatdyn eval --function NAME --states FILE.csv:\n" +
         states_to_show(report);
}

ordered_json stress_json(const StressReport& report) {
  ordered_json json = {{"robot", report.robot},         {"seed", report.options.seed}, {"bound", report.options.bound},
                       {"ratio", report.options.ratio}, {"passed", report.passed()},   {"left_out", report.left_out}};
  json["rows"] = ordered_json::array();
  for (const StressRow& row : report.rows) json["rows"].push_back(stress_row_json(report, row));
  return json;
}

}  // namespace flatdyn
