// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/bodies.hpp"

#include <fmt/format.h>

#include "robot/input/common/words.hpp"

namespace flatdyn {

namespace {

class BodyReader {
 public:
  explicit BodyReader(const SdfFrame& frame)
      : values_(*frame.values),
        element_(*frame.element),
        diagnostics_(values_.context().diagnostics),
        what_(name_of(frame)) {}

  Link read(const std::string& name) {
    Link link{name, {}, element_.place};
    link.inertials.push_back(read_inertial());
    check_motion();
    return link;
  }

 private:
  Inertial read_inertial() {
    const FileNode* element = values_.child(element_, "inertial", what_);
    if (element == nullptr) {
      note_default(element_, "<inertial>", "1 kg, and 1 kg m^2 about each axis");
      return {{1, element_.place}, {}, zero_vector(), identity_matrix(), {}, element_.place};
    }
    const std::string what = what_ + ", inertial";
    refuse_other_inertias(*element, what);
    Inertial inertial;
    inertial.place = element->place;
    const std::optional<Value> mass = values_.number(*element, "mass", what);
    if (!mass) note_default(*element, "<mass>", "1 kg");
    inertial.mass = mass.value_or(Value{1, inertial.place});
    inertial.tensor = read_tensor(*element, what);
    const SdfPose pose = values_.pose(*element, what);
    if (!pose.relative_to.name.empty()) {
      diagnostics_.error(pose.relative_to.place, what + ": its pose cannot be relative to another frame",
                         "an inertial's pose is in the frame of its link: delete relative_to");
    }
    inertial.frame = {pose.displacements, pose.relative_to.place};
    return inertial;
  }

  Mat3 read_tensor(const FileNode& inertial, const std::string& what) {
    const FileNode* element = values_.child(inertial, "inertia", what);
    if (element == nullptr) {
      note_default(inertial, "<inertia>", "1 kg m^2 about each axis");
      return identity_matrix();
    }
    const std::string where = what + ", inertia";
    const auto diagonal = [&](const char* tag) {
      const std::optional<Value> value = values_.number(*element, tag, where);
      if (!value) note_default(*element, "<" + std::string(tag) + ">", "1 kg m^2");
      return value ? value->number : Number(1);
    };
    const auto off_diagonal = [&](const char* tag) {
      const std::optional<Value> value = values_.number(*element, tag, where);
      return value ? value->number : Number(0);
    };
    const Number xx = diagonal("ixx"), yy = diagonal("iyy"), zz = diagonal("izz");
    const Number xy = off_diagonal("ixy"), xz = off_diagonal("ixz"), yz = off_diagonal("iyz");
    return {Vec3{xx, xy, xz}, Vec3{xy, yy, yz}, Vec3{xz, yz, zz}};
  }

  void note_default(const FileNode& element, const std::string& tag, const std::string& value) {
    diagnostics_.note(element.place, what_ + " has no " + tag + ": it counts as " + value,
                      "that is SDF's default; write what the link has", "links with a default mass or inertia");
  }

  void refuse_other_inertias(const FileNode& element, const std::string& what) {
    if (values_.flag_attribute(element, "auto", what)) {
      diagnostics_.unsupported(element.place, what + ": inertia from collision shapes is not supported yet",
                               "write <mass> and <inertia>, and delete auto=\"true\"");
    }
    if (const FileNode* entry = first_number_in("fluid_added_mass", element)) {
      diagnostics_.unsupported(entry->place, what + ": the mass of a fluid that moves is not supported yet",
                               "delete <fluid_added_mass>");
    }
  }

  void check_motion() {
    if (values_.flag(element_, "kinematic", false, what_)) {
      diagnostics_.unsupported(element_.place, what_ + ": it is kinematic, so no force moves it",
                               "delete <kinematic>, or fix its joint");
    }
    if (const FileNode* entry = first_number_in("velocity_decay", element_)) {
      diagnostics_.note(entry->place, what_ + ": <velocity_decay> is not read",
                        "it is a number of simulators; write <damping> of a joint",
                        "decays of velocities that are not read");
    }
  }

  // The first entry that is not 0 in children of this name, of which there may be several; nullptr if there is none.
  static const FileNode* first_number_in(const char* tag, const FileNode& parent) {
    for (const FileNode* holder : parent.elements(tag)) {
      for (const FileNode& entry : holder->children) {
        if (!is_zero_text(entry.text)) return &entry;
      }
    }
    return nullptr;
  }

  const SdfValues& values_;
  const FileNode& element_;
  Diagnostics& diagnostics_;
  std::string what_;
};

}  // namespace

Link read_sdf_link(const SdfFrame& frame) { return BodyReader(frame).read(frame.name); }

void apply_sdf_gravity_flags(const SdfTree& tree, Diagnostics& diagnostics, Robot& robot) {
  const SdfFrame *off = nullptr, *on = nullptr;
  for (const SdfFrame& frame : tree.frames) {
    if (frame.kind != SdfFrame::Kind::link) continue;
    (frame.values->flag(*frame.element, "gravity", true, name_of(frame)) ? on : off) = &frame;
  }
  if (off == nullptr) return;
  const Place place = off->element->place;
  if (on == nullptr) {
    robot.gravity = zero_vector();
    diagnostics.note(place, "gravity acts on no link: there is none", "delete <gravity>false</gravity> if there is");
    return;
  }
  diagnostics.unsupported(
      place, fmt::format("{}: gravity does not act on it, but on {}", name_of(*off), name_of(*on)),
      "delete <gravity>false</gravity>; for robots whose weight is balanced, --gravity off leaves out all of it");
}

}  // namespace flatdyn
