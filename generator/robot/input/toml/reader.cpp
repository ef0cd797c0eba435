// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/toml/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/poses.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/toml/held_joints.hpp"
#include "robot/input/toml/joint_in_parts.hpp"
#include "robot/input/toml/overlay.hpp"
#include "robot/input/toml/parts.hpp"
#include "robot/model/coupling.hpp"
#include "robot/model/tendon.hpp"

namespace flatdyn {

namespace {

constexpr std::array<const char*, 4> kDhKeys = {"a", "alpha", "d", "theta"};
constexpr std::array<const char*, 3> kPlacedKeys = {"xyz", "rpy", "axis"};

enum class DhConvention { none, standard, modified };

template <class Keys>
const char* first_key_of(const TomlTable& table, const Keys& keys) {
  for (const char* key : keys) {
    if (table.has(key)) return key;
  }
  return nullptr;
}

void add(Pose& pose, Displacement::Kind kind, const Number& angle) {
  if (!angle.is_zero()) pose.displacements.push_back({kind, zero_vector(), angle});
}

void add(Pose& pose, const Vec3& p) {
  if (p[0].is_zero() && p[1].is_zero() && p[2].is_zero()) return;
  pose.displacements.push_back({Displacement::Kind::translation, p, 0});
}

class TomlReader {
 public:
  TomlReader(TomlSource& source, std::string file, Robot& robot)
      : source_(source),
        file_(std::move(file)),
        context_(source.context()),
        diagnostics_(source.context().diagnostics),
        robot_(robot) {}

  // The robot in `robot`, and what is attached to it.
  Attachments read(const toml::table& root) {
    TomlTable table(root, "", source_);
    source_.set_units(read_units(table, diagnostics_));
    robot_.in_degrees = source_.units().degrees;
    const std::optional<std::string> name = table.text("name");
    table.text("description");
    table.text("source");
    read_fixed(table);
    Attachments attachments;
    if (is_overlay(table)) {
      attachments = read_overlay(table, file_, context_, robot_, carriers_);
    } else {
      read_links(table);
    }
    if (name) robot_.name = *name;
    robot_.gravity = table.vector("gravity", Quantity::acceleration, robot_.gravity);
    read_attachments(table, attachments);
    for (TomlTable& row : table.tables("loop")) read_loop(row);
    for (TomlTable& row : table.tables("tendon")) read_tendon(row);
    if (const std::optional<TomlTable> positions = table.table("assembly")) read_assembly(*positions);
    table.reject_unknown_keys();
    carriers_.find_in(robot_, diagnostics_);
    return attachments;
  }

 private:
  // A list of joints, held at 0, or a table with their positions.
  void read_fixed(TomlTable& table) {
    std::vector<HeldJoint>& held = context_.held_joints;
    if (!table.is_table("fixed")) {
      for (const Reference& joint : table.references("fixed"))
        held.push_back({{joint.name, 0, "0", true, joint.place}});
      return;
    }
    for (const JointPosition& lock : read_locked(*table.table("fixed"))) held.push_back({lock, source_.units()});
  }

  // ---- links of the file itself

  void read_links(TomlTable& table) {
    const Place top{file_, 0};
    convention_ = read_convention(table);
    robot_.links.push_back(read_base(table));
    std::vector<TomlTable> rows = table.tables("link");
    if (rows.empty() && !table.has("link") && !robot_.floating_base) {
      diagnostics_.error(top, "there is no [[link]] and no other robot file",
                         "add a [[link]] for each joint, or robot = \"file.urdf\"; a body that moves freely has base = "
                         "\"floating\"");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) name_link(rows[i], i + 1);
    for (std::size_t i = 0; i < rows.size(); ++i) read_row(rows[i], i + 1);
  }

