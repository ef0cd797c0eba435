// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/toml_reader.hpp"

#include <array>
#include <filesystem>
#include <map>

#include "diagnostics/nearest.hpp"
#include "input/toml_parts.hpp"
#include "input/urdf_reader.hpp"
#include "input/urdf_values.hpp"

namespace flatdyn {

namespace {

constexpr std::array<const char*, 4> kDhKeys = {"a", "alpha", "d", "theta"};
constexpr std::array<const char*, 3> kPlacedKeys = {"xyz", "rpy", "axis"};
constexpr std::array<const char*, 2> kOverKeys = {"urdf", "robot"};

enum class DhConvention { none, standard, modified };

template <class Keys>
const char* first_key_of(const TomlTable& table, const Keys& keys) {
  for (const char* key : keys) {
    if (table.has(key)) return key;
  }
  return nullptr;
}

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

void add(Pose& pose, Displacement::Kind kind, const Number& angle) {
  if (!angle.is_zero()) pose.displacements.push_back({kind, zero_vector(), angle});
}

void add(Pose& pose, const Vec3& p) {
  if (p[0].is_zero() && p[1].is_zero() && p[2].is_zero()) return;
  pose.displacements.push_back({Displacement::Kind::translation, p, 0});
}

class TomlReader {
 public:
  TomlReader(const TomlSource& source, std::string file, Robot& robot)
      : source_(source),
        file_(std::move(file)),
        context_(source.context()),
        diagnostics_(source.context().diagnostics),
        robot_(robot) {}

  // The robot in `robot`, and what is attached to it.
  Attachments read(const toml::table& root) {
    TomlTable table(root, "", source_);
    const std::optional<std::string> name = table.text("name");
    table.text("description");
    table.text("source");
    for (const std::string& joint : table.texts("fixed")) {
      context_.held_joints.push_back({joint, table.place_of("fixed")});
    }
    Attachments attachments;
    if (const char* const key = first_key_of(table, kOverKeys)) {
      attachments = read_over(table, key);
    } else {
      read_links(table);
    }
    if (name) robot_.name = *name;
    robot_.gravity = table.vector("gravity", Quantity::acceleration, robot_.gravity);
    read_attachments(table, attachments);
    table.reject_unknown_keys();
    for (const auto& [joint, motor] : carriers_) find_carrier(joint, motor);
    return attachments;
  }

 private:
  struct Carrier {
    Reference link;
    std::string what;
  };

  // ---- links of the file itself

  void read_links(TomlTable& table) {
    const Place top{file_, 0};
    convention_ = read_convention(table);
    robot_.links.push_back(
        {table.text("base").value_or("base"), {}, table.has("base") ? table.place_of("base") : Place{file_, 1}});
    std::vector<TomlTable> rows = table.tables("link");
    if (rows.empty() && !table.has("link")) {
      diagnostics_.error(top, "there is no [[link]] and no urdf",
                         "add a [[link]] for each joint, or robot = \"file.urdf\"");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) name_link(rows[i], i + 1);
    for (std::size_t i = 0; i < rows.size(); ++i) read_row(rows[i], i + 1);
  }

  DhConvention read_convention(TomlTable& table) {
    const std::optional<std::string> convention = table.text("dh");
    if (convention == "standard") return DhConvention::standard;
    if (convention == "modified") return DhConvention::modified;
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
    Joint joint;
    joint.place = row.place();
    joint.name = row.text("joint").value_or("joint" + std::to_string(number));
    joint.child = static_cast<int>(number);
    joint.parent = static_cast<int>(number) - 1;
    if (joint.name.empty())
      diagnostics_.error(row.place_of("joint"), row.what() + ", joint: the name is empty", "give it a name");
    if (const std::optional<Reference> parent = row.reference("parent")) {
      joint.parent = find_link(robot_, *parent, row.what() + ", parent", diagnostics_).value_or(-1);
    }
    joint.type = read_type(row);
    place_joint(row, joint);
    if (auto inertial = read_inertial(row, diagnostics_)) robot_.links[number].inertials.push_back(*inertial);
    joint.viscous.place = joint.coulomb.place = joint.armature.place = joint.place;
    read_properties(row, joint);
    row.reject_unknown_keys();
    robot_.joints.push_back(std::move(joint));
  }

  JointType read_type(TomlTable& row) {
    static const std::map<std::string, JointType> kTypes = {{"revolute", JointType::revolute},
                                                            {"continuous", JointType::continuous},
                                                            {"prismatic", JointType::prismatic},
                                                            {"fixed", JointType::fixed}};
    const std::string type = row.text("type").value_or("revolute");
    if (const auto found = kTypes.find(type); found != kTypes.end()) return found->second;
    const Place place = row.place_of("type");
    if (type == "floating" || type == "planar" || type == "ball" || type == "spherical") {
      diagnostics_.unsupported(place, row.what() + ": type " + quoted(type) + " is not supported yet",
                               "supported types: revolute, continuous, prismatic, fixed");
    } else {
      diagnostics_.error(place, row.what() + ": unknown type " + quoted(type),
                         hint_for_unknown(type, {"revolute", "continuous", "prismatic", "fixed"}, "types"));
    }
    return JointType::fixed;
  }

