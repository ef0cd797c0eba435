// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics/table.hpp"
#include "derivation/notation/coupled_text.hpp"
#include "derivation/notation/number_text.hpp"
#include "derivation/parameters/file_parameters.hpp"
#include "functions/load/scene_text.hpp"
#include "report/number_json.hpp"
#include "robot/model/floating_base.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

constexpr const char* kCountsFrom =
    "\nq counts from 0 here, as arrays in code do; names such as q_1 and m1, and columns of files, count from 1\n";

std::string type_of(const Body& body) {
  if (body.spherical > 0) return "spherical";
  if (body.is_tendon) return "tendon";
  if (body.prismatic) return "prismatic";
  return body.continuous ? "continuous" : "revolute";
}

// Limits as text. Those of a file in degrees are in degrees, with the unit.
class LimitText {
 public:
  LimitText(const LoadedRobot& model, const NumberText& number)
      : in_degrees_(model.robot.in_degrees || model.robot.scene.degrees), number_(number) {}

  std::string position(const Body& body) const {
    const Limits& limits = body.limits;
    if (!limits.lower && !limits.upper) return "-";
    const bool degrees = is_in_degrees(body, limits.lower) && is_in_degrees(body, limits.upper);
    return fmt::format("[{}, {}]{}", text(limits.lower, degrees), text(limits.upper, degrees), degrees ? " deg" : "");
  }

  std::string rate(const Body& body, const std::optional<Value>& limit, const char* unit) const {
    const bool degrees = limit && is_in_degrees(body, limit);
    return text(limit, degrees) + (degrees ? std::string(" ") + unit : "");
  }

  std::string plain(const std::optional<Value>& limit) const { return text(limit, false); }

 private:
  // Whether a limit, if there is one, was written in degrees: the number over pi is then rational.
  bool is_in_degrees(const Body& body, const std::optional<Value>& limit) const {
    if (!in_degrees_ || body.prismatic) return false;
    return !limit || is_rational((limit->number / GiNaC::Pi).expand());
  }

  std::string text(const std::optional<Value>& limit, bool degrees) const {
    constexpr int kHalfTurn = 180;
    if (!limit) return "-";
    return number_(degrees ? Number((limit->number * kHalfTurn / GiNaC::Pi).expand()) : limit->number);
  }

  bool in_degrees_;
  const NumberText& number_;
};

std::string text_of_loops(const Mechanism& mechanism) {
  std::string text = fmt::format("\nclosed loops, {} of {}:\n",
                                 mechanism.floating_base ? "v, a and tau, after the base's entries," : "qd and tau",
                                 fmt::join(mechanism.joint_names(), ", "));
  for (const LoopClosure& loop : mechanism.loops) {
    text += fmt::format("  {} follow from the others\n", fmt::join(dependent_joint_names(mechanism, loop), ", "));
  }
  return text;
}

// The armature and friction that the entries of a floating base have in addition to the robot's links; empty if it has
// none.
std::string base_joint_text(const Mechanism& mechanism, const NumberText& number) {
  if (!has_base_joint(mechanism)) return "";
  const Body& turning = mechanism.base_link();
  std::string parts;
  const auto add = [&](const char* name, const Number& value, const char* units) {
    if (vanishes(value)) return;
    parts += fmt::format("{}{} {} {}", parts.empty() ? "" : ", ", name, number(value), units);
  };
  add("armature", turning.armature, "kg and kg m^2");
  add("viscous friction", turning.viscous, "N s/m and N m s/rad");
  add("Coulomb friction of turns", turning.coulomb, "N m");
  return fmt::format("  with {}\n", parts);
}

