// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/describe.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <sstream>

#include "emit/arguments.hpp"

#include "report/table.hpp"

namespace flatdyn {
namespace {

std::string type_of(const Body& body) {
  if (body.prismatic) return "prismatic";
  return body.continuous ? "continuous" : "revolute";
}

std::string limit_text(const std::optional<Value>& value) { return value ? short_text(value->number) : "-"; }

std::string range_text(const Limits& limits) {
  if (!limits.lower && !limits.upper) return "-";
  return "[" + limit_text(limits.lower) + ", " + limit_text(limits.upper) + "]";
}

std::string snap_text(const Snap& snap) {
  return fmt::format("  {}:{}: {}: {} taken for {} (off by {} rad)\n", snap.place.file, snap.place.line, snap.what,
                     snap.written, short_text(snap.exact), to_decimal(snap.difference, 2));
}

}  // namespace

std::string short_text(const Number& number) {
  if (has_symbols(number)) {
    std::ostringstream text;
    text << number;
    return text.str();
  }
  const Number turns = (number / GiNaC::Pi).expand();
  if (!number.is_zero() && is_rational(turns)) {
    const GiNaC::numeric r = GiNaC::ex_to<GiNaC::numeric>(turns);
    const std::string sign = r.is_negative() ? "-" : "";
    const GiNaC::numeric above = GiNaC::abs(r.numer());
    std::ostringstream text;
    text << sign;
    if (!above.is_equal(1)) text << above << "*";
    text << "pi";
    if (!r.denom().is_equal(1)) text << "/" << r.denom();
    return text.str();
  }
  return fmt::format("{:.6g}", std::stod(to_decimal(number, 17)));
}

std::string describe_model(const Model& model) {
  const Mechanism& mechanism = model.mechanism;
  std::string text = fmt::format("robot {}: {} joints, gravity ({}, {}, {}) m/s^2, tip {}\n\n", mechanism.name,
                                 mechanism.size(), short_text(mechanism.gravity[0]), short_text(mechanism.gravity[1]),
                                 short_text(mechanism.gravity[2]), mechanism.tip.link);
  std::vector<std::vector<std::string>> rows = {{"q", "joint", "type", "moves", "after", "range", "speed", "effort"}};
  for (int i = 0; i < mechanism.size(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    const std::string parent = body.parent < 0 ? "base" : mechanism.bodies[static_cast<std::size_t>(body.parent)].joint;
    rows.push_back({std::to_string(i), body.joint, type_of(body), body.link, parent, range_text(body.limits),
                    limit_text(body.limits.velocity), limit_text(body.limits.effort)});
  }
  text += aligned_table(rows);
  if (!mechanism.merged.empty())
    text += fmt::format("\nmerged by fixed joints: {}\n", fmt::join(mechanism.merged, ", "));
  if (!mechanism.symbols.empty()) {
    text += "\nfree symbols:";
    for (const FreeSymbol& symbol : mechanism.symbols) text += " " + symbol.name;
    text += "\n";
  }
  if (!model.robot.snaps.empty()) text += "\nangles taken for multiples of pi/12:\n";
  for (const Snap& snap : model.robot.snaps) text += snap_text(snap);
  return text;
}

namespace {

std::string vector_text(const Vec3& v) {
  return fmt::format("({}, {}, {})", short_text(v[0]), short_text(v[1]), short_text(v[2]));
}

std::string turn_text(const PlanarRotation& turn) {
  if (has_symbols(turn.c)) return "atan2(" + short_text(turn.s) + ", " + short_text(turn.c) + ")";
  const double angle = std::atan2(std::stod(to_decimal(turn.s, 17)), std::stod(to_decimal(turn.c, 17)));
  const double quarters = angle / std::acos(0.0);
  return quarters == std::round(quarters) ? fmt::format("{:g} deg", 90 * quarters) : fmt::format("{:.6g} rad", angle);
}

std::string describe_body(const Body& body, int i) {
  const InertialParameters& b = body.inertia;
  std::string text = fmt::format("body {} ({}), frame in its parent: p = {} m, Rz({}) Rx({}) Rz({}{})\n", i, body.link,
                                 vector_text(body.p), turn_text(body.beta), turn_text(body.alpha),
                                 turn_text(body.theta), body.prismatic ? "" : " + q");
  text += fmt::format(
      "  m = {} kg, m r = {} kg m\n  I = xx {}, yy {}, zz {}, xy {}, xz {}, yz {} kg m^2 about the origin\n",
      short_text(b.mass), vector_text(b.first_moment), short_text(b.inertia[0][0]), short_text(b.inertia[1][1]),
      short_text(b.inertia[2][2]), short_text(b.inertia[0][1]), short_text(b.inertia[0][2]),
      short_text(b.inertia[1][2]));
  text += fmt::format("  friction F_v = {}, F_s = {}\n", short_text(body.viscous), short_text(body.coulomb));
  if (!vanishes(body.armature)) text += fmt::format("  reflected inertia {}\n", short_text(body.armature));
  if (body.rotor) {
    text += fmt::format("  rotor: k_r = {}, I_m = {} kg m^2, axis {} on {}\n", short_text(body.rotor->gear_ratio),
                        short_text(body.rotor->inertia), vector_text(body.rotor->axis),
                        body.rotor->carrier < 0 ? "the base" : fmt::format("body {}", body.rotor->carrier));
  }
  return text;
}

}  // namespace

std::string describe_bodies(const Mechanism& mechanism) {
  std::string text;
  for (int i = 0; i < mechanism.size(); ++i) text += describe_body(mechanism.bodies[static_cast<std::size_t>(i)], i);
  return text;
}

nlohmann::ordered_json model_json(const Model& model) {
  nlohmann::ordered_json json;
  json["robot"] = model.mechanism.name;
  json["input_hash"] = model.input_hash;
  for (const Number& g : model.mechanism.gravity) json["gravity"].push_back(short_text(g));
  json["tip"] = model.mechanism.tip.link;
  json["joints"] = nlohmann::ordered_json::array();
  for (const Body& body : model.mechanism.bodies) {
    nlohmann::ordered_json joint = {
        {"name", body.joint}, {"type", type_of(body)}, {"link", body.link}, {"parent", body.parent}};
    const auto add = [&joint](const char* key, const std::optional<Value>& value) {
      if (value && !has_symbols(value->number)) joint[key] = std::stod(to_decimal(value->number, 17));
    };
    add("lower", body.limits.lower);
    add("upper", body.limits.upper);
    add("velocity", body.limits.velocity);
    add("effort", body.limits.effort);
    json["joints"].push_back(std::move(joint));
  }
  json["merged_links"] = model.mechanism.merged;
  json["symbols"] = nlohmann::ordered_json::array();
  for (const FreeSymbol& symbol : model.mechanism.symbols) json["symbols"].push_back(symbol.name);
  json["snapped"] = nlohmann::ordered_json::array();
  for (const Snap& snap : model.robot.snaps) {
    json["snapped"].push_back({{"line", snap.place.line},
                               {"what", snap.what},
                               {"written", snap.written},
                               {"taken_for", short_text(snap.exact)}});
  }
  return json;
}

std::vector<std::string> symbol_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const FreeSymbol& symbol : mechanism.symbols) names.push_back(symbol.name);
  return names;
}

