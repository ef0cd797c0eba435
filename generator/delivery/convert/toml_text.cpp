// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "delivery/convert/conversion.hpp"
#include "delivery/convert/decimals.hpp"
#include "delivery/convert/ordered_text.hpp"
#include "delivery/convert/plain_robot.hpp"
#include "report/toml_string.hpp"

namespace flatdyn {

namespace {

const PlainForm kTomlForm = {.bodies_turn = false};

bool is_zero(const Vec3& v) {
  return std::all_of(v.begin(), v.end(), [](const Number& x) { return vanishes(x); });
}

// Whether an expression has only sums, products and whole powers, and roots of numbers.
bool is_readable(const Number& expression) {
  if (GiNaC::is_a<GiNaC::function>(expression)) return false;
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    const Number exponent = expression.op(1);
    const bool is_root = exponent.is_equal(Number(1) / 2) && !has_symbols(expression.op(0));
    if (!exponent.info(GiNaC::info_flags::integer) && !is_root) return false;
  }
  for (std::size_t i = 0; i < expression.nops(); ++i) {
    if (!is_readable(expression.op(i))) return false;
  }
  return true;
}

class TomlWriter {
 public:
  TomlWriter(const Robot& robot, Diagnostics& diagnostics)
      : robot_(robot), diagnostics_(diagnostics), plain_(plain_robot(robot, kTomlForm)) {}

  Conversion write() {
    write_top();
    for (const PlainJoint& joint : plain_.joints) {
      if (joint.joint == nullptr || !joint.joint->is_tendon) write_row(joint);
    }
    for (const Joint& joint : robot_.joints) {
      if (joint.is_tendon) write_tendon(joint);
    }
    for (const Loop& loop : robot_.loops) write_loop(loop);
    write_assembly();
    write_tip();
    return {std::move(text_), std::move(rounded_)};
  }

 private:
  // ---- numbers

  static std::string quoted_expression(const Number& value) { return toml_string(ordered_text(value)); }

  // An expression in symbols, as the reader takes it.
  std::string symbolic(const Number& value, const std::string& what) {
    if (is_readable(value)) return quoted_expression(value);
    diagnostics_.unsupported({robot_.file, 0}, what + ": sines and roots of symbols cannot be written",
                             "give the angle a value in the file");
    return "0";
  }

  std::string number(const Number& value, const std::string& what) {
    if (has_symbols(value)) return symbolic(value, what);
    if (is_short_decimal(value)) return decimal_text(value);
    if (is_rational(value / GiNaC::Pi)) return quoted_expression(value);
    constexpr long kShort = 1000000;
    const bool is_short_fraction = is_rational(value) && GiNaC::ex_to<GiNaC::numeric>(value).denom() < kShort &&
                                   GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(value).numer()) < kShort;
    if (is_short_fraction) return quoted_expression(value);
    rounded_.push_back(what);
    return decimal_text(value);
  }

  // An expression is never snapped: angles are read as they are.
  std::string angle(const Number& value, const std::string& what) {
    if (vanishes(value)) return "0";
    if (has_symbols(value)) return symbolic(value, what);
    if (is_rational(value / GiNaC::Pi)) return quoted_expression(value);
    const std::string text = number(value, what);
    return text.front() == '"' ? text : toml_string(text);
  }

  std::string vector(const Vec3& v, const std::string& what) {
    const std::string x = number(v[0], what), y = number(v[1], what), z = number(v[2], what);
    return "[" + x + ", " + y + ", " + z + "]";
  }

  std::string angles(const Vec3& v, const std::string& what) {
    const std::string x = angle(v[0], what), y = angle(v[1], what), z = angle(v[2], what);
    return "[" + x + ", " + y + ", " + z + "]";
  }

  // ---- tables

  void add(const std::string& key, const std::string& value) { text_ += key + " = " + value + "\n"; }

  std::string link(int index) const { return toml_string(plain_.links[static_cast<std::size_t>(index)].name); }

