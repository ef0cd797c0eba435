// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/diagnostics/version.hpp"
#include "report/identification_files.hpp"

namespace flatdyn {
namespace {

// A literal of Python, with all digits of a double; nan where a number is not told.
std::string literal(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "nan"; }

std::string quoted_literal(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

// A tuple with as many entries to a line as fit.
std::string tuple_of(const std::vector<std::string>& entries, const std::string& indent) {
  constexpr std::size_t kWidth = 118;
  std::string text = "(", line;
  for (const std::string& each : entries) {
    if (!line.empty() && indent.size() + line.size() + each.size() + 2 > kWidth) {
      text += "\n" + indent + line;
      line.clear();
    }
    line += (line.empty() ? "" : " ") + each + ",";
  }
  return text + "\n" + indent + line + "\n" + indent.substr(0, indent.size() - 4) + ")";
}

template <class Entry>
std::string tuple_of_all(Eigen::Index count, const std::string& indent, const Entry& entry) {
  std::vector<std::string> entries;
  for (Eigen::Index k = 0; k < count; ++k) entries.push_back(entry(k));
  return tuple_of(entries, indent);
}

}  // namespace

std::string results_module(const TorqueEquations& equations, const Identification& found, ParameterFrames frames) {
  const Estimate& estimate = found.estimate;
  const TorqueModel& model = equations.model();
  const Eigen::Index b = equations.parameters() - equations.corrections();
  const Combinations combinations(model.mechanism(), model.base(), frames);
  const auto is_told = [&](Eigen::Index k) { return std::isfinite(estimate.standard_deviations(k)); };
  const std::string indent(4, ' ');
  const auto name = [&](Eigen::Index k) { return quoted_literal(equations.names()[static_cast<std::size_t>(k)]); };
  const auto combination = [&](Eigen::Index k) {
    return quoted_literal(k < model.parameters() ? combinations.text(static_cast<int>(k)) : "");
  };
  const Eigen::VectorXd file = equations.file_values();
  std::string text = fmt::format(
      "\"\"\"The dynamic parameters of a robot that flatdyn {} identified from measured motion.\n\n"
      "Base parameters in SI units, by the names of `flatdyn identify`, then offsets and the like where they were\n"
      "estimated. What the motion does not tell has the deviation nan. arrays() gives NumPy arrays.\n\"\"\"\n\n"
      "from math import nan\n\n",
      kProgramVersion);
  text += "ROBOT = " + quoted_literal(model.mechanism().name) + "\n\n";
  if (const std::optional<double>& temperature = equations.further().temperature) {
    text +=
        fmt::format("# F_v and F_s are those at so many degrees Celsius.\nTEMPERATURE = {}\n\n", literal(*temperature));
  }
  text += "NAMES = " + tuple_of_all(b, indent, name) + "\n\n";
  text += "# The sums of the links' parameters that they are.\nCOMBINATIONS = " + tuple_of_all(b, indent, combination) +
          "\n\n";
  text += "VALUES = " + tuple_of_all(b, indent, [&](auto k) { return literal(estimate.values(k)); }) + "\n\n";
  text += "STANDARD_DEVIATIONS = " +
          tuple_of_all(b, indent, [&](auto k) { return literal(estimate.standard_deviations(k)); }) + "\n\n";
  text += "# Of the robot file.\nFILE_VALUES = " + tuple_of_all(b, indent, [&](auto k) { return literal(file(k)); }) +
          "\n\n";
  text += "COVARIANCE = (\n";
  for (Eigen::Index i = 0; i < b; ++i) {
    text += indent +
            tuple_of_all(
                b, indent + indent,
                [&](auto k) { return literal(is_told(i) && is_told(k) ? estimate.covariance(i, k) : std::nan("")); }) +
            ",\n";
  }
  return text +
         ")\n\n\ndef arrays():\n"
         "    \"\"\"VALUES and STANDARD_DEVIATIONS of shape (b,) and COVARIANCE of shape (b, b).\"\"\"\n"
         "    import numpy\n\n"
         "    return numpy.array(VALUES), numpy.array(STANDARD_DEVIATIONS), numpy.array(COVARIANCE)\n";
}

}  // namespace flatdyn
