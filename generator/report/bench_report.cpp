// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/bench_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/code_size.hpp"
#include "report/cost_json.hpp"
#include "report/fields.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

// A time with three digits, as many as the machine's noise leaves.
std::string nanoseconds(double time) {
  return time < 10 ? fmt::format("{:.2f}", time) : fmt::format("{:.{}f}", time, time < 100 ? 1 : 0);
}

std::string quartiles_of(const Quartiles& time) { return nanoseconds(time.low) + " .. " + nanoseconds(time.high); }

// A peer's operations and bytes are not known, and the bytes where the compiler tunes for this processor.
ReportFields<BenchRow> bench_fields(const std::string& unit) {
  using Json = ordered_json;
  return {{"  variant", "variant", &BenchRow::variant, "  {}"},
          {"", "peer", &BenchRow::is_peer},
          {"", "whole", &BenchRow::is_whole},
          {"operations", "", [](auto& row) { return row.is_peer ? Json() : Json(row.operations.arithmetic()); }},
          {"", "operations", [](auto& row) { return row.is_peer ? Json() : operations_json(row.operations); }},
          {"ns", "", [](auto& row) { return nanoseconds(row.time.median); }},
          {"quartiles", "", [](auto& row) { return quartiles_of(row.time); }},
          {"", "ns", [](auto& row) { return quartiles_json(row.time); }},
          {"", "rounds", &BenchRow::rounds},
          {"ratio", "ratio", &BenchRow::ratio, "{:.2f}"},
          {"scaled: p99", "scaled_error.p99", [](auto& row) { return row.scaled.percentile_99; }, "{:.2g}"},
          {"max", "scaled_error.max", [](auto& row) { return row.scaled.largest; }, "{:.2g}"},
          {unit + ": p99", "error.p99", [](auto& row) { return row.absolute.percentile_99; }, "{:.2g}"},
          {"max", "error.max", [](auto& row) { return row.absolute.largest; }, "{:.2g}"},
          {"", "states", &BenchRow::states},
          {"bytes", "bytes", [](auto& row) { return row.bytes > 0 ? Json(row.bytes) : Json(); }},
          {"front", "", [](auto& row) { return row.on_front ? "*" : ""; }},
          {"", "front", &BenchRow::on_front}};
}

const ReportFields<BenchStep>& step_fields() {
  static const ReportFields<BenchStep> all = {
      {"  step", "name", &BenchStep::name, "  {}"},
      {"operations", "", [](auto& step) { return step.operations.arithmetic(); }},
      {"", "operations", [](auto& step) { return operations_json(step.operations); }},
      {"ns", "", [](auto& step) { return nanoseconds(step.time.median); }},
      {"quartiles", "", [](auto& step) { return quartiles_of(step.time); }},
      {"", "ns", [](auto& step) { return quartiles_json(step.time); }}};
  return all;
}

// Explains the columns and lists what is missing.
std::string legend_of(const BenchReport& report) {
  std::string text =
      "ns: one call, in a batch one state; median and quartiles over the rounds. ratio: to \"double\", or the first "
      "one asked for\n"
      "operations: additions and multiplications; scaled: error in units of the last place of double, of the terms' "
      "size; then in the function's unit\n"
      "front: nothing here that does the whole work is both faster and more accurate (p99)\n";
  if (!report.stages.steps.empty()) {
    text +=
        "staged: the call alone, on a stage that has been made; \"all in stages\" makes them and calls all of these, "
        "in double\n";
  }
  for (const std::string& line : report.left_out) text += "left out: " + line + "\n";
  return text;
}

}  // namespace

std::string bench_text(const BenchReport& report) {
  std::string text = fmt::format("{}: {}, {}\n\n", report.robot, report.compiler, report.flags);
  for (const BenchFunction& function : report.functions) {
    text += fmt::format("{}: {}\n{}\n", function.name, to_string(function.operations),
                        table_of(bench_fields(function.unit), function.rows));
  }
  if (!report.stages.steps.empty()) {
    text += fmt::format("stages of {}\n{}\n", fmt::join(report.stages.functions, ", "),
                        table_of(step_fields(), report.stages.steps));
  }
  return text + legend_of(report);
}

ordered_json bench_json(const BenchReport& report) {
  ordered_json json = {{"robot", report.robot},
                       {"compiler", report.compiler},
                       {"flags", report.flags},
                       {"seconds", report.seconds},
                       {"left_out", report.left_out}};
  json["functions"] = ordered_json::array();
  for (const BenchFunction& function : report.functions) {
    json["functions"].push_back(
        {{"name", function.name},
         {"unit", function.unit},
         {"operations", operations_json(function.operations)},
         {"estimated_bytes", code_bytes(function.operations, function.written_entries, function.written_zeros)},
         {"variants", objects_of(bench_fields(function.unit), function.rows)}});
  }
  if (report.stages.steps.empty()) return json;
  json["stages"] = {{"functions", report.stages.functions}, {"steps", objects_of(step_fields(), report.stages.steps)}};
  return json;
}

}  // namespace flatdyn
