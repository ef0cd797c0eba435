// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "code/emit/page.hpp"
#include "derivation/notation/combination_text.hpp"
#include "derivation/notation/number_text.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "graph/count.hpp"
#include "report/base_report.hpp"
#include "report/describe.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;
using nlohmann::ordered_json;

// The text of a cell: a number, an expression, or nothing.
std::string cell(const ordered_json& json, const char* key) {
  if (!json.contains(key)) return "–";
  const ordered_json& value = json.at(key);
  return value.is_string() ? value.get<std::string>() : fmt::format("{:.6g}", value.get<double>());
}

// The operations that a pass saved in a function, summed over its rounds.
int saved_by(const OptimisedFunction& each, const std::string& pass) {
  int saved = 0;
  for (const PassRecord& record : each.passes) {
    if (record.pass == pass) saved += record.before.arithmetic() - record.after.arithmetic();
  }
  return saved;
}

}  // namespace

void write_operations(data& page, const std::vector<OptimisedFunction>& functions) {
  data rows(data::type::list), passes(data::type::list);
  for (const OptimisedFunction& each : functions) {
    const OperationCount count = count_operations(each.function);
    const int derived = count_operations(each.derived).arithmetic();
    std::vector<std::string> saved;
    for (const Pass& pass : pass_table()) saved.push_back(std::to_string(saved_by(each, pass.name)));
    data row;
    row["name"] = each.function.name;
    row["mul"] = std::to_string(count.multiplications);
    row["add"] = std::to_string(count.additions);
    row["div"] = std::to_string(count.divisions);
    row["trig"] = std::to_string(count.trigonometric);
    row["derived"] = std::to_string(derived);
    row["kept"] = fmt::format("{:.0f}", derived == 0 ? 100.0 : 100.0 * count.arithmetic() / derived);
    row["saved"] = list_of(saved);
    rows << row;
  }
  for (const Pass& pass : pass_table()) {
    data item;
    item["name"] = std::string(pass.name);
    item["purpose"] = std::string(pass.purpose);
    passes << item;
  }
  page["functions"] = data(rows);
  page["passes"] = data(passes);
}

namespace {

data unseen_rows(const std::vector<std::pair<std::string, std::string>>& unseen) {
  data rows(data::type::list);
  for (const auto& [names, why] : unseen) {
    data row;
    row["names"] = names;
    row["why"] = why;
    rows << row;
  }
  return rows;
}

}  // namespace

void write_base(data& page, const Mechanism& mechanism, ParameterSet set, ParameterFrames frames) {
  constexpr int kAtOnce = 16;
  const BaseParameters base = base_parameters(mechanism, set);
  const std::vector<Number> values = base_values(mechanism, base);
  const Combinations combinations(mechanism, base, frames, set);
  const NumberText value_text(mechanism);
  data rows(data::type::list);
  for (int k = 0; k < base.size(); ++k) {
    data row;
    row["index"] = std::to_string(k + 1);
    row["value"] = value_text(values[static_cast<std::size_t>(k)]);
    row["combination"] = combinations.text(k);
    rows << row;
  }
  const auto unseen = unidentifiable_names(mechanism, base, set, frames);
  page["base_summary"] = fmt::format(
      "The torques depend on {} base parameters, made of {} parameters of the links, rotors and friction, in {}.",
      base.size(), parameter_count(mechanism, set, frames), frames_text(mechanism, frames));
  page["base?"] = base.size() > 0;
  page["base_open?"] = base.size() <= kAtOnce;
  page["base"] = data(rows);
  page["unseen?"] = !unseen.empty();
  page["unseen"] = unseen_rows(unseen);
}

void write_certificate(data& page, const std::optional<Certificate>& certificate) {
  page["certificate?"] = certificate.has_value();
  if (!certificate) return;
  data rows(data::type::list);
  for (const CertifiedFunction& function : certificate->functions) {
    for (const CertifiedOutput& output : function.outputs) {
      data row;
      row["output"] = output.name;
      row["bound"] = fmt::format("{:.3e}", output.bound);  // all digits of the bound
      row["seen"] = fmt::format("{:.1e}", output.observed);
      row["unit"] = output.unit;
      row["effort"] = output.effort ? fmt::format("{:.1e} %", 100 * output.bound / *output.effort) : "–";
      rows << row;
    }
  }
  page["certificate"] = data(rows);
  page["certificate_states"] = std::to_string(certificate->options.observed.states);
}

