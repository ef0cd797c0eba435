// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "delivery/convert/conversion.hpp"
#include "delivery/convert/decimals.hpp"
#include "delivery/convert/plain_robot.hpp"

namespace flatdyn {

namespace {

constexpr const char* kTomlHint = "write a TOML file: -o robot.toml";

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

class UrdfWriter {
 public:
  UrdfWriter(const Robot& robot, Diagnostics& diagnostics)
      : robot_(robot), diagnostics_(diagnostics), plain_(plain_robot(robot, {})) {}

  Conversion write() {
    refuse_what_urdf_lacks();
    if (diagnostics_.has_errors()) return {};
    text_ = fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", xml_text(robot_.name));
    for (const CleanLink& link : plain_.links) write_link(link);
    if (robot_.floating_base) write_free_joint();
    for (const PlainJoint& joint : plain_.joints) write_joint(joint);
    text_ += springs_ + "</robot>\n";
    return {std::move(text_), std::move(rounded_)};
  }

 private:
  void refuse(const Place& place, const std::string& what, const std::string& hint = kTomlHint) {
    diagnostics_.unsupported(place, "a URDF cannot say " + what, hint);
  }

  void refuse_what_urdf_lacks() {
    const Place file{robot_.file, 0};
    for (const Value* value : {&robot_.base_joint.armature, &robot_.base_joint.viscous, &robot_.base_joint.coulomb}) {
      if (!robot_.floating_base || vanishes(value->number)) continue;
      refuse(value->place, "that a base that floats has armature or friction of its own");
      break;
    }
    const Vec3 usual = {0, 0, exact_decimal("-9.81")};
    for (std::size_t i = 0; i < 3; ++i) {
      if (vanishes(robot_.gravity[i] - usual[i])) continue;
      refuse(file, "which gravity there is, if it is not (0, 0, -9.81) m/s^2");
      break;
    }
    if (!robot_.symbols.empty()) refuse(robot_.symbols.front().place, "symbols such as " + robot_.symbols.front().name);
    if (!robot_.tip_offset.displacements.empty()) refuse(file, "where the tip is in its link");
    if (!robot_.loops.empty())
      refuse(robot_.loops.front().place, "how chains are closed, such as " + name_of(robot_.loops.front()));
    for (const Joint& joint : robot_.joints) refuse_joint(joint);
  }

  void refuse_joint(const Joint& joint) {
    const std::string whose = " of joint \"" + joint.name + "\"";
    if (joint.type == JointType::spherical) refuse(joint.place, "that joint \"" + joint.name + "\" is spherical");
    if (joint.is_tendon) return refuse(joint.place, "a tendon, \"" + joint.name + "\"");
    if (joint.law.is_given()) refuse(joint.coulomb.place, "how friction changes with the rate" + whose);
    if (joint.motor) refuse(joint.motor->place, "what the motor" + whose + " does to the link that carries it");
    if (joint.held && !vanishes(joint.held->position))
      refuse(joint.place, "the position of a joint that is held" + whose);
    if (!joint.coupled) return;
    const bool is_own = std::any_of(joint.coupled->terms.begin(), joint.coupled->terms.end(),
                                    [&](const Coupled::Term& term) { return term.joint.name == joint.name; });
    if (joint.coupled->terms.size() != 1 || is_own) refuse(joint.coupled->place, "the coupling" + whose);
  }

  // ---- numbers

  std::string number(const Number& value, const std::string& what) {
    if (!is_short_decimal(value)) rounded_.push_back(what);
    return decimal_text(value);
  }

  // A reader takes the nearest decimal of a multiple of pi/12 for it.
  std::string angle(const Number& value, const std::string& what) {
    constexpr int kDigits = 17;
    return twelfths_of_pi(value) != 0 ? to_decimal(value, kDigits) : number(value, what);
  }

  std::string vector(const Vec3& v, const std::string& what) {
    const std::string x = number(v[0], what), y = number(v[1], what), z = number(v[2], what);
    return x + " " + y + " " + z;
  }

  std::string origin(const PlainPose& pose, const std::string& what) {
    const auto is_zero = [](const Vec3& v) {
      return std::all_of(v.begin(), v.end(), [](const Number& x) { return vanishes(x); });
    };
    std::string attributes;
    if (!is_zero(pose.xyz)) attributes += " xyz=\"" + vector(pose.xyz, what + ", xyz") + "\"";
    if (!is_zero(pose.rpy)) {
      const std::string r = angle(pose.rpy[0], what + ", rpy"), p = angle(pose.rpy[1], what + ", rpy");
      attributes += " rpy=\"" + r + " " + p + " " + angle(pose.rpy[2], what + ", rpy") + "\"";
    }
    return attributes.empty() ? "" : "<origin" + attributes + "/>\n";
  }

  // ---- elements

  void add(int depth, const std::string& element) {
    if (!element.empty()) text_ += std::string(static_cast<std::size_t>(2 * depth), ' ') + element;
  }

