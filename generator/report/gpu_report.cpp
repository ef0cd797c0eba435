// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/gpu_report.hpp"

#include <fmt/format.h>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

nlohmann::ordered_json gpu_row_json(const GpuRow& row) {
  return {{"robot", row.robot},
          {"function", row.function},
          {"layout", row.layout},
          {"scalar", row.scalar},
          {"ns_per_state", row.time},
          {"registers", row.registers},
          {"local_bytes", row.local_bytes},
          {"gb_per_s", row.throughput},
          {"error_ulp", row.error},
          {"kernels", row.kernels},
          {"single_state_us", row.single}};
}

}  // namespace

std::string gpu_text(const GpuReport& report) {
  std::vector<std::vector<std::string>> rows = {{"robot", "function", "layout", "scalar", "ns a state", "registers",
                                                 "local bytes", "GB/s", "error, ulp", "kernels", "one state, us"}};
  for (const GpuRow& row : report.rows) {
    rows.push_back({row.robot, row.function, row.layout, row.scalar, fmt::format("{:.4f}", row.time),
                    std::to_string(row.registers), std::to_string(row.local_bytes),
                    fmt::format("{:.0f}", row.throughput), fmt::format("{:.1f}", row.error),
                    std::to_string(row.kernels), fmt::format("{:.1f}", row.single)});
  }
  std::string text = report.device + "\n\n" + aligned_table(rows);
  for (const std::string& line : report.failures) text += line + "\n";
  return text;
}

nlohmann::ordered_json gpu_json(const GpuReport& report) {
  nlohmann::ordered_json json = {{"device", report.device}, {"gpu", nlohmann::ordered_json::array()}};
  for (const GpuRow& row : report.rows) json["gpu"].push_back(gpu_row_json(row));
  json["failures"] = report.failures;
  return json;
}

}  // namespace flatdyn
