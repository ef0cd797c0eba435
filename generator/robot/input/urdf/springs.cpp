// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/springs.hpp"

#include <algorithm>

#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/urdf/children.hpp"

namespace flatdyn {

namespace {

class SpringReader {
 public:
  SpringReader(const UrdfValues& values, Robot& robot) : values_(values), robot_(robot) {}

  void read_joint(const FileNode& element) {
    Joint* joint = moving_joint(element.value("name"));
    if (joint == nullptr) return;
    const std::string what = "joint \"" + joint->name + "\"";
    for (const char* key : {"spring_stiffness", "stiffness"}) {
      if (const auto stiffness = values_.dynamics(element, key, what)) {
        set(joint->stiffness, *stiffness, what + ", dynamics, " + key);
      }
    }
    if (const auto reference = values_.dynamics(element, "spring_reference", what)) {
      set(joint->spring_reference, *reference, what + ", dynamics, spring_reference");
    }
  }

  void read_gazebo(const FileNode& gazebo) {
    Joint* joint = moving_joint(gazebo.value("reference"));
    if (joint == nullptr) return;
    for (const FileNode& part : gazebo.children) {
      const SpringWord word = spring_word_of(part.name);
      if (word == SpringWord::none) continue;
      const std::string what = "gazebo \"" + joint->name + "\", " + part.name;
      set(word == SpringWord::stiffness ? joint->stiffness : joint->spring_reference,
          value_in({part.text, {part.place, what}}, values_.context().diagnostics), what);
    }
  }

 private:
  Joint* moving_joint(const std::string& name) {
    Joint* joint = joint_in(robot_, name);
    return joint == nullptr || joint->type == JointType::fixed ? nullptr : joint;
  }

  // A number that is given twice has to be the same. A place without a file: it has not been given.
  void set(Value& value, const Value& given, const std::string& what) {
    if (!value.place.file.empty() && !vanishes(value.number - given.number)) {
      values_.context().diagnostics.error(
          given.place, what + " is not what line " + std::to_string(value.place.line) + " says of the same spring",
          "keep one of them");
      return;
    }
    value = given;
  }

  const UrdfValues& values_;
  Robot& robot_;
};

}  // namespace

SpringWord spring_word_of(std::string_view name) {
  const std::string joined = joined_name(name);
  if (joined == "springstiffness" || joined == "stiffness") return SpringWord::stiffness;
  return joined == "springreference" ? SpringWord::reference : SpringWord::none;
}

void read_urdf_springs(const FileNode& root, const UrdfValues& values, Robot& robot) {
  SpringReader reader(values, robot);
  for (const FileNode* joint : root.elements("joint")) reader.read_joint(*joint);
  for (const FileNode* gazebo : root.elements("gazebo")) reader.read_gazebo(*gazebo);
}

}  // namespace flatdyn