  // The base link: base = "floating", base = its name, or a table with its name, motion and inertia.
  Link read_base(TomlTable& table) {
    Link base{"base", {}, table.has("base") ? table.place_of("base") : Place{file_, 1}};
    if (table.is_table("base")) {
      TomlTable row = *table.table("base");
      base.name = row.text("name").value_or("base");
      const std::string motion = read_choice(row, "motion", {"fixed", "floating"}, diagnostics_);
      robot_.floating_base = motion == "floating";
      read_base_joint(row);
      if (const auto inertial = read_inertial(row, diagnostics_)) base.inertials.push_back(*inertial);
      row.reject_unknown_keys();
      return base;
    }
    const std::string text = table.text("base").value_or("base");
    if (!read_motion_of_base(text, robot_)) base.name = text;
    return base;
  }

  void read_base_joint(TomlTable& row) {
    BaseJoint& joint = robot_.base_joint;
    const Value none{0, row.place()};
    joint.armature = row.number("armature", Quantity::other).value_or(none);
    joint.viscous = row.number("viscous", Quantity::viscous_friction).value_or(none);
    joint.coulomb = row.number("coulomb", Quantity::coulomb_friction).value_or(none);
    if (robot_.floating_base) return;
    for (const char* key : {"armature", "viscous", "coulomb"}) {
      if (!row.has(key)) continue;
      diagnostics_.error(row.place_of(key), fmt::format("base: {} has no effect on a base that does not move", key),
                         "leave it out, or write motion = \"floating\"");
    }
  }

  DhConvention read_convention(TomlTable& table) {
    const std::optional<std::string> convention = table.text("dh");
    if (convention == "standard") return DhConvention::standard;
    if (convention == "modified") return DhConvention::modified;
    if (table.has("dh")) convention_missed_ = true;
    if (convention) {
      diagnostics_.error(table.place_of("dh"), "dh: unknown convention " + quoted(*convention),
                         "write \"standard\" (Rz Tz Tx Rx) or \"modified\" (Rx Tx Tz Rz)");
    }
    return DhConvention::none;
  }

  void name_link(TomlTable& row, std::size_t number) {
    const std::string name = row.text("name").value_or("link" + std::to_string(number));
    row.rename("link " + quoted(name));
    if (name.empty()) diagnostics_.error(row.place_of("name"), "a link's name is empty", "give it a name");
    robot_.links.push_back({name, {}, row.place()});
  }

  void read_row(TomlTable& row, std::size_t number) {
    Joint joint = RobotBuilder::new_joint(row.text("joint").value_or("joint" + std::to_string(number)), row.place());
    joint.child = static_cast<int>(number);
    joint.parent = static_cast<int>(number) - 1;
    if (joint.name.empty())
      diagnostics_.error(row.place_of("joint"), row.what() + ", joint: the name is empty", "give it a name");
    if (const std::optional<Reference> parent = row.reference("parent")) {
      joint.parent = find_link(robot_, *parent, row.what() + ", parent", diagnostics_).value_or(-1);
    }
    const std::string type = row.is_text("type") ? *row.text("type") : "";
    if (!is_joint_in_parts(type)) joint.type = read_type(row);
    place_joint(row, joint);
    if (auto inertial = read_inertial(row, diagnostics_)) robot_.links[number].inertials.push_back(*inertial);
    if (is_joint_in_parts(type)) {
      read_joint_in_parts(row, type, joint, context_, carriers_, robot_);
      row.reject_unknown_keys();
      return;
    }
    read_joint_properties(row, context_, joint, carriers_);
    row.reject_unknown_keys();
    robot_.joints.push_back(std::move(joint));
  }

  JointType read_type(TomlTable& row) {
    static const std::map<std::string, JointType> kTypes = {{"revolute", JointType::revolute},
                                                            {"continuous", JointType::continuous},
                                                            {"prismatic", JointType::prismatic},
                                                            {"spherical", JointType::spherical},
                                                            {"fixed", JointType::fixed}};
    const std::string type = row.text("type").value_or("revolute");
    if (const auto found = kTypes.find(type); found != kTypes.end()) return found->second;
    const Place place = row.place_of("type");
    if (type == "floating") {
      diagnostics_.unsupported(place, row.what() + ": type " + quoted(type) + " is not supported yet",
                               "supported types: revolute, continuous, prismatic, spherical, fixed");
    } else if (type == "ball") {
      diagnostics_.error(place, row.what() + ": type " + quoted(type), "write \"spherical\"");
    } else {
      diagnostics_.error(
          place, row.what() + ": unknown type " + quoted(type),
          hint_for_unknown(type, {"revolute", "continuous", "prismatic", "spherical", "fixed"}, "types"));
    }
    return JointType::revolute;  // to read on: what a moving joint has is not wrong then
  }

