// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/places_in_file.hpp"

#include <fmt/format.h>

#include <optional>

#include "diagnostics/table.hpp"

namespace flatdyn {

namespace {

std::string place_text_of(const Place& place) {
  return place.line > 0 ? fmt::format("{}:{}", place.file, place.line) : place.file;
}

// "mass a.xml:3, armature a.xml:9": numbers of one line together.
class PlacesText {
 public:
  void add(const std::string& what, const Place& place) {
    if (place.file.empty()) return;
    const bool is_same = !text_.empty() && place == last_;
    if (is_same) {
      text_.insert(text_.size() - place_text_of(last_).size() - 1, ", " + what);
    } else {
      text_ += (text_.empty() ? "" : "; ") + what + " " + place_text_of(place);
    }
    last_ = place;
  }
  void add(const std::string& what, const Value& value) {
    if (!vanishes(value.number)) add(what, value.place);
  }
  void add(const std::string& what, const std::optional<Value>& value) {
    if (value) add(what, value->place);
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  Place last_;
};

std::string places_of_part(const Link& link) {
  PlacesText places;
  for (const Inertial& inertial : link.inertials) {
    places.add("inertia", inertial.place);
    places.add("mass", inertial.mass);
  }
  return places.text();
}

std::string places_of_part(const Joint& joint) {
  PlacesText places;
  places.add("joint", joint.place);
  places.add("viscous friction", joint.viscous);
  places.add("Coulomb friction", joint.coulomb);
  places.add("armature", joint.armature);
  if (joint.motor) places.add("motor", joint.motor->place);
  places.add("stiffness", joint.stiffness);
  if (!vanishes(joint.stiffness.number)) places.add("spring reference", joint.spring_reference);
  if (joint.coupled) places.add("coupling", joint.coupled->place);
  places.add("lower limit", joint.limits.lower);
  places.add("upper limit", joint.limits.upper);
  places.add("speed limit", joint.limits.velocity);
  places.add("acceleration limit", joint.limits.acceleration);
  places.add("effort limit", joint.limits.effort);
  return places.text();
}

}  // namespace

std::string describe_places(const Robot& robot) {
  std::vector<std::vector<std::string>> rows = {{"where it is written", ""}};
  for (const Link& link : robot.links) {
    if (!link.inertials.empty()) rows.push_back({"link \"" + link.name + "\"", places_of_part(link)});
  }
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed) rows.push_back({"joint \"" + joint.name + "\"", places_of_part(joint)});
  }
  return aligned_table(rows);
}

}  // namespace flatdyn