void write_worst_states(data& page, const std::optional<WorstStates>& states) {
  page["worst?"] = states.has_value();
  if (!states) return;
  data rows(data::type::list);
  for (const WorstState& state : states->rows) {
    data row;
    row["function"] = state.function;
    row["scalar"] = state.scalar;
    row["error"] = state.error;
    row["found"] = state.found;
    row["variant"] = state.variant;
    row["condition"] = state.condition;
    row["reference"] = state.reference;
    row["ratio"] = state.ratio;
    row["verdict"] = std::string(state.passed ? "ok" : "too large");
    row["state"] = state.state;
    rows << row;
  }
  page["worst"] = data(rows);
  page["worst_bound"] = states->bound;
  page["worst_ratio"] = states->ratio;
}

namespace {

// "3", or "3–6" for the entries of a spherical joint.
std::string numbers_text(int first, int count) {
  return count == 1 ? std::to_string(first) : fmt::format("{}–{}", first, first + count - 1);
}

// The joints of the model; the first bodies, which are a floating base's motion, are not joints.
data joint_rows(const ordered_json& joints, const Mechanism& mechanism) {
  constexpr int kQuaternion = 4;
  data rows(data::type::list);
  int number = 1;
  for (int i = mechanism.base_bodies(); i < mechanism.body_count(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    if (is_inside_joint(body)) continue;
    const ordered_json& joint = joints.at(static_cast<std::size_t>(i));
    const int parent = parent_of_joint(mechanism, i), entries = body.spherical > 0 ? kQuaternion : 1;
    data row;
    row["number"] = numbers_text(number, entries);
    number += entries;
    row["name"] = joint_name(body);
    row["link"] = joint.at("link").get<std::string>();
    row["after"] =
        parent < mechanism.base_bodies() ? "base" : joint_name(mechanism.bodies[static_cast<std::size_t>(parent)]);
    row["type"] = joint.at("type").get<std::string>();
    row["lower"] = cell(joint, "lower");
    row["upper"] = cell(joint, "upper");
    row["speed"] = cell(joint, "velocity");
    row["effort"] = cell(joint, "effort");
    row["mass"] = cell(joint.at("canonical"), "mass");
    rows << row;
  }
  return rows;
}

std::vector<std::string> snap_lines(const std::vector<Snap>& snaps, const SnapEffects& effects) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < snaps.size(); ++k) {
    lines.push_back(fmt::format("line {}: {}", snaps[k].place.line, snap_text(snaps[k], effects.each[k])));
  }
  return lines;
}

}  // namespace

void write_model(data& page, const LoadedRobot& model, const SnapEffects& snap_effects) {
  const ordered_json json = model_json(model, snap_effects);
  page["joints"] = joint_rows(json.at("joints"), model.mechanism);
  page["scene?"] = json.contains("scene");
  if (json.contains("scene")) page["scene"] = list_of(json.at("scene").get<std::vector<std::string>>());
  page["snaps?"] = !model.robot.snaps.empty();
  page["snaps"] = list_of(snap_lines(model.robot.snaps, snap_effects));
}

void write_notes(data& page, const LoadedRobot& model, const Diagnostics& findings) {
  data rows(data::type::list);
  bool any = false;
  for (const Diagnostics* list : {&model.diagnostics, &findings}) {
    for (const Diagnostic& each : list->all()) {
      const std::string file = std::filesystem::path(each.place.file).filename().string();
      const std::string line = each.place.line > 0 ? fmt::format("{}:{}:", file, each.place.line) : file + ":";
      data row;
      row["severity"] = std::string(each.severity == Severity::note ? "note" : "warning");
      row["place"] = file.empty() ? "" : line;
      row["message"] = each.message;
      row["hint?"] = !each.hint.empty();
      row["hint"] = each.hint;
      rows << row;
      any = true;
    }
  }
  page["notes?"] = any;
  page["notes"] = data(rows);
}

}  // namespace flatdyn
