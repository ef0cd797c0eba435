// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/bench_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

// A time with three digits, as many as the machine's noise leaves.
std::string nanoseconds(double time) {
  return time < 10 ? fmt::format("{:.2f}", time) : fmt::format("{:.{}f}", time, time < 100 ? 1 : 0);
}

std::string quartiles_of(const Quartiles& time) { return nanoseconds(time.low) + " .. " + nanoseconds(time.high); }

std::string table_of(const BenchFunction& function) {
  std::vector<std::vector<std::string>> rows = {{"  variant", "operations", "ns", "quartiles", "ratio", "scaled: p99",
                                                 "max", function.unit + ": p99", "max", "bytes", "front"}};
  for (const BenchRow& row : function.rows) {
    rows.push_back({"  " + row.variant, row.is_peer ? "" : std::to_string(row.operations.arithmetic()),
                    nanoseconds(row.time.median), quartiles_of(row.time), fmt::format("{:.2f}", row.ratio),
                    fmt::format("{:.2g}", row.scaled.percentile_99), fmt::format("{:.2g}", row.scaled.largest),
                    fmt::format("{:.2g}", row.absolute.percentile_99), fmt::format("{:.2g}", row.absolute.largest),
                    row.is_peer ? "" : std::to_string(row.bytes), row.on_front ? "*" : ""});
  }
  return fmt::format("{}: {}\n{}\n", function.name, to_string(function.operations), aligned_table(rows));
}

std::string table_of(const BenchStages& stages) {
  std::vector<std::vector<std::string>> rows = {{"  step", "operations", "ns", "quartiles"}};
  for (const BenchStep& step : stages.steps) {
    rows.push_back({"  " + step.name, std::to_string(step.operations.arithmetic()), nanoseconds(step.time.median),
                    quartiles_of(step.time)});
  }
  return fmt::format("stages of {}\n{}\n", fmt::join(stages.functions, ", "), aligned_table(rows));
}

ordered_json bench_json_of(const Quartiles& time) {
  return {{"low", time.low}, {"median", time.median}, {"high", time.high}};
}

ordered_json bench_json_of(const OperationCount& count) {
  return {{"mul", count.multiplications},
          {"add", count.additions},
          {"div", count.divisions},
          {"sincos", count.trigonometric}};
}

ordered_json bench_json_of(const BenchRow& row) {
  ordered_json json = {{"variant", row.variant}, {"peer", row.is_peer}, {"whole", row.is_whole}};
  if (!row.is_peer) json["operations"] = bench_json_of(row.operations);
  json["ns"] = bench_json_of(row.time);
  json["rounds"] = row.rounds;
  json["ratio"] = row.ratio;
  json["scaled_error"] = {{"p99", row.scaled.percentile_99}, {"max", row.scaled.largest}};
  json["error"] = {{"p99", row.absolute.percentile_99}, {"max", row.absolute.largest}};
  json["states"] = row.states;
  if (!row.is_peer) json["bytes"] = row.bytes;
  json["front"] = row.on_front;
  return json;
}

ordered_json bench_json_of(const BenchFunction& function) {
  ordered_json json = {{"name", function.name}, {"unit", function.unit}};
  json["operations"] = bench_json_of(function.operations);
  json["variants"] = ordered_json::array();
  for (const BenchRow& row : function.rows) json["variants"].push_back(bench_json_of(row));
  return json;
}

ordered_json bench_json_of(const BenchStages& stages) {
  ordered_json json = {{"functions", stages.functions}, {"steps", ordered_json::array()}};
  for (const BenchStep& step : stages.steps) {
    json["steps"].push_back(
        {{"name", step.name}, {"operations", bench_json_of(step.operations)}, {"ns", bench_json_of(step.time)}});
  }
  return json;
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
  for (const BenchFunction& function : report.functions) text += table_of(function);
  if (!report.stages.steps.empty()) text += table_of(report.stages);
  return text + legend_of(report);
}

ordered_json bench_json(const BenchReport& report) {
  ordered_json json = {{"robot", report.robot},
                       {"compiler", report.compiler},
                       {"flags", report.flags},
                       {"seconds", report.seconds},
                       {"left_out", report.left_out}};
  json["functions"] = ordered_json::array();
  for (const BenchFunction& function : report.functions) json["functions"].push_back(bench_json_of(function));
  if (!report.stages.steps.empty()) json["stages"] = bench_json_of(report.stages);
  return json;
}

}  // namespace flatdyn
