// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/base_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/wrap.hpp"
#include "derivation/parameters/unidentifiable.hpp"
#include "report/combination_table.hpp"
#include "report/number_json.hpp"
#include "report/numbers.hpp"

namespace flatdyn {
namespace {

// A parameter's name and the reason why it cannot be identified.
using Unseen = std::pair<std::string, std::string>;

std::vector<Unseen> unseen_parameters(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set,
                                      ParameterFrames frames) {
  std::vector<Unseen> unseen;
  if (frames == ParameterFrames::canonical) {
    for (const Unidentifiable& each : unidentifiable(mechanism, base, set)) {
      unseen.emplace_back(parameter_name(each.index, mechanism.base_bodies()), each.reason);
    }
    return unseen;
  }
  const std::vector<FileParameter> parameters = file_parameters(mechanism, set);
  for (const Unidentifiable& each : unidentifiable_in_file(mechanism, base, parameters)) {
    unseen.emplace_back(parameters[static_cast<std::size_t>(each.index)].name, each.reason);
  }
  return unseen;
}

nlohmann::ordered_json unseen_json(const std::vector<Unseen>& unseen) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& [parameter, reason] : unseen) json.push_back({{"parameter", parameter}, {"why", reason}});
  return json;
}

std::string base_table(const Mechanism& mechanism, const BaseParameters& base, const Combinations& combinations,
                       bool has_names) {
  const std::vector<Number> values = base_values(mechanism, base);
  const NumberText value_text(mechanism);
  std::vector<CombinationRow> rows;
  for (int k = 0; k < base.size(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    rows.push_back({k, {std::to_string(k), value_text(values[row])}});
    if (has_names)
      rows.back().cells.insert(rows.back().cells.begin() + 1,
                               parameter_name(base.columns[row], mechanism.base_bodies()));
  }
  if (has_names) return combination_table({"pi_b", "name", "value"}, rows, combinations);
  return combination_table({"pi_b", "value"}, rows, combinations);
}

nlohmann::ordered_json coefficients_json(const std::vector<CombinationTerm>& terms) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, coefficient] : terms) json[name] = coefficient_text(coefficient);
  return json;
}

nlohmann::ordered_json file_parameters_json(const Mechanism& mechanism, ParameterSet set) {
  const NumberText text(mechanism);
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const FileParameter& parameter : file_parameters(mechanism, set)) {
    json[parameter.name] = number_json(parameter.value, text);
  }
  return json;
}

}  // namespace

std::size_t parameter_count(const Mechanism& mechanism, ParameterSet set, ParameterFrames frames) {
  if (frames == ParameterFrames::file) return file_parameters(mechanism, set).size();
  const std::vector<bool> present = parameters_in(mechanism, set);
  return static_cast<std::size_t>(std::count(present.begin(), present.end(), true));
}

std::vector<std::pair<std::string, std::string>> unidentifiable_names(const Mechanism& mechanism,
                                                                      const BaseParameters& base, ParameterSet set,
                                                                      ParameterFrames frames) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const auto& [parameter, reason] : unseen_parameters(mechanism, base, set, frames)) {
    if (lines.empty() || lines.back().second != reason) lines.emplace_back("", reason);
    lines.back().first += (lines.back().first.empty() ? "" : ", ") + parameter;
  }
  return lines;
}

std::string describe_base(const Mechanism& mechanism, ParameterSet set, ParameterFrames frames) {
  const BaseParameters base = base_parameters(mechanism, set);
  const Combinations combinations(mechanism, base, frames, set);
  const bool has_own_names = has_names_of_file(mechanism, frames);
  std::string text = wrapped(fmt::format("{} base parameters of {} parameters, in {}\n\n", base.size(),
                                         parameter_count(mechanism, set, frames), frames_text(mechanism, frames)),
                             kReportWidth);
  text += base_table(mechanism, base, combinations, has_own_names);
  text += note_on_names(mechanism, frames);
  const auto unseen = unidentifiable_names(mechanism, base, set, frames);
  if (!unseen.empty()) text += "\nnot identifiable at all:\n";
  for (const auto& [names, reason] : unseen) {
    text += wrapped(fmt::format("  {}: {}\n", names, reason), kReportWidth);
  }
  return text;
}

nlohmann::ordered_json base_json(const Mechanism& mechanism, ParameterSet set, ParameterFrames frames) {
  const BaseParameters base = base_parameters(mechanism, set);
  const std::vector<Number> values = base_values(mechanism, base);
  const bool has_file = frames == ParameterFrames::file;
  const Combinations canonical(mechanism, base, ParameterFrames::canonical, set), in_file(mechanism, base, frames, set);
  nlohmann::ordered_json json = {{"frames", name_of(frames)}};
  json["base_parameters"] = nlohmann::ordered_json::array();
  for (int k = 0; k < base.size(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    nlohmann::ordered_json entry = {{"kept", parameter_name(base.columns[row], mechanism.base_bodies())},
                                    {"combination", canonical.text(k, kJsonDigits)},
                                    {"coefficients", coefficients_json(canonical.terms(k))}};
    if (has_file) {
      entry["file_combination"] = in_file.text(k, kJsonDigits);
      entry["file_coefficients"] = coefficients_json(in_file.terms(k));
    }
    if (!has_symbols(values[row])) entry["value"] = nearest_double(values[row]);
    json["base_parameters"].push_back(entry);
  }
  json["not_identifiable"] = unseen_json(unseen_parameters(mechanism, base, set, ParameterFrames::canonical));
  if (!has_file) return json;
  json["file_not_identifiable"] = unseen_json(unseen_parameters(mechanism, base, set, frames));
  json["file_parameters"] = file_parameters_json(mechanism, set);
  return json;
}

}  // namespace flatdyn
