// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <map>
#include <sstream>

#include "base/diagnostics/version.hpp"
#include "code/emit/page.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/emit.hpp"
#include "derivation/notation/number_text.hpp"
#include "report/describe.hpp"
#include "report/html/regressor_map.hpp"
#include "report/html/tables.hpp"
#include "report/html/zero_map.hpp"
#include "robot/model/spherical_joint.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;
using nlohmann::ordered_json;

// The code with escapes, so that no string or comment in it ends the script element or begins a comment of HTML.
std::string for_script_element(const std::string& code) {
  return with_replaced(with_replaced(code, "</", "<\\/"), "<!--", "<\\!--");
}

std::string plural(int count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// "7 joints, 2 of them prismatic", "floating base, 12 joints, revolute", "4 joints, 1 of them spherical, 1 prismatic".
std::string joints_text(const Mechanism& mechanism) {
  const auto spherical = static_cast<int>(mechanism.spherical.size());
  const auto prismatic = static_cast<int>(std::count_if(mechanism.joints().begin(), mechanism.joints().end(),
                                                        [](const Body& body) { return body.prismatic; }));
  const int count = static_cast<int>(mechanism.joints().size()) - (kSphericalBodies - 1) * spherical;
  const std::string joints = (mechanism.floating_base ? "floating base, " : "") + plural(count, "joint");
  if (count == 0) return joints;
  if (prismatic + spherical == 0) return joints + ", revolute";
  if (prismatic == count) return joints + ", prismatic";
  if (spherical == count) return joints + ", spherical";
  std::vector<std::string> kinds;
  if (spherical > 0) kinds.push_back(fmt::format("{} of them spherical", spherical));
  if (prismatic > 0) kinds.push_back(fmt::format("{} {}prismatic", prismatic, kinds.empty() ? "of them " : ""));
  return fmt::format("{}, {}", joints, fmt::join(kinds, ", "));
}

std::string facts_text(const LoadedRobot& model) {
  const Mechanism& mechanism = model.mechanism;
  const NumberText number(mechanism);
  std::string text = fmt::format("Gravity is {} m/s² in {}.", number(mechanism.gravity),
                                 mechanism.floating_base ? "world axes" : "the base frame");
  if (mechanism.floating_base) {
    const Body& base = mechanism.base_link();
    text +=
        fmt::format(" The base is link {}, {} kg with everything fixed to it.", base.link, number(base.inertia.mass));
  }
  if (!mechanism.tip.link.empty()) text += fmt::format(" The tip belongs to link {}.", mechanism.tip.link);
  if (!mechanism.merged.empty()) {
    text += fmt::format(" Links without a joint of their own, part of those that carry them: {}.",
                        fmt::join(mechanism.merged, ", "));
  }
  return text;
}

// A joint for the page's script. Missing limits, and those that nobody filled in, are null.
ordered_json joint_json(const Body& body, int point) {
  const auto limit = [](const std::optional<Value>& value) -> ordered_json {
    if (!value || has_symbols(value->number)) return nullptr;
    return nearest_double(value->number);
  };
  const auto positive = [&limit](const std::optional<Value>& value) -> ordered_json {
    const ordered_json number = limit(value);
    return number.is_number() && number.get<double>() > 0 ? number : ordered_json(nullptr);
  };
  return {{"name", body.joint},
          {"prismatic", body.prismatic},
          {"lower", limit(body.limits.lower)},
          {"upper", limit(body.limits.upper)},
          {"speed", positive(body.limits.velocity)},
          {"acceleration", positive(body.limits.acceleration)},
          {"effort", positive(body.limits.effort)},
          {"point", point}};
}

// Tells the script of spherical joints: q of the functions has `positions` entries, that of a joint at `position`; each
// spherical joint is three of `joints`, from `joint` on, and w of its quaternion is the entry `w` of q.
void add_spherical_joints(ordered_json& json, const Mechanism& mechanism) {
  json["positions"] = mechanism.position_count();
  json["balls"] = ordered_json::array();
  for (int k = mechanism.base_bodies(); k < mechanism.size(); ++k) {
    ordered_json& joint = json["joints"][static_cast<std::size_t>(k - mechanism.base_bodies())];
    joint["position"] = mechanism.position_of(k);
    if (mechanism.is_of_spherical(k)) joint["ball"] = joint_name(mechanism.joint(k));
  }
  for (const int first : mechanism.spherical) {
    json["balls"].push_back({{"name", joint_name(mechanism.joint(first))},
                             {"joint", first - mechanism.base_bodies()},
                             {"w", mechanism.quaternion_of(first)}});
  }
}

std::string script_data(const PageContent& content) {
  ordered_json json;
  json["joints"] = ordered_json::array();
  for (const Body& body : content.model.mechanism.joints()) {
    json["joints"].push_back(joint_json(body, content.drawing.joints[json["joints"].size()]));
  }
  json["followers"] = ordered_json::array();
  for (const Drawing::Follower& each : content.drawing.followers) {
    json["followers"].push_back({{"point", each.point}, {"prismatic", each.prismatic}});
  }
  const std::vector<Body>& bodies = content.model.mechanism.bodies;
  json["tree"] = false;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].parent + 1 != static_cast<int>(k)) json["tree"] = true;
  }
  const Mechanism& mechanism = content.model.mechanism;
  if (mechanism.floating_base) {
    json["base"] = {{"gravity", mechanism.has_base_gravity()},
                    {"armature", nearest_double(mechanism.bodies.front().armature)}};
  }
  if (mechanism.has_spherical_joints()) add_spherical_joints(json, mechanism);
  json["points"] = content.drawing.points;
  json["edges"] = content.drawing.lines;
  return with_replaced(json.dump(-1, ' ', true, ordered_json::error_handler_t::replace), "<", "\\u003c");
}

