// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/reader.hpp"

#include <algorithm>
#include <tuple>

#include "base/diagnostics/utf8.hpp"
#include "robot/input/common/context.hpp"
#include "robot/input/common/foreign_files.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/common/xacro.hpp"
#include "robot/input/mjcf/reader.hpp"
#include "robot/input/scene_application.hpp"
#include "robot/input/scene_frames.hpp"
#include "robot/input/scene_reader.hpp"
#include "robot/input/sdf/reader.hpp"
#include "robot/input/toml/held_joints.hpp"
#include "robot/input/toml/reader.hpp"
#include "robot/input/urdf/reader.hpp"
#include "robot/model/assembly.hpp"
#include "robot/model/coordinate_limits.hpp"
#include "robot/model/coupling.hpp"
#include "robot/model/linear_loops.hpp"
#include "robot/model/snap_dust.hpp"
#include "robot/model/tendon.hpp"
#include "robot/model/validate.hpp"

namespace flatdyn {

namespace {

const Place kCommandLine;

// The last link in depth-first order of those that move: a sensor that is fixed to the base is nobody's tip.
int last_moving_link(const Robot& robot) {
  const std::vector<bool> moves = moving_links(robot);
  int last = robot.root;
  for (const int j : depth_first_joints(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    if (moves[static_cast<std::size_t>(joint.child)] && !joint.is_tendon) last = joint.child;
  }
  return last;
}

// The links that contacts are on, which must move: those of a fixed base have no accelerations to hold.
void attach_contacts(ReadContext& context, Robot& robot) {
  const std::vector<bool> moves = moving_links(robot);
  for (SceneContact& contact : robot.scene.contacts) {
    if (contact.link.name.empty()) continue;  // said where it was read
    contact.index = find_link(robot, contact.link, "contact, link", context.diagnostics).value_or(robot.tip);
    if (robot.floating_base || moves[static_cast<std::size_t>(contact.index)]) continue;
    context.diagnostics.error(contact.place, "contact: link \"" + contact.link.name + "\" does not move",
                              "leave it out, or let the base move: --base floating");
  }
}

void attach(const Attachments& attachments, ReadContext& context, Robot& robot) {
  const auto index_of = [&](const std::optional<Reference>& link, const char* what) {
    return link ? find_link(robot, *link, what, context.diagnostics).value_or(robot.tip) : robot.tip;
  };
  robot.tip = last_moving_link(robot);
  add_frames(context, robot);
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
  if (const std::optional<ScenePayload>& payload = robot.scene.payload) {
    const int link = index_of(payload->link, "payload, link");
    robot.links[static_cast<std::size_t>(link)].inertials.push_back(payload->inertial);
  }
  attach_contacts(context, robot);
}

std::vector<Place> payload_places(const Attachments& attachments, const Scene& scene) {
  std::vector<Place> places;
  if (attachments.payload) places.push_back(attachments.payload->inertial.place);
  if (scene.payload) places.push_back(scene.payload->inertial.place);
  return places;
}

// File by file and line by line, the order in which a person works through them.
void hand_over(const Diagnostics& found, Diagnostics& diagnostics) {
  std::vector<Diagnostic> sorted = found.all();
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.place.file, a.place.line) < std::tie(b.place.file, b.place.line);
  });
  for (Diagnostic& diagnostic : sorted) diagnostics.add(std::move(diagnostic));
}

// Whether the XML declaration says that each byte is a character of ISO 8859-1.
bool is_declared_latin1(const std::string& text) {
  if (text.compare(0, 5, "<?xml") != 0) return false;
  std::string declaration = text.substr(0, text.find("?>"));
  for (char& c : declaration) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  return declaration.find("iso-8859-1\"") != std::string::npos ||
         declaration.find("iso-8859-1'") != std::string::npos || declaration.find("latin1") != std::string::npos ||
         declaration.find("latin-1") != std::string::npos;
}

// Editors on Windows save UTF-16 under the name of "Unicode".
std::optional<std::string> as_utf8(const Source& source, Diagnostics& diagnostics) {
  if (source.kind != FileKind::toml && is_declared_latin1(source.text)) {
    std::string text = utf8_of_latin1(source.text);
    if (text != source.text) {
      diagnostics.note({source.name, 1}, "the file is ISO 8859-1, by its first line: it is read as that",
                       "save it as UTF-8 for other programs");
    }
    return text;
  }
  if (!is_utf16(source.text)) return source.text;
  std::optional<std::string> text = utf8_of_utf16(source.text);
  if (text) {
    diagnostics.note({source.name, 0}, "the file is UTF-16: it is read as that", "save it as UTF-8 for other programs");
  } else {
    diagnostics.error({source.name, 0}, "the file begins as UTF-16, but is not UTF-16 throughout",
                      "save it as UTF-8: iconv -f UTF-16 -t UTF-8 FILE > robot.urdf");
  }
  return text;
}