  void write_top() {
    add("name", toml_string(robot_.name));
    add("gravity", vector(robot_.gravity, "gravity"));
    const CleanLink& base = plain_.links[static_cast<std::size_t>(robot_.root)];
    const bool is_plain = !base.body && !robot_.floating_base && base.name != "fixed" && base.name != "floating";
    if (is_plain) add("base", link(robot_.root));
    std::string held;
    for (const Joint& joint : robot_.joints) {
      if (!joint.held) continue;
      const bool turns = joint.held->type != JointType::prismatic;
      const std::string what = "joint \"" + joint.name + "\", fixed";
      held += (held.empty() ? "" : ", ") + toml_string(joint.name) + " = " +
              (turns ? angle(joint.held->position, what) : number(joint.held->position, what));
    }
    if (!held.empty()) add("fixed", "{ " + held + " }");
    if (!is_plain) write_base(base);
  }

  void write_base(const CleanLink& base) {
    text_ += "\n[base]\n";
    add("name", toml_string(base.name));
    if (robot_.floating_base) {
      add("motion", "\"floating\"");
      const BaseJoint& joint = robot_.base_joint;
      write_values({{"armature", &joint.armature}, {"viscous", &joint.viscous}, {"coulomb", &joint.coulomb}}, "base");
    }
    if (base.body) write_body(*base.body, "link \"" + base.name + "\"");
  }

  static const char* type_of(const Joint* joint) {
    if (joint == nullptr) return "fixed";
    switch (joint->held ? joint->held->type : joint->type) {
      case JointType::fixed:
        return "fixed";
      case JointType::prismatic:
        return "prismatic";
      case JointType::continuous:
        return "continuous";
      case JointType::spherical:
        return "spherical";
      case JointType::revolute:
        break;
    }
    return "revolute";
  }

  void write_row(const PlainJoint& plain) {
    const CleanLink& child = plain_.links[static_cast<std::size_t>(plain.child)];
    const std::string what = "joint \"" + plain.name + "\"";
    text_ += "\n[[link]]\n";
    add("name", toml_string(child.name));
    add("joint", toml_string(plain.name));
    add("parent", link(plain.parent));
    const std::string type = type_of(plain.joint);
    add("type", toml_string(type));
    if (!is_zero(plain.origin.xyz)) add("xyz", vector(plain.origin.xyz, what + ", xyz"));
    if (!is_zero(plain.origin.rpy)) add("rpy", angles(plain.origin.rpy, what + ", rpy"));
    if (type != "fixed" && type != "spherical") add("axis", vector(plain.axis, what + ", axis"));
    if (child.body) write_body(*child.body, "link \"" + child.name + "\"");
    if (plain.joint != nullptr && type != "fixed") write_motion(*plain.joint, what);
  }

