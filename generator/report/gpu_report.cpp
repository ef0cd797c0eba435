// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/gpu_report.hpp"

#include <fmt/format.h>

#include "report/fields.hpp"

namespace flatdyn {
namespace {

const ReportFields<GpuRow>& gpu_fields() {
  static const ReportFields<GpuRow> all = {{"robot", "robot", &GpuRow::robot},
                                           {"function", "function", &GpuRow::function},
                                           {"layout", "layout", &GpuRow::layout},
                                           {"scalar", "scalar", &GpuRow::scalar},
                                           {"ns a state", "ns_per_state", &GpuRow::time, "{:.4f}"},
                                           {"registers", "registers", &GpuRow::registers},
                                           {"local bytes", "local_bytes", &GpuRow::local_bytes},
                                           {"GB/s", "gb_per_s", &GpuRow::throughput, "{:.0f}"},
                                           {"error, ulp", "error_ulp", &GpuRow::error, "{:.1f}"},
                                           {"kernels", "kernels", &GpuRow::kernels},
                                           {"one state, us", "single_state_us", &GpuRow::single, "{:.1f}"}};
  return all;
}

}  // namespace

std::string gpu_text(const GpuReport& report) {
  std::string text = report.device + "\n\n" + table_of(gpu_fields(), report.rows);
  for (const std::string& line : report.failures) text += line + "\n";
  return text;
}

nlohmann::ordered_json gpu_json(const GpuReport& report) {
  return {{"device", report.device}, {"gpu", objects_of(gpu_fields(), report.rows)}, {"failures", report.failures}};
}

}  // namespace flatdyn
