// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/base_report.hpp"

#include <fmt/format.h>

#include "diagnostics/table.hpp"
#include "report/numbers.hpp"
#include "symbolic/notation/combination_text.hpp"
#include "symbolic/notation/number_text.hpp"
#include "symbolic/parameters/unidentifiable.hpp"

namespace flatdyn {
namespace {

// One line per reason, with the parameters to which it applies.
std::string reasons_text(const std::vector<Unidentifiable>& unseen) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const Unidentifiable& each : unseen) {
    if (lines.empty() || lines.back().second != each.reason) lines.emplace_back("", each.reason);
    lines.back().first += (lines.back().first.empty() ? "" : ", ") + parameter_name(each.index);
  }
  std::string text;
  for (const auto& [names, reason] : lines) text += fmt::format("  {}: {}\n", names, reason);
  return text;
}

}  // namespace

std::string describe_base(const Mechanism& mechanism, ParameterSet set) {
  const BaseParameters base = base_parameters(mechanism, set);
  const std::vector<Number> values = base_values(mechanism, base);
  const std::vector<bool> present = parameters_in(mechanism, set);
  const NumberText value_text(mechanism);
  std::string text = fmt::format(
      "{} base parameters of {} parameters; link i is moved by the i-th joint {}, its parameters are "
      "about the origin of its canonical frame, as above\n\n",
      base.size(), std::count(present.begin(), present.end(), true),
      mechanism.is_coupled() ? "that moves, in depth-first order" : "of q");
  std::vector<std::vector<std::string>> rows = {{"pi_b", "value", "combination"}};
  for (int k = 0; k < base.size(); ++k) {
    rows.push_back({std::to_string(k), value_text(values[static_cast<std::size_t>(k)]), combination_text(base, k)});
  }
  text += aligned_table(rows);
  const std::string reasons = reasons_text(unidentifiable(mechanism, base, set));
  return reasons.empty() ? text : text + "\nnot identifiable at all:\n" + reasons;
}

nlohmann::ordered_json unidentifiable_json(const Mechanism& mechanism, const BaseParameters& base, ParameterSet set) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Unidentifiable& each : unidentifiable(mechanism, base, set)) {
    json.push_back({{"parameter", parameter_name(each.index)}, {"why", each.reason}});
  }
  return json;
}

nlohmann::ordered_json base_json(const Mechanism& mechanism, ParameterSet set) {
  const BaseParameters base = base_parameters(mechanism, set);
  const std::vector<Number> values = base_values(mechanism, base);
  nlohmann::ordered_json json;
  json["base_parameters"] = nlohmann::ordered_json::array();
  for (int k = 0; k < base.size(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    nlohmann::ordered_json entry = {{"kept", parameter_name(base.columns[row])},
                                    {"combination", combination_text(base, k, kJsonDigits)}};
    for (const auto& [index, coefficient] : base.combination[row]) {
      entry["coefficients"][parameter_name(index)] = coefficient_text(coefficient);
    }
    if (!has_symbols(values[row])) entry["value"] = nearest_double(values[row]);
    json["base_parameters"].push_back(entry);
  }
  json["not_identifiable"] = unidentifiable_json(mechanism, base, set);
  return json;
}

}  // namespace flatdyn
