// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/settings.hpp"

#include <algorithm>
#include <map>

#include "robot/input/common/words.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

// All elements of this name as one: of an attribute that several give, the last one counts.
FileNode merged(const FileNode& root, const std::string& name) {
  FileNode whole{name, {}, {}, root.place};
  for (const FileNode* element : root.elements(name)) {
    whole.place = element->place;
    for (const FileAttribute& attribute : element->attributes) {
      std::erase_if(whole.attributes, [&](const FileAttribute& each) { return each.name == attribute.name; });
      whole.attributes.push_back(attribute);
    }
    whole.children.insert(whole.children.end(), element->children.begin(), element->children.end());
  }
  return whole;
}

std::optional<Value> positive(std::optional<Value> value) {
  return value && is_positive(value->number) ? value : std::nullopt;
}

InertiaFromGeom inertia_from_geom(const MjcfItem& compiler, const MjcfValues& values) {
  const std::string word = values.keyword(compiler, "inertiafromgeom", {"true", "false", "auto"}, "auto");
  if (word == "auto") return InertiaFromGeom::where_missing;
  return word == "true" ? InertiaFromGeom::always : InertiaFromGeom::never;
}

void read_eulerseq(const MjcfItem& compiler, const MjcfValues& values, MjcfSettings& settings) {
  const std::string sequence = values.text(compiler, "eulerseq", settings.euler_sequence);
  if (sequence.size() == 3 && sequence.find_first_not_of("xyzXYZ") == std::string::npos) {
    settings.euler_sequence = sequence;
  } else {
    values.diagnostics().error(values.find(compiler, "eulerseq")->place,
                               "compiler, eulerseq: \"" + sequence + "\" is not three of x, y, z, X, Y, Z",
                               "small letters are axes that turn along, capital ones those of the parent");
  }
}

void read_groups(const MjcfItem& compiler, const MjcfValues& values, MjcfSettings& settings) {
  const auto groups = values.numbers(compiler, "inertiagrouprange", 2, 2);
  if (!groups) return;
  for (std::size_t i = 0; i < 2; ++i) settings.inertia_groups[i] = nearest_double(groups->numbers[i]);
}

void read_compiler(const FileNode& root, const MjcfValues& values, MjcfSettings& settings) {
  const FileNode merged_compiler = merged(root, "compiler");
  const MjcfItem compiler = MjcfValues::plain(merged_compiler);
  if (values.keyword(compiler, "coordinate", {"local", "global"}, "local") == "global") {
    values.diagnostics().unsupported(values.find(compiler, "coordinate")->place,
                                     "compiler: coordinate=\"global\" is not supported",
                                     "load and save the file in MuJoCo 2.3.3 or older, which writes local coordinates");
  }
  settings.angles.degrees = values.keyword(compiler, "angle", {"degree", "radian"}, "degree") == "degree";
  settings.automatic_limits = values.flag(compiler, "autolimits", true);
  settings.balances_inertia = values.flag(compiler, "balanceinertia", false);
  settings.has_exact_mesh_inertia = values.flag(compiler, "exactmeshinertia", false);
  settings.inertia_from_geom = inertia_from_geom(compiler, values);
  settings.least_mass = positive(values.number(compiler, "boundmass"));
  settings.least_inertia = positive(values.number(compiler, "boundinertia"));
  settings.total_mass = positive(values.number(compiler, "settotalmass"));
  settings.aligns_free_bodies = values.flag(compiler, "alignfree", false);
  settings.strips_path = values.flag(compiler, "strippath", false);
  settings.mesh_folder = values.text(compiler, "meshdir", values.text(compiler, "assetdir"));
  read_eulerseq(compiler, values, settings);
  read_groups(compiler, values, settings);
}

// Air and water, which brake bodies by their shapes.
void refuse_medium(const MjcfItem& option, const MjcfValues& values) {
  for (const char* name : {"density", "viscosity"}) {
    const FileAttribute* found = values.find(option, name);
    if (found == nullptr || is_zero_text(found->text)) continue;
    refuse_mjcf(found->place, std::string("option, ") + name + ": forces of a medium are not supported", name, values);
  }
}