  void place_joint(TomlTable& row, Joint& joint) {
    const char* dh_key = first_key_of(row, kDhKeys);
    const char* placed_key = first_key_of(row, kPlacedKeys);
    if (dh_key != nullptr && placed_key != nullptr) {
      diagnostics_.error(row.place_of(placed_key),
                         row.what() + ": " + dh_key + " (DH) and " + placed_key + " exclude each other",
                         "place a link either by a, alpha, d, theta or by xyz, rpy, axis");
    }
    if (dh_key != nullptr && convention_ == DhConvention::none && !std::exchange(convention_missed_, true)) {
      diagnostics_.error(row.place_of(dh_key),
                         row.what() + ": " + dh_key + " is given, but the file does not say which DH convention it is",
                         "write dh = \"standard\" or dh = \"modified\" at the top of the file");
    }
    const Vec3 xyz = row.vector("xyz", Quantity::length, zero_vector());
    const Vec3 rpy = row.angles("rpy");
    joint.axis = row.vector("axis", Quantity::other, {0, 0, 1});
    if (joint.type == JointType::spherical && row.has("axis")) {
      diagnostics_.error(row.place_of("axis"), row.what() + ": a spherical joint has no axis",
                         "leave it out; rpy turns the axes of the joint");
    }
    joint.origin = pose_from_xyz_rpy(xyz, rpy, row.place());
    joint.link_offset.place = row.place();
    const Number a = row.number_or_zero("a", Quantity::length).number;
    const Number alpha = row.angle("alpha");
    const Number d = row.number_or_zero("d", Quantity::length).number;
    const Number theta = row.angle("theta");
    if (placed_key == nullptr) place_by_dh(a, alpha, d, theta, joint);
  }

  // The joint moves about or along z, so its own motion may come before or after the constant part of Rz and Tz.
  void place_by_dh(const Number& a, const Number& alpha, const Number& d, const Number& theta, Joint& joint) const {
    if (convention_ == DhConvention::standard) {  // Rz(theta) Tz(d) Tx(a) Rx(alpha)
      add(joint.link_offset, Displacement::Kind::rotation_z, theta);
      add(joint.link_offset, {a, 0, d});
      add(joint.link_offset, Displacement::Kind::rotation_x, alpha);
    } else {  // Tx(a) Rx(alpha) Tz(d) Rz(theta)
      add(joint.origin, {a, 0, 0});
      add(joint.origin, Displacement::Kind::rotation_x, alpha);
      add(joint.origin, {0, 0, d});
      add(joint.origin, Displacement::Kind::rotation_z, theta);
    }
  }

  // ---- the whole robot

  void read_attachments(TomlTable& table, Attachments& attachments) {
    if (std::optional<TomlTable> tip = table.table("tip")) {
      attachments.tip = tip->reference("link");
      const Vec3 xyz = tip->vector("xyz", Quantity::length, zero_vector());
      attachments.tip_offset = pose_from_xyz_rpy(xyz, tip->angles("rpy"), tip->place());
      tip->reject_unknown_keys();
    }
    if (std::optional<TomlTable> payload = table.table("payload")) {
      const std::optional<Reference> link = payload->reference("link");
      if (auto inertial = read_inertial(*payload, diagnostics_)) attachments.payload = {link, *inertial};
      payload->reject_unknown_keys();
    }
  }

  void read_assembly(const TomlTable& positions) {
    robot_.assembly = read_locked(positions);
    for (JointPosition& position : robot_.assembly) {
      const Spot spot{position.place, "assembly, joint \"" + position.joint + "\""};
      for (const Joint& joint : robot_.joints) {
        if (joint.name == position.joint)
          position.position = assembled({position, source_.units()}, joint, spot, context_);
      }
    }
  }