FormatReader reader_of(FileKind kind) {
  if (kind == FileKind::sdf) return read_sdf;
  return kind == FileKind::mjcf ? read_mjcf : read_urdf;
}

Attachments read_text(FileKind kind, const std::string& text, const std::string& name, ReadContext& context,
                      Robot& robot) {
  if (kind == FileKind::toml) return read_toml(text, name, context, robot);
  reader_of(kind)(text, name, context, robot);
  return {};
}

void check_model_option(const ReadContext& context) {
  if (!context.options.model || context.model_was_chosen || context.diagnostics.has_errors()) return;
  throw Failure(FailureKind::usage, "--model " + *context.options.model + " has no effect: no SDF file is read",
                "leave it out");
}

void check_ignored(const ReadContext& context) {
  if (context.options.ignored.empty() || context.mjcf_was_read || context.diagnostics.has_errors()) return;
  throw Failure(FailureKind::usage, "--ignore has no effect: no MJCF file is read", "leave it out");
}

void check_keyframe(const ReadContext& context) {
  if (!context.options.keyframe || context.mjcf_was_read || context.diagnostics.has_errors()) return;
  throw Failure(FailureKind::usage, "--keyframe " + *context.options.keyframe + " has no effect: no MJCF file is read",
                "leave it out");
}

void read_into(const std::string& file, ReadContext& context, Robot& robot) {
  const std::optional<Source> source = context.options.sources->read(file, context.diagnostics);
  if (!source) return;
  const std::optional<std::string> text = as_utf8(*source, context.diagnostics);
  if (!text) return;
  robot.files.push_back(file);
  if (source->kind == FileKind::unknown) {
    const ForeignFile kind = foreign_by_name(file).value_or(
        ForeignFile{"unknown kind of file", "robot files are called .urdf, .sdf, .xml, .xacro or .toml"});
    context.diagnostics.error({file, 0}, kind.what, kind.hint);
    return;
  }
  const Attachments attachments = read_text(kind_by_text(source->kind, *text), *text, source->name, context, robot);
  context.options.sources->check_arguments();
  check_model_option(context);
  check_ignored(context);
  check_keyframe(context);
  if (robot.links.empty() && context.diagnostics.has_errors()) return;
  apply_to_joints(robot.scene, context.diagnostics, robot);
  hold_joints(context, robot);
  leave_out_idle_tendons(robot);
  if (!validate_tree(robot, context.diagnostics)) return;
  robot.floating_base = context.options.floating_base.value_or(robot.floating_base);
  if (robot.scene.base_limits && !robot.floating_base) {
    context.diagnostics.error(robot.scene.base_limits->place, "base_limits: the base of this robot is fixed",
                              "leave them out, or let it move: --base floating");
  }
  attach(attachments, context, robot);
  if (robot.scene.gravity) robot.gravity = *robot.scene.gravity;
  robot.snaps = context.snaps;
  robot.rounded_angles = context.rounded_angles;
  snap_dust(dust_part(context.options), robot);
  validate_values(robot, payload_places(attachments, robot.scene), context.diagnostics);
  warn_of_units(robot, context);
}

// "arm" of arm.toml and of arm.urdf.xacro; stdin and pipes have no name.
void take_name_of_file(const std::filesystem::path& path, Diagnostics& diagnostics, Robot& robot) {
  robot.name =
      path == kStandardInput || is_pipe(path) ? "robot" : (is_xacro(path) ? path.stem() : path).stem().string();
  if (is_utf8(robot.name)) return;
  diagnostics.error({path.string(), 0}, "the name of the file, which the robot takes, is not UTF-8",
                    "rename the file, or give the robot a name in it");
}

}  // namespace

std::optional<Robot> read_robot(const std::filesystem::path& path, const ReadOptions& options,
                                Diagnostics& diagnostics) {
  Diagnostics found;
  ReadContext context{options, found, SymbolTable(options.scene_file), {}, 0, {}, {}};
  context.reader_of = reader_of;
  Robot robot;
  robot.file = path == "-" ? kStandardInput : path.string();
  robot.scene = options.scene;
  if (!options.scene_file.empty()) add_scene(read_scene(options.scene_file, context), robot.scene);
  for (const JointPosition& lock : robot.scene.locked) {
    const bool is_of_scene = !lock.place.file.empty();
    context.held_joints.push_back({lock, {is_of_scene && robot.scene.degrees, false, is_of_scene}});
  }
  read_into(robot.file, context, robot);
  if (!options.scene_file.empty()) robot.files.push_back(options.scene_file);
  robot.symbols = context.symbols.in_order();
  if (robot.name.empty()) take_name_of_file(robot.file, found, robot);
  if (!found.has_errors()) couple_linear_loops(robot, found);
  if (!found.has_errors()) check_assembly(robot, found);
  if (!found.has_errors()) check_coordinates(robot, found);
  hand_over(found, diagnostics);
  if (found.has_errors()) return std::nullopt;
  return robot;
}

}  // namespace flatdyn