int structural_zeros(const Function& function) {
  int zeros = 0;
  for (const Output& output : function.outputs) {
    for (const NodeId id : output.entries) zeros += function.graph.is_zero(id) ? 1 : 0;
  }
  return zeros;
}

std::string describe_functions(const std::vector<OptimisedFunction>& functions,
                               const std::vector<std::string>& symbols) {
  std::vector<std::vector<std::string>> rows = {
      {"function", "mul", "add", "div", "sin/cos", "as derived", "zeros", "reads"}};
  for (const OptimisedFunction& each : functions) {
    const OperationCount count = count_operations(each.function);
    rows.push_back({each.function.name, std::to_string(count.multiplications), std::to_string(count.additions),
                    std::to_string(count.divisions), std::to_string(count.trigonometric),
                    std::to_string(each.derived.arithmetic()), std::to_string(structural_zeros(each.function)),
                    list_of_inputs(inputs_read(each.function), symbols)});
  }
  return aligned_table(rows);
}

nlohmann::ordered_json functions_json(const std::vector<OptimisedFunction>& functions,
                                      const std::vector<std::string>& symbols) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const OptimisedFunction& each : functions) {
    const OperationCount count = count_operations(each.function);
    json.push_back({{"name", each.function.name},
                    {"multiplications", count.multiplications},
                    {"additions", count.additions},
                    {"divisions", count.divisions},
                    {"sin_cos", count.trigonometric},
                    {"operations_as_derived", each.derived.arithmetic()},
                    {"structural_zeros", structural_zeros(each.function)},
                    {"reads", list_of_inputs(inputs_read(each.function), symbols)}});
  }
  return json;
}

}  // namespace flatdyn