  void place_joint(TomlTable& row, Joint& joint) {
    const char* dh_key = first_key_of(row, kDhKeys);
    const char* placed_key = first_key_of(row, kPlacedKeys);
    if (dh_key != nullptr && placed_key != nullptr) {
      diagnostics_.error(row.place_of(placed_key),
                         row.what() + ": " + dh_key + " (DH) and " + placed_key + " exclude each other",
                         "place a link either by a, alpha, d, theta or by xyz, rpy, axis");
    }
    if (dh_key != nullptr && convention_ == DhConvention::none) {
      diagnostics_.error(row.place_of(dh_key),
                         row.what() + ": " + dh_key + " is given, but the file does not say which DH convention it is",
                         "write dh = \"standard\" or dh = \"modified\" at the top of the file");
    }
    const Vec3 xyz = row.vector("xyz", Quantity::length, zero_vector());
    const Vec3 rpy = row.angles("rpy");
    joint.axis = row.vector("axis", Quantity::other, {0, 0, 1});
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

  void read_properties(TomlTable& table, Joint& joint) {
    const std::optional<Reference> carrier = read_joint_properties(table, joint);
    if (joint.motor && joint.type == JointType::fixed) {
      diagnostics_.error(joint.motor->place, table.what() + ": a fixed joint has no motor",
                         "add the motor's mass to the link that carries it");
      joint.motor.reset();
    }
    if (joint.motor && carrier) carriers_[joint.name] = {*carrier, table.what() + ", motor, carrier"};
  }

  void find_carrier(const std::string& joint_name, const Carrier& carrier) {
    for (Joint& joint : robot_.joints) {
      if (joint.name != joint_name || !joint.motor) continue;
      joint.motor->carrier = find_link(robot_, carrier.link, carrier.what, diagnostics_).value_or(-1);
    }
  }

  // ---- another robot file and what is added to it

  Attachments read_over(TomlTable& table, const std::string& key) {
    for (const char* other : kOverKeys) {
      if (other == key || !table.has(other)) continue;
      diagnostics_.error(table.place_of(other), key + " and " + other + " exclude each other", "name one robot file");
      table.text(other);
    }
    const Attachments attachments = read_base(table, key);
    for (TomlTable& row : table.tables("link")) read_link_row(row);
    for (TomlTable& row : table.tables("joint")) read_joint_row(row);
    return attachments;
  }

  Attachments read_base(TomlTable& table, const std::string& key) {
    const std::optional<std::string> name = table.text(key);
    if (!name) return {};
    const Place place = table.place_of(key);
    const std::filesystem::path path = std::filesystem::path(file_).parent_path() / *name;
    if (!std::filesystem::exists(path)) {
      diagnostics_.error(place, key + ": there is no file " + quoted(path.string()),
                         "the path is relative to this TOML file");
      return {};
    }
    for (const std::string& read : robot_.files) {
      if (!std::filesystem::equivalent(read, path)) continue;
      diagnostics_.error(place, key + ": " + quoted(path.string()) + " names itself, or a file that names it",
                         "name a robot file that stands by itself");
      return {};
    }
    const std::optional<std::string> text = file_text(path.string(), diagnostics_);
    if (!text) return {};
    robot_.files.push_back(path.string());
    if (path.extension() == ".toml" && key == "robot") return read_toml(*text, path.string(), context_, robot_);
    read_urdf(*text, path.string(), context_, robot_);
    return {};
  }

  // Mass, centre of mass and inertia of a link that is there, replaced.
  void read_link_row(TomlTable& row) {
    const std::optional<Reference> name = row.reference("name");
    if (!name) {
      diagnostics_.error(row.place(), "link: it has no name", "write name = \"...\", a link of the robot file");
      return;
    }
    row.rename("link " + quoted(name->name));
    const std::optional<Inertial> inertial = read_inertial(row, diagnostics_);
    row.reject_unknown_keys();
    if (robot_.links.empty()) return;  // the robot file could not be read: said there
    const std::optional<int> link = find_link(robot_, *name, row.what(), diagnostics_);
    if (link && inertial) robot_.links[static_cast<std::size_t>(*link)].inertials = {*inertial};
  }

  void read_joint_row(TomlTable& row) {
    const std::optional<std::string> name = row.text("name");
    if (!name) {
      diagnostics_.error(row.place(), "joint: it has no name", "write name = \"...\", a joint of the robot file");
      return;
    }
    row.rename("joint " + quoted(*name));
    std::vector<std::string> known;
    for (Joint& joint : robot_.joints) {
      known.push_back(joint.name);
      if (joint.name != *name) continue;
      read_properties(row, joint);
      row.reject_unknown_keys();
      return;
    }
    if (robot_.joints.empty()) return;  // the robot file could not be read: said there
    diagnostics_.error(row.place_of("name"), "there is no joint " + quoted(*name) + " in the robot file",
                       hint_for_unknown(*name, known, "joints"));
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

  const TomlSource& source_;
  std::string file_;
  ReadContext& context_;
  Diagnostics& diagnostics_;
  Robot& robot_;
  DhConvention convention_ = DhConvention::none;
  std::map<std::string, Carrier> carriers_;  // by the name of the joint
};

}  // namespace

std::optional<int> find_link(const Robot& robot, const Reference& link, const std::string& what,
                             Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].name == link.name) return static_cast<int>(i);
    known.push_back(robot.links[i].name);
  }
  diagnostics.error(link.place, what + ": there is no link " + quoted(link.name),
                    hint_for_unknown(link.name, known, "links"));
  return std::nullopt;
}

Attachments read_toml(const std::string& text, const std::string& file, ReadContext& context, Robot& robot) {
  const TomlSource source(text, file, context);
  const std::optional<toml::table> root = source.parse();
  if (!root) return {};
  return TomlReader(source, file, robot).read(*root);
}

}  // namespace flatdyn
