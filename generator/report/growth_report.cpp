// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/growth_report.hpp"

#include <fmt/format.h>

#include "report/cost_json.hpp"
#include "report/fields.hpp"
#include "report/plot/plot.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

double megabytes(const GrowthRow& row) { return static_cast<double>(row.peak_kilobytes) / 1024; }

const ReportFields<GrowthRow>& growth_fields() {
  static const ReportFields<GrowthRow> all = {
      {"  joints", "joints", &GrowthRow::joints, "  {}"},
      {"mul", "mul", [](auto& row) { return row.operations.multiplications; }},
      {"add", "add", [](auto& row) { return row.operations.additions; }},
      {"sin/cos", "sincos", [](auto& row) { return row.operations.trigonometric; }},
      {"ns", "", [](auto& row) { return row.time.median; }, "{:.4g}"},
      {"quartiles", "", [](auto& row) { return fmt::format("{:.4g} .. {:.4g}", row.time.low, row.time.high); }},
      {"", "ns", [](auto& row) { return quartiles_json(row.time); }},
      {"scaled: max", "scaled_error", &GrowthRow::scaled_error, "{:.2g}"},
      {"generated in s", "generation_s", &GrowthRow::generation, "{:.2g}"},
      {"compiled in s", "compilation_s", &GrowthRow::compilation, "{:.2g}"},
      {"compiler's MB", "", megabytes, "{:.0f}"},
      {"", "compiler_kilobytes", &GrowthRow::peak_kilobytes}};
  return all;
}

bool is_fitted(const GrowthCurve& curve) { return curve.rows.size() > 1; }

std::string exponents_of(const GrowthCurve& curve) {
  if (!is_fitted(curve)) return "one size: no exponents\n";
  return fmt::format("operations ~ n^{:.2f}, time ~ n^{:.2f} from {} joints\n", curve.operation_exponent,
                     curve.time_exponent, curve.fitted_from);
}

std::string text_of(const GrowthCurve& curve) {
  return fmt::format("{}, {}: {}{}\n", curve.shape, curve.function, exponents_of(curve),
                     table_of(growth_fields(), curve.rows));
}

ordered_json curve_json(const GrowthCurve& curve) {
  ordered_json json = {{"shape", curve.shape}, {"function", curve.function}};
  const auto exponent = [&](double fitted) { return is_fitted(curve) ? ordered_json(fitted) : ordered_json(); };
  json["fitted_from"] = is_fitted(curve) ? ordered_json(curve.fitted_from) : ordered_json();
  json["operation_exponent"] = exponent(curve.operation_exponent);
  json["time_exponent"] = exponent(curve.time_exponent);
  json["sizes"] = objects_of(growth_fields(), curve.rows);
  return json;
}

using GrowthQuantity = double (*)(const GrowthRow&);

Panel growth_panel(const GrowthReport& report, const std::string& title, GrowthQuantity quantity) {
  Panel panel{title, "", "", {}, PanelStyle::marked};
  for (const GrowthCurve& curve : report.curves) {
    Series series{curve.shape + ", " + curve.function, {}, {}};
    for (const GrowthRow& row : curve.rows) {
      series.x.push_back(row.joints);
      series.y.push_back(quantity(row));
    }
    panel.series.push_back(series);
  }
  return panel;
}

}  // namespace

std::string growth_text(const GrowthReport& report) {
  std::string text = fmt::format("{}, {}\n\n", report.compiler, report.flags);
  for (const GrowthCurve& curve : report.curves) text += text_of(curve);
  return text +
         "n: joints; exponents by least squares on logarithms. ns: one call in double\n"
         "scaled: error in units of the last place of the terms' size. compiled: the function alone, processor time\n";
}

ordered_json growth_json(const GrowthReport& report) {
  ordered_json json = {{"compiler", report.compiler}, {"flags", report.flags}, {"growth", ordered_json::array()}};
  for (const GrowthCurve& curve : report.curves) json["growth"].push_back(curve_json(curve));
  return json;
}

std::string growth_plot(const GrowthReport& report) {
  std::vector<Panel> panels = {growth_panel(report, "multiplications and additions",
                                            [](const GrowthRow& r) { return 1.0 * r.operations.arithmetic(); }),
                               growth_panel(report, "one call, ns", [](const GrowthRow& r) { return r.time.median; }),
                               growth_panel(report, "generation, s", [](const GrowthRow& r) { return r.generation; }),
                               growth_panel(report, "compilation, s", [](const GrowthRow& r) { return r.compilation; }),
                               growth_panel(report, "compiler's memory, MB", megabytes)};
  panels.back().x_label = "joints";
  return svg_plot("Growth with the number of joints", panels);
}

}  // namespace flatdyn