  void write_link(const CleanLink& link) {
    if (!link.body) return add(1, fmt::format("<link name=\"{}\"/>\n", xml_text(link.name)));
    const std::string what = "link \"" + link.name + "\"";
    const Mat3& I = link.body->tensor;
    add(1, fmt::format("<link name=\"{}\">\n", xml_text(link.name)));
    add(2, "<inertial>\n");
    add(3, origin(link.body->pose, what + ", inertial"));
    add(3, fmt::format("<mass value=\"{}\"/>\n", number(link.body->mass, what + ", mass")));
    const std::string tensor = what + ", inertia";
    std::string entries;
    const std::string names = "xyz";
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) {
        entries += fmt::format(" i{}{}=\"{}\"", names[i], names[j], number(I[i][j], tensor));
      }
    }
    add(3, "<inertia" + entries + "/>\n");
    add(2, "</inertial>\n");
    add(1, "</link>\n");
  }

  static const char* type_of(const Joint* joint) {
    if (joint == nullptr || joint->type == JointType::fixed) return "fixed";
    if (joint->type == JointType::prismatic) return "prismatic";
    return joint->type == JointType::continuous ? "continuous" : "revolute";
  }

  void write_joint(const PlainJoint& plain) {
    const std::string what = "joint \"" + plain.name + "\"";
    const auto link = [this](int index) { return xml_text(plain_.links[static_cast<std::size_t>(index)].name); };
    add(1, fmt::format("<joint name=\"{}\" type=\"{}\">\n", xml_text(plain.name), type_of(plain.joint)));
    add(2, origin(plain.origin, what + ", origin"));
    add(2, fmt::format("<parent link=\"{}\"/>\n", link(plain.parent)));
    add(2, fmt::format("<child link=\"{}\"/>\n", link(plain.child)));
    if (plain.joint != nullptr && plain.joint->type != JointType::fixed) write_motion(plain, what);
    add(1, "</joint>\n");
  }

  // A floating base: a joint between it and a link that stands for the world.
  void write_free_joint() {
    const std::string world = unused("world"),
                      base = xml_text(plain_.links[static_cast<std::size_t>(robot_.root)].name);
    add(1, fmt::format("<link name=\"{}\"/>\n", world));
    add(1, fmt::format("<joint name=\"{}\" type=\"floating\">\n", unused("floating_base")));
    add(2, fmt::format("<parent link=\"{}\"/>\n", world));
    add(2, fmt::format("<child link=\"{}\"/>\n", base));
    add(1, "</joint>\n");
  }

  // The name, with underscores behind it as long as a link or joint has it.
  std::string unused(std::string name) const {
    const auto is_taken = [&](const auto& each) { return each.name == name; };
    while (std::any_of(plain_.links.begin(), plain_.links.end(), is_taken) ||
           std::any_of(plain_.joints.begin(), plain_.joints.end(), is_taken)) {
      name += "_";
    }
    return name;
  }

  void write_motion(const PlainJoint& plain, const std::string& what) {
    const Joint& joint = *plain.joint;
    add(2, fmt::format("<axis xyz=\"{}\"/>\n", vector(plain.axis, what + ", axis")));
    std::string limits, dynamics;
    const auto limit = [&](const char* name, const std::optional<Value>& value) {
      if (value) limits += fmt::format(" {}=\"{}\"", name, number(value->number, what + ", " + name));
    };
    limit("lower", joint.limits.lower);
    limit("upper", joint.limits.upper);
    limit("effort", joint.limits.effort);
    limit("velocity", joint.limits.velocity);
    limit("acceleration", joint.limits.acceleration);
    if (!limits.empty()) add(2, "<limit" + limits + "/>\n");
    const auto dynamic = [&](const char* name, const Value& value) {
      if (!vanishes(value.number)) {
        dynamics += fmt::format(" {}=\"{}\"", name, number(value.number, what + ", " + name));
      }
    };
    dynamic("damping", joint.viscous);
    dynamic("friction", joint.coulomb);
    dynamic("armature", joint.armature);
    if (!dynamics.empty()) add(2, "<dynamics" + dynamics + "/>\n");
    if (joint.coupled) write_mimic(*joint.coupled, what);
    if (!vanishes(joint.stiffness.number)) add_spring(joint, what);
  }

  // Gazebo's words, as URDF has none.
  void add_spring(const Joint& joint, const std::string& what) {
    springs_ += fmt::format("  <gazebo reference=\"{}\">\n    <springStiffness>{}</springStiffness>\n",
                            xml_text(joint.name), number(joint.stiffness.number, what + ", stiffness"));
    if (!vanishes(joint.spring_reference.number)) {
      springs_ += fmt::format("    <springReference>{}</springReference>\n",
                              number(joint.spring_reference.number, what + ", spring_reference"));
    }
    springs_ += "  </gazebo>\n";
  }

  void write_mimic(const Coupled& coupled, const std::string& what) {
    const Coupled::Term& term = coupled.terms.front();
    add(2, fmt::format("<mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>\n", xml_text(term.joint.name),
                       number(term.factor, what + ", mimic"), number(coupled.offset, what + ", mimic")));
  }

  const Robot& robot_;
  Diagnostics& diagnostics_;
  CleanRobot plain_;
  std::string text_, springs_;
  std::vector<std::string> rounded_;
};

}  // namespace

Conversion urdf_of(const Robot& robot, Diagnostics& diagnostics) { return UrdfWriter(robot, diagnostics).write(); }

}  // namespace flatdyn
