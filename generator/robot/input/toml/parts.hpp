// SPDX-License-Identifier: GPL-2.0-or-later
// Parts of TOML robot files that stand in several tables.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "robot/input/common/context.hpp"
#include "robot/input/toml/table.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// A name as messages show it.
inline std::string quoted(const std::string& name) { return "\"" + name + "\""; }

// The parts of a TOML file about the whole robot, which can be applied only when the tree is known.
struct Attachments {
  struct Payload {
    std::optional<Reference> link;  // the tip's if it is not given
    Inertial inertial;
  };
  std::optional<Reference> tip;
  Pose tip_offset;
  std::optional<Payload> payload;
};

// The text of a key, one of those known; empty if the key is not there or, with an error, if it has another text.
std::string read_choice(TomlTable& table, const std::string& key, const std::vector<std::string>& known,
                        Diagnostics& diagnostics);

// Whether the text is "fixed" or "floating", how a robot's base moves, which is then taken; else it is a name.
bool read_motion_of_base(const std::string& text, Robot& robot);

// `angles` and `lengths` at the top of a file: "rad" or "deg", "m" or "mm".
Units read_units(TomlTable& table, Diagnostics& diagnostics);

// The links that carry motors, as the file names them: they are looked up when all links are known.
class MotorCarriers {
 public:
  void add(const std::string& joint, const Reference& link, const std::string& what);
  void find_in(Robot& robot, Diagnostics& diagnostics) const;

 private:
  struct Carrier {
    Reference link;
    std::string what;
  };
  std::map<std::string, Carrier> carriers_;  // by the name of the joint
};

// mass, com, inertia, inertia_about of a [[link]] or of [payload]; nothing if none of them is there.
std::optional<Inertial> read_inertial(TomlTable& table, Diagnostics& diagnostics);

Limits read_limits(TomlTable& table, JointType type);

// A drive's gain, N m/A or N/A, by the key `joint`: a number but 0. nullopt if the key is not there or, with an error,
// has no such number.
std::optional<Value> read_gain(TomlTable& table, std::string_view key, Diagnostics& diagnostics);

// coulomb of a joint or tendon; then coulomb_speed, coulomb_offset, static, stribeck_speed and load_friction. What is
// not there stays as it is.
void read_coulomb(TomlTable& table, ReadContext& context, Joint& joint);
void read_friction_law(TomlTable& table, Joint& joint);

// viscous, dry friction, armature, stiffness, spring_reference, limits, motor of a [[link]] or [[joint]]; what is not
// there stays as it is.
void read_joint_properties(TomlTable& table, ReadContext& context, Joint& joint, MotorCarriers& carriers);

}  // namespace flatdyn