void read_option(const FileNode& root, const MjcfValues& values, Robot& robot) {
  const FileNode merged_option = merged(root, "option");
  const MjcfItem option = MjcfValues::plain(merged_option);
  robot.gravity = values.vector(option, "gravity", robot.gravity);
  refuse_medium(option, values);
  for (const FileNode* flag : merged_option.elements("flag")) {
    if (values.keyword(MjcfValues::plain(*flag), "gravity", {"enable", "disable"}, "enable") == "disable")
      robot.gravity = zero_vector();
  }
}

// The parts of a robot that flags of MuJoCo turn off.
struct SwitchedParts {
  bool equalities = false, friction = false, springs = false, dampers = false;
};

SwitchedParts parts_of(const FileNode& root, const MjcfValues& values, const Robot& robot) {
  SwitchedParts parts;
  for (const FileNode* section : root.elements("equality")) {
    for (const FileNode& equality : section->children) {
      parts.equalities |= values.flag(values.item(equality, kMainClass, "equality"), "active", true);
    }
  }
  parts.friction = !vanishes(robot.base_joint.coulomb.number);
  parts.dampers = !vanishes(robot.base_joint.viscous.number);
  for (const Joint& joint : robot.joints) {
    parts.friction |= !vanishes(joint.coulomb.number);
    parts.springs |= !vanishes(joint.stiffness.number);
    parts.dampers |= !vanishes(joint.viscous.number);
  }
  return parts;
}

bool is_same(const std::optional<Value>& a, const std::optional<Value>& b) {
  return a.has_value() == b.has_value() && (!a || vanishes(a->number - b->number));
}

}  // namespace

std::string mjcf_difference(const MjcfSettings& a, const MjcfSettings& b) {
  if (a.angles.degrees != b.angles.degrees) return "angle";
  if (a.euler_sequence != b.euler_sequence) return "eulerseq";
  if (a.automatic_limits != b.automatic_limits) return "autolimits";
  if (a.inertia_from_geom != b.inertia_from_geom) return "inertiafromgeom";
  if (a.inertia_groups != b.inertia_groups) return "inertiagrouprange";
  if (!is_same(a.least_mass, b.least_mass)) return "boundmass";
  if (!is_same(a.least_inertia, b.least_inertia)) return "boundinertia";
  if (!is_same(a.total_mass, b.total_mass)) return "settotalmass";
  return a.balances_inertia != b.balances_inertia ? "balanceinertia" : "";
}

void refuse_mjcf_flags(const FileNode& root, const MjcfValues& values, const Robot& robot) {
  const SwitchedParts parts = parts_of(root, values, robot);
  struct Flag {
    const char* name;
    bool turns_off;
    const char* others;  // --ignore leaves them out, too
  };
  const Flag flags[] = {{"constraint", parts.equalities || parts.friction, " --ignore equality --ignore frictionloss"},
                        {"equality", parts.equalities, ""},
                        {"frictionloss", parts.friction, ""},
                        {"spring", parts.springs, " --ignore stiffness"},
                        {"damper", parts.dampers, " --ignore damping"},
                        {"passive", parts.springs || parts.dampers, " --ignore stiffness --ignore damping"}};
  const FileNode option = merged(root, "option");
  for (const FileNode* element : option.elements("flag")) {
    for (const Flag& flag : flags) {
      const FileAttribute* found = element->attribute(flag.name);
      if (found == nullptr || found->text == "enable" || !flag.turns_off) continue;
      values.diagnostics().unsupported(
          found->place,
          std::string("option, flag: ") + flag.name + "=\"" + found->text +
              "\", which turns off what would be read, is not supported",
          std::string("--ignore ") + flag.name + flag.others + " leaves out the flag and what it turns off");
    }
  }
}

MjcfSettings mjcf_settings(const FileNode& root, const MjcfValues& values, Robot& robot) {
  MjcfSettings settings;
  read_compiler(root, values, settings);
  read_option(root, values, robot);
  return settings;
}

}  // namespace flatdyn