  void write_body(const PlainBody& body, const std::string& what) {
    add("mass", number(body.mass, what + ", mass"));
    if (!is_zero(body.pose.xyz)) add("com", vector(body.pose.xyz, what + ", com"));
    const Mat3& I = body.tensor;
    std::string entries;
    const std::string names = "xyz";
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) {
        if (vanishes(I[i][j])) continue;
        entries += fmt::format("{}{}{} = {}", entries.empty() ? "" : ", ", names[i], names[j],
                               number(I[i][j], what + ", inertia"));
      }
    }
    if (entries.empty()) return;
    add("inertia", "{ " + entries + " }");
    add("inertia_about", "\"com\"");
  }

  // Those that are not zero.
  void write_values(const std::vector<std::pair<const char*, const Value*>>& values, const std::string& what) {
    for (const auto& [key, value] : values) {
      if (!vanishes(value->number)) add(key, number(value->number, what + ", " + key));
    }
  }

  void write_dry_friction(const Joint& joint, const std::string& what) {
    const DryFrictionLaw& law = joint.law;
    const std::string coulomb = what + ", coulomb";
    if (law.backward) {
      add("coulomb", fmt::format("{{ forward = {}, backward = {} }}", number(joint.coulomb.number, coulomb),
                                 number(law.backward->number, coulomb)));
    } else {
      write_values({{"coulomb", &joint.coulomb}}, what);
    }
    const auto write = [&](const char* key, const std::optional<Value>& value) {
      if (value) add(key, number(value->number, what + ", " + key));
    };
    write("coulomb_speed", law.speed);
    write("coulomb_offset", law.offset);
    write("static", law.static_friction);
    write("stribeck_speed", law.stribeck_speed);
    write("load_friction", law.load);
  }

  void write_motion(const Joint& joint, const std::string& what) {
    write_values({{"viscous", &joint.viscous}}, what);
    write_dry_friction(joint, what);
    write_values({{"armature", &joint.armature}}, what);
    if (!vanishes(joint.stiffness.number)) {
      write_values({{"stiffness", &joint.stiffness}, {"spring_reference", &joint.spring_reference}}, what);
    }
    if (joint.coupled) add("position", position_of(*joint.coupled));
    std::string limits;
    const auto limit = [&](const char* key, const std::optional<Value>& each) {
      if (each) {
        limits += fmt::format("{}{} = {}", limits.empty() ? "" : ", ", key, number(each->number, what + ", " + key));
      }
    };
    limit("lower", joint.limits.lower);
    limit("upper", joint.limits.upper);
    limit("velocity", joint.limits.velocity);
    limit("acceleration", joint.limits.acceleration);
    limit("effort", joint.limits.effort);
    if (!limits.empty()) add("limits", "{ " + limits + " }");
    if (joint.motor) write_motor(*joint.motor, what + ", motor");
  }

  void write_tendon(const Joint& tendon) {
    text_ += "\n[[tendon]]\n";
    add("name", toml_string(tendon.name));
    add("length", position_of(*tendon.coupled));
    const std::string what = "tendon \"" + tendon.name + "\"";
    write_values({{"stiffness", &tendon.stiffness},
                  {"spring_reference", &tendon.spring_reference},
                  {"viscous", &tendon.viscous}},
                 what);
    write_dry_friction(tendon, what);
    write_values({{"armature", &tendon.armature}}, what);
  }

  // "2*'elbow' + 1/3": rational numbers are written exactly, multiples of pi as such.
  static std::string position_of(const Coupled& coupled) {
    std::string text;
    for (const Coupled::Term& term : coupled.terms) {
      text += (text.empty() ? "(" : " + (") + ordered_text(term.factor) + ")*'" + term.joint.name + "'";
    }
    if (!vanishes(coupled.offset) || coupled.terms.empty()) {
      text += (text.empty() ? "(" : " + (") + ordered_text(coupled.offset) + ")";
    }
    return toml_string(text);
  }

  void write_motor(const Motor& motor, const std::string& what) {
    text_ += "[link.motor]\n";
    add("mass", number(motor.mass.number, what));
    add("inertia", number(motor.inertia_axial.number, what));
    add("inertia_transverse", number(motor.inertia_transverse.number, what));
    add("gear_ratio", number(motor.gear_ratio.number, what));
    add("axis", vector(motor.axis, what));
    add("position", vector(motor.position, what));
    if (motor.carrier >= 0) add("carrier", link(motor.carrier));
  }

  static std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + toml_string(name);
    return "[" + text + "]";
  }

  void write_loop(const Loop& loop) {
    const std::string what = name_of(loop);
    std::vector<std::string> dependent;
    for (const Reference& joint : loop.dependent) dependent.push_back(joint.name);
    text_ += "\n[[loop]]\n";
    add("links", list({loop.links[0].name, loop.links[1].name}));
    add("from", vector(loop.points[0], what + ", from"));
    add("to", vector(loop.points[1], what + ", to"));
    if (loop.axes) {
      add("from_axis", vector((*loop.axes)[0], what + ", from_axis"));
      add("to_axis", vector((*loop.axes)[1], what + ", to_axis"));
    }
    add("dependent", list(dependent));
  }

  void write_assembly() {
    if (robot_.assembly.empty()) return;
    text_ += "\n[assembly]\n";
    for (const JointPosition& each : robot_.assembly)
      add(toml_string(each.joint), angle(each.position, "assembly, joint \"" + each.joint + "\""));
  }

  void write_tip() {
    text_ += "\n[tip]\n";
    add("link", link(robot_.tip));
    const PlainPose pose = plain_pose_of(robot_.tip_offset);
    if (!is_zero(pose.xyz)) add("xyz", vector(pose.xyz, "tip, xyz"));
    if (!is_zero(pose.rpy)) add("rpy", angles(pose.rpy, "tip, rpy"));
  }

  const Robot& robot_;
  Diagnostics& diagnostics_;
  CleanRobot plain_;
  std::string text_;
  std::vector<std::string> rounded_;
};

}  // namespace

Conversion toml_of(const Robot& robot, Diagnostics& diagnostics) { return TomlWriter(robot, diagnostics).write(); }

}  // namespace flatdyn