  // For a loop.
  bool check_axes(const TomlTable& row, const std::array<Vec3, 2>& axes) {
    static constexpr std::array<const char*, 2> kKeys = {"from_axis", "to_axis"};
    for (std::size_t e = 0; e < 2; ++e) {
      const std::string key = kKeys[e], what = "loop, " + key + ": ";
      if (!row.has(key)) {
        diagnostics_.error(row.place(), what + "missing", "give the axis in both links, or in none");
      } else if (std::any_of(axes[e].begin(), axes[e].end(), has_symbols)) {
        diagnostics_.unsupported(row.place_of(key), what + "a symbol in the axis is not supported", "write numbers");
      } else if (vanishes(dot(axes[e], axes[e]))) {
        diagnostics_.error(row.place_of(key), what + "the axis is zero", "give the axis a direction");
      } else {
        continue;
      }
      return false;
    }
    return true;
  }

  void read_loop(TomlTable& row) {
    const std::vector<Reference> links = row.references("links"), dependent = row.references("dependent");
    Loop loop;
    loop.place = row.place();
    loop.points[0] = row.vector("from", Quantity::length, zero_vector());
    loop.points[1] = row.vector("to", Quantity::length, zero_vector());
    loop.dependent = dependent;
    const bool has_axes = row.has("from_axis") || row.has("to_axis");
    loop.axes = {row.vector("from_axis", Quantity::other, {0, 0, 1}),
                 row.vector("to_axis", Quantity::other, {0, 0, 1})};
    row.reject_unknown_keys();
    if (!has_axes) loop.axes.reset();
    if (has_axes && !check_axes(row, *loop.axes)) return;
    if (links.size() != 2) {
      diagnostics_.error(row.place_of("links"), "loop: two links are expected, which meet where it is closed",
                         "write links = [\"...\", \"...\"]");
      return;
    }
    loop.links = {links[0], links[1]};
    robot_.loops.push_back(std::move(loop));
  }

  // Its numbers are in SI units, whatever the units of the file.
  void read_tendon(TomlTable& row) {
    Joint tendon;
    tendon.place = row.place();
    tendon.name = row.text("name").value_or("");
    row.rename("tendon " + flatdyn::quoted(tendon.name));
    if (tendon.name.empty()) diagnostics_.error(row.place(), "a tendon has no name", "write name = \"...\"");
    const std::optional<Coupled> length = row.tendon_length("length");
    const Value none{0, tendon.place};
    tendon.stiffness = row.number("stiffness", Quantity::other).value_or(none);
    tendon.spring_reference = row.number("spring_reference", Quantity::other).value_or(none);
    tendon.viscous = row.number("viscous", Quantity::other).value_or(none);
    tendon.coulomb = none;
    read_coulomb(row, context_, tendon);
    tendon.armature = row.number("armature", Quantity::other).value_or(none);
    read_friction_law(row, tendon);
    row.reject_unknown_keys();
    if (!row.has("length")) {
      diagnostics_.error(row.place(), row.what() + " has no length", "write length = \"0.5*left + 0.5*right\"");
    }
    if (!length || tendon.name.empty()) return;
    tendon.coupled = length;
    if (!vanishes(own_factor(tendon.name, *length))) {
      diagnostics_.error(length->place, row.what() + ": its length follows itself", "name joints");
      return;
    }
    add_tendon(std::move(tendon), robot_);
  }

  TomlSource& source_;
  std::string file_;
  ReadContext& context_;
  Diagnostics& diagnostics_;
  Robot& robot_;
  DhConvention convention_ = DhConvention::none;
  bool convention_missed_ = false;  // and that was said
  MotorCarriers carriers_;
};

}  // namespace

Attachments read_toml(const std::string& text, const std::string& file, ReadContext& context, Robot& robot) {
  TomlSource source(text, file, context);
  const std::optional<toml::table> root = source.parse();
  if (!root) return {};
  return TomlReader(source, file, robot).read(*root);
}

}  // namespace flatdyn