bool is_regressor(const Output& output) { return output.quantity == OutputQuantity::torque_per_parameter; }

// Whether the page shows which entries are zero: of matrices, but for the regressor, which is too wide and has a map of
// its own, and for rotations.
bool is_mapped(const Output& output) {
  const bool is_matrix = output.layout == Layout::matrix || output.layout == Layout::christoffel;
  return is_matrix && !is_regressor(output) && output.quantity != OutputQuantity::number;
}

data maps(const std::vector<OptimisedFunction>& functions) {
  data list(data::type::list);
  for (const OptimisedFunction& each : functions) {
    for (const Output& output : each.function.outputs) {
      if (!is_mapped(output) || output.entries.empty()) continue;
      const int filled = nonzero_entries(each.function, output);
      const std::string text = fmt::format("{} of {} entries", filled, output.entries.size());
      data item;
      item["name"] = each.function.name;
      item["rows"] = std::to_string(output.rows);
      item["cols"] = std::to_string(output.cols);
      item["text"] = text;
      item["svg"] = zero_map(each.function, output, fmt::format("{}: {} not always zero", each.function.name, text));
      list << item;
    }
  }
  return list;
}

void write_regressor(data& page, const std::vector<OptimisedFunction>& functions, const Mechanism& mechanism) {
  const auto made = std::find_if(functions.begin(), functions.end(), [](const OptimisedFunction& each) {
    return is_regressor(each.function.outputs.front());
  });
  page["regressor?"] = made != functions.end();
  if (made == functions.end()) return;
  const Output& Y = made->function.outputs.front();
  const std::string text = fmt::format("{} of {} entries", nonzero_entries(made->function, Y), Y.entries.size());
  page["regressor"] = regressor_map(made->function, Y, mechanism, fmt::format("regressor: {} not always zero", text));
  page["regressor_rows"] = std::to_string(Y.rows);
  page["regressor_cols"] = std::to_string(Y.cols);
  page["regressor_text"] = text;
}

}  // namespace

const std::vector<std::string>& functions_of_page(const Mechanism& mechanism) {
  static const std::vector<std::string> floating = {"inverse_dynamics", "inertia_matrix",   "gravity",
                                                    "kinetic_energy",   "potential_energy", "forward_kinematics"};
  static const std::vector<std::string> fixed = [] {
    std::vector<std::string> names = floating;
    names.emplace_back("jacobian");
    return names;
  }();
  return mechanism.floating_base ? floating : fixed;
}