// lengths: one text for each tendon.
std::string describe_tendons(const Mechanism& mechanism, const std::vector<std::string>& lengths,
                             const NumberText& number) {
  std::string text = lengths.empty() ? "" : "\ntendons, which act on several joints by their lengths, rad or m:\n";
  auto length = lengths.begin();
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    if (!body.is_tendon) continue;
    text += "  " + *length++;
    const auto add = [&](const char* what, const Number& value) {
      if (!vanishes(value)) text += fmt::format("; {} {}", what, number(value));
    };
    add("stiffness", body.stiffness);
    if (!vanishes(body.stiffness)) {
      text += fmt::format("; relaxed at {}", number((body.spring_reference + mechanism.offsets[i]).expand()));
    }
    add("F_v", body.viscous);
    add("F_s", body.coulomb);
    add("smooth around", body.dry.speed);
    add("armature", body.armature);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string describe_model(const LoadedRobot& model, const SnapEffects& snap_effects, SnapDetail detail) {
  const Mechanism& mechanism = model.mechanism;
  const NumberText number(mechanism);
  const LimitText limit(model, number);
  std::string text = fmt::format("robot {}: {}, gravity {} m/s^2, tip {}\n\n", mechanism.name, joints_text(mechanism),
                                 number(mechanism.gravity), mechanism.tip.link);
  const JointRange joints = mechanism.joints();
  const bool has_accelerations =
      std::any_of(joints.begin(), joints.end(), [](const Body& body) { return body.limits.acceleration.has_value(); });
  std::vector<std::vector<std::string>> rows = {{"q", "joint", "type", "moves", "after", "range", "speed", "effort"}};
  if (has_accelerations) rows.front().emplace_back("acceleration");
  for (int i = 0; i < mechanism.position_count(); ++i) {
    const Body& body = mechanism.joint_at(i);
    const int parent_body = parent_of_joint(mechanism, mechanism.body_at(i));
    const bool is_on_base = parent_body < mechanism.base_bodies();
    const std::string parent =
        is_on_base ? "base" : joint_name(mechanism.bodies[static_cast<std::size_t>(parent_body)]);
    rows.push_back({std::to_string(i), mechanism.position_name(i), type_of(body), body.link, parent,
                    limit.position(body), limit.rate(body, body.limits.velocity, "deg/s"),
                    limit.plain(body.limits.effort)});
    if (has_accelerations) rows.back().push_back(limit.rate(body, body.limits.acceleration, "deg/s^2"));
  }
  text += aligned_table(rows);
  if (mechanism.position_count() > 0) text += kCountsFrom;
  if (mechanism.floating_base) {
    text += fmt::format(
        "\nfloating base, link {}: v, a and tau begin with six entries of the base, in its axes: linear, then "
        "angular\n",
        mechanism.base_link().link);
    text += base_joint_text(mechanism, number);
  }
  if (mechanism.has_spherical_joints()) {
    text +=
        "\nspherical joints: q has a unit quaternion (w, x, y, z) of each, from the child's axes to the parent's; v, a "
        "and "
        "tau\nhave three entries, in the child's axes:\n";
    for (const int first : mechanism.spherical) {
      const Body& body = mechanism.bodies[static_cast<std::size_t>(first)];
      text += fmt::format("  v[{}] to v[{}]: {}\n", first, first + 2, spherical_joint_name(body.joint));
    }
  }
  if (mechanism.is_coupled()) {
    const auto by_index = [](int k) { return fmt::format("q[{}]", k); };
    const std::vector<std::string> coupled = coupled_joint_texts(mechanism, by_index);
    if (!coupled.empty()) text += fmt::format("\ncoupled joints:\n  {}\n", fmt::join(coupled, "\n  "));
    text += describe_tendons(mechanism, tendon_texts(mechanism, by_index), number);
  }
  if (mechanism.has_loops()) text += text_of_loops(mechanism);
  const std::vector<std::string> scene = scene_items(model);
  if (!scene.empty()) text += fmt::format("\nfixed by scene or options:\n  {}\n", fmt::join(scene, "\n  "));
  if (!mechanism.merged.empty())
    text += fmt::format("\nmerged by fixed joints: {}\n", fmt::join(mechanism.merged, ", "));
  if (!mechanism.symbols.empty()) {
    text += "\nfree symbols:";
    for (const FreeSymbol& symbol : mechanism.symbols) text += " " + symbol.name;
    text += "\n";
  }
  text += describe_snaps(model.robot.snaps, snap_effects, detail);
  return text;
}

namespace {

std::string turn_text(const PlanarRotation& turn, const NumberText& number) {
  if (has_symbols(turn.c)) return "atan2(" + number(turn.s) + ", " + number(turn.c) + ")";
  const double angle = std::atan2(nearest_double(turn.s), nearest_double(turn.c));
  const double quarters = angle / std::acos(0.0);
  return quarters == std::round(quarters) ? fmt::format("{:g} deg", 90 * quarters) : fmt::format("{:.6g} rad", angle);
}

std::string inertia_about_origin(const InertialParameters& b, const NumberText& number) {
  return fmt::format(
      "  m = {} kg, m r = {} kg m\n"
      "  I = xx {}, yy {}, zz {}, xy {}, xz {}, yz {} kg m^2 about the origin\n",
      number(b.mass), number(b.first_moment), number(b.inertia[0][0]), number(b.inertia[1][1]), number(b.inertia[2][2]),
      number(b.inertia[0][1]), number(b.inertia[0][2]), number(b.inertia[1][2]));
}

// Links are numbered from 1, as in the names of parameters, m1, I1zz, …
std::string describe_body(const Body& body, int number_of_link, const NumberText& number) {
  const auto turn = [&number](const PlanarRotation& rotation) { return turn_text(rotation, number); };
  return fmt::format("link {} ({}), frame in its parent: p = {} m, Rz({}) Rx({}) Rz({}{})\n", number_of_link, body.link,
                     number(body.p), turn(body.beta), turn(body.alpha), turn(body.theta),
                     body.prismatic ? "" : " + q") +
         inertia_about_origin(body.inertia, number);
}

std::string describe_canonical_bodies(const Mechanism& mechanism, const NumberText& number) {
  std::string text =
      "links in the frames of their parameters, which flatdyn chooses so that most constants are 0 or 1: z along the "
      "joint's axis\n";
  if (mechanism.floating_base) {
    const Body& base = mechanism.base_link();
    text += fmt::format("base ({}), in its own frame\n", base.link) + inertia_about_origin(base.inertia, number);
  }
  for (int i = mechanism.base_bodies(); i < mechanism.body_count(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    if (!body.is_tendon) text += describe_body(body, i + 1 - mechanism.base_bodies(), number);
  }
  return text;
}

std::string describe_written_links(const Mechanism& mechanism, const NumberText& number) {
  std::string text = "links as the robot file has them, in their own frames, with the rotors that they carry\n";
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    for (const WrittenLink* link : links_of(mechanism, i)) {
      const bool is_moved = link->link == body.link;
      const std::string place = !is_moved                 ? "fixed to " + body.link
                                : mechanism.is_of_base(i) ? "the base"
                                                          : "moved by " + body.joint;
      text += fmt::format("link {}, {}\n", link->link, place) + inertia_about_origin(link->inertia, number);
    }
  }
  return text;
}

// Inertial parameters in the canonical frames.
nlohmann::ordered_json canonical_json(const Body& body, const NumberText& text) {
  const InertialParameters& b = body.inertia;
  nlohmann::ordered_json json;
  json["origin"] = {{"p", list_json(body.p, text)}, {"R", matrix_json(constant_rotation(body), text)}};
  json["mass"] = number_json(b.mass, text);
  json["first_moment"] = list_json(b.first_moment, text);
  json["inertia_about_origin"] = matrix_json(b.inertia, text);
  if (body.rotor) json["rotor_axis"] = list_json(body.rotor->axis, text);
  return json;
}

// Adds what friction is beyond F_s sgn(q̇), if it is.
void add_dry_friction_json(const DryFriction& dry, const NumberText& text, nlohmann::ordered_json& joint) {
  const auto add = [&](const char* key, const Number& value) {
    if (!vanishes(value)) joint[key] = number_json(value, text);
  };
  add("coulomb_speed", dry.speed);
  add("coulomb_offset", dry.offset);
  add("static_excess", dry.excess);
  add("stribeck_speed", dry.stribeck_speed);
  add("coulomb_asymmetry", dry.asymmetry);
  add("load_friction", dry.load);
}

nlohmann::ordered_json joint_json(const Body& body, const NumberText& text) {
  nlohmann::ordered_json joint = {
      {"name", body.joint}, {"type", type_of(body)}, {"link", body.link}, {"parent", body.parent}};
  const auto add_limit = [&](const char* key, const std::optional<Value>& value) {
    if (value) joint[key] = number_json(value->number, text);
  };
  add_limit("lower", body.limits.lower);
  add_limit("upper", body.limits.upper);
  add_limit("velocity", body.limits.velocity);
  add_limit("acceleration", body.limits.acceleration);
  add_limit("effort", body.limits.effort);
  joint["viscous_friction"] = number_json(body.viscous, text);
  joint["coulomb_friction"] = number_json(body.coulomb, text);
  add_dry_friction_json(body.dry, text, joint);
  joint["armature"] = number_json(body.armature, text);
  if (!vanishes(body.stiffness)) {
    joint["stiffness"] = number_json(body.stiffness, text);
    joint["spring_reference"] = number_json(body.spring_reference, text);
  }
  if (body.rotor) {
    joint["rotor"] = {{"gear_ratio", number_json(body.rotor->gear_ratio, text)},
                      {"inertia", number_json(body.rotor->inertia, text)},
                      {"carrier", body.rotor->carrier}};
  }
  joint["canonical"] = canonical_json(body, text);
  return joint;
}

// The position of a coupled joint, Σ factor · q + offset, with the entries of q by joint names.
nlohmann::ordered_json position_json(const Mechanism& mechanism, std::size_t body, const NumberText& text) {
  nlohmann::ordered_json factors = nlohmann::ordered_json::object();
  for (int k = 0; k < mechanism.position_count(); ++k) {
    const Number& factor = mechanism.coupling[body][static_cast<std::size_t>(k)];
    const std::string& joint = mechanism.joint_at(k).joint;
    if (!vanishes(factor)) factors[joint] = number_json(factor, text);
  }
  return {{"factors", factors}, {"offset", number_json(mechanism.offsets[body], text)}};
}

}  // namespace

std::string describe_bodies(const Mechanism& mechanism, ParameterFrames frames) {
  const NumberText number(mechanism);
  return has_names_of_file(mechanism, frames) ? describe_written_links(mechanism, number)
                                              : describe_canonical_bodies(mechanism, number);
}

nlohmann::ordered_json model_json(const LoadedRobot& model, const SnapEffects& snap_effects) {
  const NumberText text(model.mechanism);
  nlohmann::ordered_json json;
  json["robot"] = model.mechanism.name;
  json["input_hash"] = model.input_hash;
  json["gravity"] = list_json(model.mechanism.gravity, text);
  json["tip"] = model.mechanism.tip.link;
  json["joints"] = nlohmann::ordered_json::array();
  const Mechanism& mechanism = model.mechanism;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    json["joints"].push_back(joint_json(mechanism.bodies[i], text));
    if (mechanism.is_coupled()) json["joints"].back()["position"] = position_json(mechanism, i, text);
  }
  if (mechanism.is_coupled()) {
    json["q"] = nlohmann::ordered_json::array();
    for (int k = 0; k < mechanism.position_count(); ++k) {
      json["q"].push_back(mechanism.joint_at(k).joint);
    }
  }
  if (mechanism.has_loops()) {
    json["independent"] = mechanism.joint_names();
    json["loops"] = nlohmann::ordered_json::array();
    for (const LoopClosure& loop : mechanism.loops) {
      json["loops"].push_back({{"dependent", dependent_joint_names(mechanism, loop)}});
    }
  }
  json["merged_links"] = model.mechanism.merged;
  if (const std::vector<std::string> scene = scene_items(model); !scene.empty()) json["scene"] = scene;
  json["symbols"] = symbol_names(model.mechanism);
  json["snapped"] = snaps_json(model.robot.snaps, snap_effects);
  return json;
}

std::vector<std::string> symbol_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const FreeSymbol& symbol : mechanism.symbols) names.push_back(symbol.name);
  return names;
}

}  // namespace flatdyn
