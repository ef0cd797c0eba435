// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/toml/overlay.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/foreign_files.hpp"
#include "robot/input/toml/reader.hpp"

namespace flatdyn {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 2> kOverKeys = {"urdf", "robot"};

class OverlayReader {
 public:
  OverlayReader(std::string file, ReadContext& context, Robot& robot, MotorCarriers& carriers)
      : file_(std::move(file)),
        context_(context),
        diagnostics_(context.diagnostics),
        robot_(robot),
        carriers_(carriers) {}

  Attachments read(TomlTable& table) {
    const std::string key = table.has("urdf") ? "urdf" : "robot";
    for (const char* other : kOverKeys) {
      if (other == key || !table.has(other)) continue;
      diagnostics_.error(table.place_of(other), key + " and " + other + " exclude each other", "name one robot file");
      table.text(other);
    }
    Attachments attachments = read_base(table, key);
    read_motion(table);
    for (TomlTable& row : named_rows(table, "link")) read_link_row(row);
    for (TomlTable& row : named_rows(table, "joint")) read_joint_row(row);
    return attachments;
  }

 private:
  // How the base of the other file's robot moves.
  void read_motion(TomlTable& table) {
    const std::optional<std::string> motion = table.text("base");
    if (!motion || read_motion_of_base(*motion, robot_)) return;
    diagnostics_.error(table.place_of("base"), "base: " + quoted(*motion) + " is no way in which a base moves",
                       "write \"floating\" or \"fixed\"; the other file names the base link");
  }

  // ---- the other robot file

  Attachments read_base(TomlTable& table, const std::string& key) {
    const std::optional<std::string> name = table.text(key);
    if (!name) return {};
    const fs::path path = fs::path(file_).parent_path() / *name;
    const Place place = table.place_of(key);
    if (!can_be_read(path, key, place)) return {};
    const FileKind kind = kind_of(path);
    const std::optional<ForeignFile> foreign = foreign_by_name(path);
    if (foreign && kind == FileKind::unknown) {
      diagnostics_.error(place, key + ": " + quoted(*name) + ": " + foreign->what, foreign->hint);
      return {};
    }
    if (kind == FileKind::unknown || (kind == FileKind::toml && key == "urdf")) {
      diagnostics_.error(place, key + ": " + quoted(*name) + " is no " + (key == "urdf" ? "URDF" : "robot file"),
                         kind == FileKind::toml ? "write robot = " + quoted(*name)
                                                : "robot files are called .urdf, .sdf, .xml, .xacro or .toml");
      return {};
    }
    const std::optional<Source> source = context_.options.sources->read(path.string(), diagnostics_);
    if (!source) return {};
    robot_.files.push_back(path.string());
    if (kind == FileKind::toml) return read_toml(source->text, source->name, context_, robot_);
    context_.reader_of(kind_by_text(kind, source->text))(source->text, source->name, context_, robot_);
    return {};
  }

  bool can_be_read(const fs::path& path, const std::string& key, const Place& place) {
    std::error_code error;
    const std::string shown = quoted(path.string());
    if (!fs::exists(path, error)) {
      diagnostics_.error(place, key + ": there is no file " + shown, "the path is relative to this TOML file");
      return false;
    }
    if (fs::is_directory(path, error)) {
      diagnostics_.error(place, key + ": " + shown + " is a folder", "name a robot file (.urdf or .toml)");
      return false;
    }
    const bool was_read = std::any_of(robot_.files.begin(), robot_.files.end(),
                                      [&](const std::string& read) { return fs::equivalent(read, path, error); });
    if (!was_read) return true;
    diagnostics_.error(place, key + ": " + shown + " names itself, or a file that names it",
                       "name a robot file that stands by itself");
    return false;
  }

  // ---- what is written over it

  // The rows of [[key]] that have a name, each one of its own.
  std::vector<TomlTable> named_rows(TomlTable& table, const std::string& key) {
    std::vector<TomlTable> rows;
    std::map<std::string, Place> place_of_name;
    for (TomlTable& row : table.tables(key)) {
      const std::optional<std::string> name = row.text("name");
      if (!name) {
        if (row.has("name")) continue;  // it is no text: said
        diagnostics_.error(row.place(), key + ": it has no name",
                           "write name = \"...\", a " + key + " of the robot file");
        continue;
      }
      row.rename(key + " " + quoted(*name));
      const auto [first, inserted] = place_of_name.emplace(*name, row.place());
      if (inserted) {
        rows.push_back(row);
        continue;
      }
      diagnostics_.error(row.place(),
                         "two [[" + key + "]] are for " + row.what() + " (the first is in line " +
                             std::to_string(first->second.line) + ")",
                         "write all that there is to say of it into one");
    }
    return rows;
  }

  // A link's mass, centre of mass and inertia are one body: they are replaced together.
  void read_link_row(TomlTable& row) {
    const std::optional<Reference> name = row.reference("name");
    const std::optional<Inertial> inertial = read_inertial(row, diagnostics_);
    row.reject_unknown_keys();
    if (!name || robot_.links.empty()) return;  // the robot file could not be read: said there
    const std::optional<int> index = find_link(robot_, *name, "link", diagnostics_);
    if (!index || !inertial) return;
    Link& link = robot_.links[static_cast<std::size_t>(*index)];
    note_what_becomes_zero(row, *inertial, link);
    link.inertials = {*inertial};
  }

  void note_what_becomes_zero(const TomlTable& row, const Inertial& inertial, const Link& link) {
    if (link.inertials.empty() || vanishes(inertial.mass.number)) return;
    std::string missing;
    for (const char* key : {"com", "inertia"}) {
      if (!row.has(key)) missing += (missing.empty() ? "" : ", ") + std::string(key);
    }
    if (missing.empty()) return;
    diagnostics_.note(row.place(), row.what() + ": not given and so zero, whatever the robot file says: " + missing,
                      "a [[link]] replaces the link's mass, com and inertia together",
                      "links whose com or inertia is not given and so zero");
  }

  void read_joint_row(TomlTable& row) {
    const std::optional<Reference> name = row.reference("name");
    if (!name || robot_.links.empty()) return;  // the robot file could not be read: said there
    std::vector<std::string> known;
    for (Joint& joint : robot_.joints) {
      known.push_back(joint.name);
      if (joint.name != name->name) continue;
      read_joint_properties(row, context_, joint, carriers_);
      row.reject_unknown_keys();
      return;
    }
    diagnostics_.error(name->place, "there is no joint " + quoted(name->name) + " in the robot file",
                       hint_for_unknown(name->name, known, "joints"));
  }

  std::string file_;
  ReadContext& context_;
  Diagnostics& diagnostics_;
  Robot& robot_;
  MotorCarriers& carriers_;
};

}  // namespace

bool is_overlay(const TomlTable& table) {
  return std::any_of(kOverKeys.begin(), kOverKeys.end(), [&](const char* key) { return table.has(key); });
}

Attachments read_overlay(TomlTable& table, const std::string& file, ReadContext& context, Robot& robot,
                         MotorCarriers& carriers) {
  return OverlayReader(file, context, robot, carriers).read(table);
}

}  // namespace flatdyn