PageCode page_code(const PageContent& content) {
  PageCode code;
  for (const std::string& name : functions_of_page(content.model.mechanism)) {
    const auto made = std::find_if(content.functions.begin(), content.functions.end(),
                                   [&name](const OptimisedFunction& each) { return each.function.name == name; });
    if (made == content.functions.end()) {
      throw Failure(FailureKind::unsupported,
                    fmt::format("the page needs the function {}, which this robot has not", name),
                    "flatdyn generate writes those that it has");
    }
    code.functions.push_back(*made);
  }
  code.functions.push_back({content.drawing.function, content.drawing.function, {}, {}});
  code.text = emit_page_script(content.model.mechanism, functions_of(code.functions));
  return code;
}

namespace {

// The functions for quaternions, without the line of their licence, which the script around them has.
std::string quaternion_functions() {
  const std::string text = templates::report_quaternions_js;
  return text.substr(text.find('\n') + 1);
}

// The text with those of its lines that are for the robot: sections "floating" and "spherical" whose tags have lines of
// their own. (The library would leave an empty line in the place of a hidden one.)
std::string for_robot(const std::string& text, const Mechanism& mechanism) {
  const std::map<std::string, bool> sections = {{"{{#floating}}", mechanism.floating_base},
                                                {"{{^floating}}", !mechanism.floating_base},
                                                {"{{#spherical}}", mechanism.has_spherical_joints()},
                                                {"{{^spherical}}", !mechanism.has_spherical_joints()}};
  std::istringstream lines(text);
  std::string kept, line;
  std::vector<bool> shown;  // of the sections around the line, from the outermost one
  while (std::getline(lines, line)) {
    if (const auto section = sections.find(line); section != sections.end()) {
      shown.push_back(section->second);
    } else if (line == "{{/floating}}" || line == "{{/spherical}}") {
      shown.pop_back();
    } else if (std::find(shown.begin(), shown.end(), false) == shown.end()) {
      kept += line == "{{>quaternions}}" ? quaternion_functions() : line + "\n";
    }
  }
  return kept;
}

// The style and the scripts of the page.
void write_scripts(data& page, const Mechanism& mechanism) {
  const bool floating = mechanism.floating_base, spherical = mechanism.has_spherical_joints();
  const auto script = [&mechanism](const char* text, bool wanted = true) {
    return wanted ? for_robot(text, mechanism) : "";
  };
  page["style"] = std::string(templates::report_style_css) + (floating ? templates::report_base_style_css : "") +
                  (spherical ? templates::report_ball_style_css : "");
  page["script"] = script(templates::report_state_js) + script(templates::report_base_js, floating) +
                   script(templates::report_ball_js, spherical) + script(templates::report_view_js) +
                   script(templates::report_base_panel_js, floating) +
                   script(templates::report_ball_panel_js, spherical) + script(templates::report_panel_js);
}

}  // namespace

std::string report_page(const PageContent& content, const PageCode& code) {
  const LoadedRobot& model = content.model;
  data page;
  page["version"] = std::string(kProgramVersion);
  page["robot"] = model.mechanism.name;
  page["summary"] = joints_text(model.mechanism);
  page["floating"] = model.mechanism.floating_base;
  page["spherical"] = model.mechanism.has_spherical_joints();
  if (model.mechanism.floating_base) page["base_link"] = model.mechanism.base_link().link;
  page["facts"] = facts_text(model);
  page["maps"] = maps(content.functions);
  write_regressor(page, content.functions, model.mechanism);
  write_operations(page, content.functions);
  write_base(page, model.mechanism, content.parameters, content.frames);
  write_model(page, model, content.snap_effects);
  write_notes(page, model, content.findings);
  write_certificate(page, content.certificate);
  write_worst_states(page, content.worst_states);
  page["hash"] = model.input_hash;
  page["options?"] = !content.options.empty();
  page["options"] = content.options;
  page["proof"] = content.proof;
  page["data"] = script_data(content);
  page["code"] = for_script_element(code.text);
  write_scripts(page, model.mechanism);
  return rendered_html(for_robot(templates::report_html, model.mechanism).c_str(), page);
}

}  // namespace flatdyn
