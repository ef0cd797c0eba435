// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/places_in_file.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/diagnostics/table.hpp"
#include "robot/input/common/element_at.hpp"

namespace flatdyn {

namespace {

// One number or part of a link or joint.
struct NumberInFile {
  std::string what;  // "mass"
  Place place;
  std::optional<ElementOfFile> element;
};

struct PartInFile {
  std::string name;  // of the link or joint
  std::vector<NumberInFile> numbers;
};

// Attributes by which a number is written, in all formats: they distinguish elements in the same line.
using Names = std::vector<std::string>;

class NumbersOfPart {
 public:
  NumbersOfPart(const std::string& name, ElementsOfFiles& elements) : elements_(elements), part_{name, {}} {}

  void add(const std::string& what, const Place& place, const Names& attributes) {
    if (!place.file.empty()) part_.numbers.push_back({what, place, elements_.at(place, attributes, part_.name)});
  }
  void add(const std::string& what, const Value& value, const Names& attributes) {
    if (!vanishes(value.number)) add(what, value.place, attributes);
  }
  void add(const std::string& what, const std::optional<Value>& value, const Names& attributes) {
    if (value) add(what, value->place, attributes);
  }

  const PartInFile& part() const { return part_; }

 private:
  ElementsOfFiles& elements_;
  PartInFile part_;
};

PartInFile part_in_file(const Link& link, ElementsOfFiles& elements) {
  NumbersOfPart numbers(link.name, elements);
  for (const Inertial& inertial : link.inertials) {
    numbers.add("inertia", inertial.place, {"diaginertia", "fullinertia", "ixx"});
    numbers.add("mass", inertial.mass, {"mass", "density", "value"});
  }
  return numbers.part();
}

template <class Part>  // a joint, or the base's
void add_friction_and_armature(const Part& joint, NumbersOfPart& numbers) {
  numbers.add("viscous friction", joint.viscous, {"damping"});
  numbers.add("Coulomb friction", joint.coulomb, {"frictionloss", "friction"});
  numbers.add("armature", joint.armature, {"armature", "value"});
}

PartInFile part_in_file(const Joint& joint, ElementsOfFiles& elements) {
  NumbersOfPart numbers(joint.name, elements);
  numbers.add("joint", joint.place, {});
  add_friction_and_armature(joint, numbers);
  numbers.add("speed of Coulomb friction", joint.law.speed, {"coulomb_speed"});
  numbers.add("offset of Coulomb friction", joint.law.offset, {"coulomb_offset"});
  numbers.add("static friction", joint.law.static_friction, {"static"});
  numbers.add("Stribeck speed", joint.law.stribeck_speed, {"stribeck_speed"});
  numbers.add("friction of loads", joint.law.load, {"load_friction"});
  if (joint.motor) numbers.add("motor", joint.motor->place, {});
  numbers.add("stiffness", joint.stiffness, {"stiffness", "spring_stiffness"});
  if (!vanishes(joint.stiffness.number)) {
    numbers.add("spring reference", joint.spring_reference, {"springref", "spring_reference"});
  }
  if (joint.coupled) numbers.add("coupling", joint.coupled->place, {"polycoef", "multiplier"});
  numbers.add("lower limit", joint.limits.lower, {"range", "lower"});
  numbers.add("upper limit", joint.limits.upper, {"range", "upper"});
  numbers.add("speed limit", joint.limits.velocity, {"velocity"});
  numbers.add("acceleration limit", joint.limits.acceleration, {"acceleration"});
  numbers.add("effort limit", joint.limits.effort, {"actuatorfrcrange", "forcerange", "ctrlrange", "effort"});
  return numbers.part();
}

std::vector<PartInFile> parts_of_links(const Robot& robot, ElementsOfFiles& elements) {
  std::vector<PartInFile> parts;
  for (const Link& link : robot.links) {
    if (!link.inertials.empty()) parts.push_back(part_in_file(link, elements));
  }
  return parts;
}

std::vector<PartInFile> parts_of_joints(const Robot& robot, ElementsOfFiles& elements) {
  std::vector<PartInFile> parts;
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed) parts.push_back(part_in_file(joint, elements));
  }
  NumbersOfPart base("the base", elements);
  add_friction_and_armature(robot.base_joint, base);
  if (robot.floating_base && !base.part().numbers.empty()) parts.push_back(base.part());
  return parts;
}

std::string places_text(const NumberInFile& number) {
  const Place& place = number.place;
  const std::string line = place.line > 0 ? fmt::format("{}:{}", place.file, place.line) : place.file;
  return number.element ? line + " " + name_in_messages(*number.element) : line;
}

// "mass a.xml:3 <geom>; damping, armature a.xml:9 <joint>": numbers of one element together.
std::string places_text(const PartInFile& part) {
  std::string text, last;
  for (const NumberInFile& number : part.numbers) {
    const std::string where = places_text(number);
    if (where == last) {
      text.insert(text.size() - last.size() - 1, ", " + number.what);
    } else {
      text += (text.empty() ? "" : "; ") + number.what + " " + where;
    }
    last = where;
  }
  return text;
}

nlohmann::ordered_json json_of_parts(const std::vector<PartInFile>& parts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const PartInFile& part : parts) {
    nlohmann::ordered_json places = nlohmann::ordered_json::array();
    for (const NumberInFile& number : part.numbers) {
      nlohmann::ordered_json place = {{"what", number.what}, {"file", number.place.file}, {"line", number.place.line}};
      if (number.element) {
        place["element"] = number.element->name;
        if (number.element->class_of_defaults) place["class"] = *number.element->class_of_defaults;
      }
      places.push_back(place);
    }
    json.push_back({{"name", part.name}, {"places", places}});
  }
  return json;
}

}  // namespace

std::string describe_places(const Robot& robot) {
  ElementsOfFiles elements;
  std::vector<std::vector<std::string>> rows = {{"where it is written", ""}};
  for (const PartInFile& link : parts_of_links(robot, elements))
    rows.push_back({"link \"" + link.name + "\"", places_text(link)});
  for (const PartInFile& joint : parts_of_joints(robot, elements))
    rows.push_back({"joint \"" + joint.name + "\"", places_text(joint)});
  return aligned_table(rows);
}

nlohmann::ordered_json places_json(const Robot& robot) {
  ElementsOfFiles elements;
  const nlohmann::ordered_json links = json_of_parts(parts_of_links(robot, elements)),
                               joints = json_of_parts(parts_of_joints(robot, elements));
  return {{"links", links}, {"joints", joints}};
}

}  // namespace flatdyn
