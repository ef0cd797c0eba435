// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/reader.hpp"

#include <algorithm>
#include <tuple>

#include "diagnostics/nearest.hpp"
#include "input/context.hpp"
#include "input/toml_reader.hpp"
#include "input/urdf_reader.hpp"
#include "input/utf8.hpp"
#include "model/validate.hpp"

namespace flatdyn {

namespace {

const Place kCommandLine;

// The inertia of a rotor that no longer turns, as a body fixed to the link that carries it.
Inertial as_inertial(const Motor& motor) {
  Inertial inertial;
  inertial.mass = motor.mass;
  inertial.centre_of_mass = motor.position;
  inertial.place = motor.place;
  // I_t E + (I_a - I_t) z z^T / (z^T z)
  const Number& transverse = motor.inertia_transverse.number;
  const Number along = (motor.inertia_axial.number - transverse) / dot(motor.axis, motor.axis);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      inertial.tensor[i][j] = (i == j ? transverse : Number(0)) + along * motor.axis[i] * motor.axis[j];
    }
  }
  return inertial;
}

void hold(Joint& joint, Robot& robot) {
  joint.type = JointType::fixed;
  if (!joint.motor) return;
  const int carrier = joint.motor->carrier >= 0 ? joint.motor->carrier : joint.parent;
  const bool has_axis = !vanishes(dot(joint.motor->axis, joint.motor->axis));
  if (carrier >= 0 && has_axis) {
    robot.links[static_cast<std::size_t>(carrier)].inertials.push_back(as_inertial(*joint.motor));
  }
  joint.motor.reset();
}

void hold_joints(const ReadContext& context, Robot& robot) {
  std::vector<std::string> known;
  for (const Joint& joint : robot.joints) known.push_back(joint.name);
  for (const auto& [name, place] : context.held_joints) {
    const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                    [&wanted = name](const Joint& joint) { return joint.name == wanted; });
    if (found != robot.joints.end()) {
      hold(*found, robot);
    } else if (!robot.joints.empty()) {
      context.diagnostics.error(place, "there is no joint \"" + name + "\" to be fixed",
                                hint_for_unknown(name, known, "joints"));
    }
  }
}

// The last link in depth-first order of those that move: a sensor that is fixed to the base is nobody's tip.
int last_moving_link(const Robot& robot) {
  std::vector<bool> moves(robot.links.size(), false);
  int last = robot.root;
  for (const int j : depth_first_joints(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    const auto child = static_cast<std::size_t>(joint.child);
    moves[child] = joint.type != JointType::fixed || moves[static_cast<std::size_t>(joint.parent)];
    if (moves[child]) last = joint.child;
  }
  return last;
}

void attach(const Attachments& attachments, ReadContext& context, Robot& robot) {
  const auto index_of = [&](const std::optional<Reference>& link, const char* what) {
    return link ? find_link(robot, *link, what, context.diagnostics).value_or(robot.tip) : robot.tip;
  };
  robot.tip = last_moving_link(robot);
  robot.tip = index_of(attachments.tip, "tip, link");
  robot.tip_offset = attachments.tip_offset;
  if (attachments.payload) {
    const int link = index_of(attachments.payload->link, "payload, link");
    robot.links[static_cast<std::size_t>(link)].inertials.push_back(attachments.payload->inertial);
    robot.has_payload = true;
  }
  // A payload stays where the file puts it, whatever frame the user asks for.
  if (context.options.tip) {
    robot.tip = index_of(Reference{*context.options.tip, kCommandLine}, "--tip");
    robot.tip_offset = {};
  }
}

// File by file and line by line, the order in which a person works through them.
void hand_over(const Diagnostics& found, Diagnostics& diagnostics) {
  std::vector<Diagnostic> sorted = found.all();
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.place.file, a.place.line) < std::tie(b.place.file, b.place.line);
  });
  for (Diagnostic& diagnostic : sorted) diagnostics.add(std::move(diagnostic));
}

void read_into(const std::filesystem::path& path, ReadContext& context, Robot& robot) {
  const std::string file = path.string();
  const FileKind kind = kind_of(path);
  const std::optional<std::string> text = file_text(file, context.diagnostics);
  if (!text) return;
  robot.files.push_back(file);
  if (kind == FileKind::unknown) {
    context.diagnostics.error({file, 0}, "unknown kind of file", "robot files are called .urdf, .xml or .toml");
    return;
  }
  Attachments attachments;
  if (kind == FileKind::urdf) {
    read_urdf(*text, file, context, robot);
  } else {
    attachments = read_toml(*text, file, context, robot);
  }
  if (robot.links.empty() && context.diagnostics.has_errors()) return;
  hold_joints(context, robot);
  if (!validate_tree(robot, context.diagnostics)) return;
  attach(attachments, context, robot);
  const Place payload = attachments.payload ? attachments.payload->inertial.place : Place{};
  validate_values(robot, payload, context.diagnostics);
}

void take_name_of_file(const std::filesystem::path& path, Diagnostics& diagnostics, Robot& robot) {
  robot.name = path.stem().string();
  if (is_utf8(robot.name)) return;
  diagnostics.error({path.string(), 0}, "the name of the file, which the robot takes, is not UTF-8",
                    "rename the file, or give the robot a name in it");
}

}  // namespace

std::optional<Robot> read_robot(const std::filesystem::path& path, const ReadOptions& options,
                                Diagnostics& diagnostics) {
  Diagnostics found;
  ReadContext context{options, found, {}, {}, 0, {}, {}};
  for (const std::string& joint : options.fixed_joints) context.held_joints.push_back({joint, kCommandLine});
  Robot robot;
  robot.file = path.string();
  read_into(path, context, robot);
  robot.symbols = context.symbols.in_order();
  robot.snaps = context.snaps;
  if (robot.name.empty()) take_name_of_file(path, found, robot);
  if (options.gravity) robot.gravity = *options.gravity;
  hand_over(found, diagnostics);
  if (found.has_errors()) return std::nullopt;
  return robot;
}

}  // namespace flatdyn
