// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/toml/joint_in_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "robot/input/common/joint_parts.hpp"

namespace flatdyn {

namespace {

constexpr std::array<const char*, 10> kKeysOfCoordinates = {
    "viscous",        "coulomb",       "coulomb_speed", "coulomb_offset", "static",
    "stribeck_speed", "load_friction", "armature",      "stiffness",      "spring_reference"};
constexpr std::array<const char*, 5> kKeysOfLimits = {"lower", "upper", "velocity", "acceleration", "effort"};
constexpr std::array<const char*, 2> kKeysOfOneCoordinate = {"position", "motor"};

class PartsReader {
 public:
  PartsReader(TomlTable& row, const std::string& type, const Joint& whole, ReadContext& context,
              MotorCarriers& carriers, Robot& robot)
      : row_(row),
        type_(type),
        whole_(whole),
        context_(context),
        diagnostics_(context.diagnostics),
        carriers_(carriers),
        robot_(robot) {}

  void read() {
    const Vec3 second = row_.vector("axis2", Quantity::other, {0, 1, 0});
    std::vector<Joint> parts;
    if (!refuse_dh() && check_axes(second)) parts = parts_by_type(second);
    if (parts.empty()) {
      take_all_keys();
      robot_.joints.push_back(whole_);  // so that its link does not seem to be free
      return;
    }
    hold_parts(whole_.name, parts, context_);
    type_ == "screw" ? read_screw(parts.front()) : read_each(parts);
    for (Joint& part : joined_in_tree(whole_, parts, robot_)) robot_.joints.push_back(std::move(part));
  }

 private:
  // Along and about z alone, a joint can come before or after the constant parts of its frame.
  bool refuse_dh() {
    if (type_ == "cylindrical" || type_ == "screw") return false;
    for (const char* key : {"a", "alpha", "d", "theta"}) {
      if (!row_.has(key)) continue;
      diagnostics_.error(row_.place_of(key), row_.what() + ", " + key + ": DH keys cannot place a " + type_ + " joint",
                         "place it by xyz, rpy, axis");
      return true;
    }
    return false;
  }

  bool check_axes(const Vec3& second) {
    const bool is_universal = type_ == "universal";
    if (is_universal != row_.has("axis2")) {
      diagnostics_.error(row_.place_of("axis2"),
                         row_.what() + (is_universal ? ": a universal joint needs axis2" : ": axis2 has no effect"),
                         is_universal ? "give the second axis in the joint's frame, axis2 = [0, 1, 0]"
                                      : "leave it out, or write type = \"universal\"");
      return false;
    }
    const bool is_zero = vanishes(dot(whole_.axis, whole_.axis)) || (is_universal && vanishes(dot(second, second)));
    const Vec3 across = cross(whole_.axis, second);
    if (is_zero || (is_universal && vanishes(dot(across, across).expand()))) {
      diagnostics_.error(row_.place_of(is_zero && vanishes(dot(whole_.axis, whole_.axis)) ? "axis" : "axis2"),
                         row_.what() + (is_zero ? ": its axis is zero" : ": its two axes are parallel"),
                         "give each axis a direction of its own");
      return false;
    }
    return true;
  }

  // Empty, and an error, if a screw has no pitch.
  std::vector<Joint> parts_by_type(const Vec3& second) {
    if (type_ == "planar") {
      std::vector<Joint> parts = planar_parts(whole_, row_.what() + ", axis", context_);
      parts.back().type = JointType::revolute;  // it may have limits
      return parts;
    }
    if (type_ == "cylindrical") {
      return {part_of_joint(whole_, ".turn", JointType::revolute),
              part_of_joint(whole_, ".slide", JointType::prismatic)};
    }
    if (type_ == "universal") {
      std::vector<Joint> parts = {part_of_joint(whole_, ".axis", JointType::revolute),
                                  part_of_joint(whole_, ".axis2", JointType::revolute)};
      parts[1].axis = second;
      return parts;
    }
    const auto pitch = row_.numbers("pitch", 1);
    if (pitch && !vanishes(pitch->front().number)) return screw_parts(whole_, pitch->front().number);
    if (pitch || !row_.has("pitch")) {
      diagnostics_.error(row_.place_of("pitch"), row_.what() + ": a screw needs a pitch other than 0",
                         "write pitch = ..., in m/rad, positive if right-handed");
    }
    return {};
  }

  void read_screw(Joint& turn) {
    if (row_.has("position")) {
      diagnostics_.unsupported(row_.place_of("position"), row_.what() + ": a screw that follows is not supported",
                               "leave position out");
    }
    read_joint_properties(row_, context_, turn, carriers_);
    turn.coupled.reset();
  }

  void read_each(std::vector<Joint>& parts) {
    for (const char* key : kKeysOfOneCoordinate) {
      if (!row_.has(key)) continue;
      diagnostics_.unsupported(row_.place_of(key),
                               row_.what() + ", " + key + ": not supported for a joint of type \"" + type_ + "\"",
                               "leave it out, or write its coordinates as joints of their own");
      return take_all_keys();
    }
    if (!check_lists(row_, parts, kKeysOfCoordinates)) return take_all_keys();
    if (std::optional<TomlTable> limits = row_.table("limits"); limits && !check_lists(*limits, parts, kKeysOfLimits))
      return take_all_keys();
    const std::size_t before = diagnostics_.all().size();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (diagnostics_.has_errors() && diagnostics_.all().size() > before) break;  // each part would repeat them
      TomlTable of_part = row_.with_element(k, row_.what() + ", " + parts[k].name);
      MotorCarriers none;
      read_joint_properties(of_part, context_, parts[k], none);
    }
    take_all_keys();
  }

  template <class Keys>
  bool check_lists(TomlTable& table, const std::vector<Joint>& parts, const Keys& keys) {
    std::vector<std::string> names;
    for (const Joint& part : parts) names.push_back(part.name);
    bool are_lists = true;
    for (const char* key : keys) {
      if (!table.has(key) || table.list_size(key) == parts.size()) continue;
      diagnostics_.error(table.place_of(key),
                         table.what() + ", " + key + ": a list of " + std::to_string(parts.size()) +
                             " numbers is expected, one per coordinate",
                         fmt::format("in this order: {}", fmt::join(names, ", ")));
      are_lists = false;
    }
    return are_lists;
  }

  // They are read by part, or not at all after an error.
  void take_all_keys() {
    for (const char* key : kKeysOfCoordinates) row_.accept(key);
    for (const char* key : kKeysOfOneCoordinate) row_.accept(key);
    row_.accept("limits");
    if (type_ == "screw") row_.accept("pitch");
  }

  TomlTable& row_;
  const std::string& type_;
  const Joint& whole_;
  ReadContext& context_;
  Diagnostics& diagnostics_;
  MotorCarriers& carriers_;
  Robot& robot_;
};

}  // namespace

bool is_joint_in_parts(const std::string& type) {
  return type == "planar" || type == "universal" || type == "cylindrical" || type == "screw";
}

void read_joint_in_parts(TomlTable& row, const std::string& type, const Joint& whole, ReadContext& context,
                         MotorCarriers& carriers, Robot& robot) {
  PartsReader(row, type, whole, context, carriers, robot).read();
}

}  // namespace flatdyn
