// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/stress_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "report/fields.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

std::string stress_verdict(const StressReport& report, const StressRow& row) {
  const bool is_lost = row.lost.ratio > report.options.ratio;
  const bool is_large = row.worst.error.scaled > report.options.bound;
  const std::string verdict = is_lost ? "LOST" : is_large ? "LARGE" : "ok";
  return row.refused > 0 ? fmt::format("{} ({} of {} refused)", verdict, row.refused, row.tried) : verdict;
}

ordered_json finding_json(const StressReport& report, const StressRow& row, const StressFinding& finding) {
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

ordered_json variants_json(const StressRow& row) {
  ordered_json json;
  for (const auto& [name, largest] : row.variants) json[name] = largest;
  return json;
}

ReportFields<StressRow> stress_fields(const StressReport& report) {
  return {{"function", "function", &StressRow::function},
          {"scalar", "scalar", &StressRow::scalar},
          {"", "states", &StressRow::states},
          {"", "tried", &StressRow::tried},
          {"", "refused", &StressRow::refused},
          {"random: p99", "random.p99", [](auto& row) { return row.random.percentile_99; }, "{:.2g}"},
          {"max", "random.max", [](auto& row) { return row.random.largest; }, "{:.2g}"},
          {"edge", "edge_max", &StressRow::edge, "{:.2g}"},
          {"", "variants", variants_json},
          {"worst", "", [](auto& row) { return row.worst.error.scaled; }, "{:.2g}"},
          {"found", "", [](auto& row) { return row.worst.where; }},
          {"variant", "", [](auto& row) { return row.worst.variant; }},
          {"condition", "", [](auto& row) { return row.worst.error.condition; }, "{:.2g}"},
          {"reference", "", [](auto& row) { return row.worst.reference; }, "{:.2g}"},
          {"ratio", "", [](auto& row) { return row.lost.ratio; }, "{:.2g}"},
          {" ", "", [&report](auto& row) { return stress_verdict(report, row); }},
          {"", "worst", [&report](auto& row) { return finding_json(report, row, row.worst); }},
          {"", "lost", [&report](auto& row) { return finding_json(report, row, row.lost); }},
          {"", "histogram", &StressRow::histogram},
          {"", "passed", &StressRow::passed}};
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
  std::size_t states = 0;
  for (const StressRow& row : report.rows) states = std::max(states, row.states);
  std::string text = fmt::format("{}: up to {} random states each\n\n{}\n", report.robot, states,
                                 table_of(stress_fields(report), report.rows));
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
  return {{"robot", report.robot},
          {"seed", report.options.seed},
          {"bound", report.options.bound},
          {"ratio", report.options.ratio},
          {"passed", report.passed()},
          {"left_out", report.left_out},
          {"rows", objects_of(stress_fields(report), report.rows)}};
}

}  // namespace flatdyn
