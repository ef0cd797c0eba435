// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/joints.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/joint_parts.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/sdf/gearboxes.hpp"
#include "robot/input/sdf/joint_axis.hpp"
#include "robot/input/sdf/placing.hpp"

namespace flatdyn {

namespace {

class JointReader {
 public:
  JointReader(const SdfTree& tree, std::vector<int> links, ReadContext& context, Robot& robot)
      : tree_(tree),
        links_(std::move(links)),
        context_(context),
        diagnostics_(context.diagnostics),
        robot_(robot),
        builder_(context, robot) {}

  void read() {
    for (std::size_t i = 1; i < tree_.frames.size(); ++i) {
      const SdfFrame& frame = tree_.frames[i];
      const bool is_static = tree_.scopes[static_cast<std::size_t>(frame.scope)].is_static;
      if (frame.kind == SdfFrame::Kind::joint && !is_static) read_joint(static_cast<int>(i));
      if (frame.kind == SdfFrame::Kind::link && is_static) fix_to_world(i);
    }
    for (const int gearbox : gearboxes_) read_sdf_gearbox(tree_, gearbox, links_, context_, robot_);
  }

 private:
  void read_joint(int index) {
    const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(index)];
    const std::string type = frame.values->required_attribute(*frame.element, "type", name_of(frame));
    if (type == "gearbox" && !is_held(frame.name, context_)) {
      gearboxes_.push_back(index);
      return;
    }
    Joint joint = RobotBuilder::new_joint(frame.name, frame.element->place);
    const int parent = frame_of_joint(tree_, frame, "parent", diagnostics_);
    const int parent_body = body_of(tree_, parent), child_body = body_of(tree_, frame.attached_to);
    joint.parent = link_of(parent_body, frame, "parent");
    joint.child = link_of(child_body, frame, "child");
    const std::size_t before = robot_.joints.size();
    if (joint.parent >= 0 && joint.child >= 0 && !type.empty()) {
      has_two_axes(frame) ? add_two(index, parent_body, child_body, joint)
                          : add_one(index, type, parent_body, child_body, joint);
    }
    // One that has errors stands for itself, so that its links do not seem to be free.
    if (robot_.joints.size() == before) robot_.joints.push_back(std::move(joint));
  }

  // -1, and an error, if a frame moves with no link.
  int link_of(int body, const SdfFrame& joint, const char* tag) {
    if (body < 0) return -1;
    if (body == 0 && std::string_view(tag) == "parent") return world();
    const int link = links_[static_cast<std::size_t>(body)];
    if (link < 0) {
      diagnostics_.error(joint.element->place, name_of(joint) + ": its " + tag + " moves with no link",
                         "name a link, or a frame that is attached to one");
    }
    return link;
  }

  void fix_to_world(std::size_t frame) {
    world();
    builder_.fix_to_world(links_[frame], relative_pose(tree_, 0, static_cast<int>(frame)),
                          tree_.frames[frame].element->place);
  }

  int world() { return builder_.world({robot_.file, 1}); }

  void add_one(int index, const std::string& type, int parent, int child, Joint& joint) {
    const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(index)];
    static const std::map<std::string, JointType> kMotions = {
        {"revolute", JointType::revolute}, {"continuous", JointType::continuous}, {"prismatic", JointType::prismatic}};
    const auto motion = kMotions.find(type);
    if (type == "screw" && !is_held(joint.name, context_)) return add_screw(index, parent, child, joint);
    if (type == "ball" && !is_held(joint.name, context_)) return add_ball(index, parent, child, joint);
    if (motion == kMotions.end()) {
      if (type != "fixed" && !is_held(joint.name, context_)) refuse_type(frame, type);
      joint.origin = {relative_pose(tree_, parent, child), joint.place};
      robot_.joints.push_back(joint);
      return;
    }
    builder_.set_type(motion->second, joint);
    const FileNode* axis = axis_of(frame, "axis");
    if (axis == nullptr) return;
    const Displacements turn = turn_of(index, *axis);
    joint.origin = {product(relative_pose(tree_, parent, index), turn), joint.place};
    joint.link_offset = {product(inverse(turn), relative_pose(tree_, index, child)), joint.place};
    read_sdf_axis(tree_, frame, *axis, context_, joint);
    if (joint.type != JointType::fixed) read_drake_words(tree_, frame, diagnostics_, joint);
    robot_.joints.push_back(joint);
  }

  void add_ball(int index, int parent, int child, Joint& joint) {
    const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(index)];
    joint.type = JointType::spherical;
    joint.origin = {relative_pose(tree_, parent, index), joint.place};
    joint.link_offset = {relative_pose(tree_, index, child), joint.place};
    if (frame.element->child("axis") != nullptr) {
      diagnostics_.warning(joint.place, name_of(frame) + " is a ball joint: its <axis> has no effect",
                           "delete it; friction and limits in it are not read", "ball joints with an <axis>");
    }
    for (const char* tag : {"drake:rotor_inertia", "drake:mimic"}) {
      if (frame.element->child(tag) == nullptr) continue;
      diagnostics_.unsupported(joint.place,
                               name_of(frame) + " is a ball joint, which has no axis for its <" + tag + ">",
                               std::string("delete <") + tag + ">");
    }
    robot_.joints.push_back(joint);
  }

  void add_screw(int index, int parent, int child, const Joint& screw) {
    const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(index)];
    const FileNode* axis = axis_of(frame, "axis");
    const std::optional<Number> travel = travel_of(frame);
    if (axis == nullptr || !travel) return;
    std::vector<Joint> parts = screw_parts(screw, *travel);
    const Displacements turn = turn_of(index, *axis);
    parts[0].origin.displacements = turn;
    parts[1].link_offset.displacements = inverse(turn);
    read_sdf_axis(tree_, frame, *axis, context_, parts[0]);
    read_drake_words(tree_, frame, diagnostics_, parts[0]);
    parts[1].axis = parts[0].axis;
    add_parts(index, parent, child, screw, parts);
  }

  void add_parts(int index, int parent, int child, Joint whole, const std::vector<Joint>& parts) {
    whole.origin.displacements = relative_pose(tree_, parent, index);
    whole.link_offset.displacements = relative_pose(tree_, index, child);
    for (Joint& part : joined_in_tree(whole, parts, robot_)) robot_.joints.push_back(std::move(part));
  }

  // m per rad: of <screw_thread_pitch>, m per turn, or the older <thread_pitch>, -rad per m.
  std::optional<Number> travel_of(const SdfFrame& frame) {
    const std::string what = name_of(frame);
    if (const auto pitch = frame.values->number(*frame.element, "screw_thread_pitch", what))
      return pitch->number / (2 * GiNaC::Pi);
    const auto thread = frame.values->number(*frame.element, "thread_pitch", what);
    if (thread && !vanishes(thread->number)) return -1 / thread->number;
    diagnostics_.error(frame.element->place,
                       what + (thread ? ", thread_pitch: 0 has no meaning" : ": a screw without a pitch"),
                       "write <screw_thread_pitch>, m per turn");
    return std::nullopt;
  }

  void add_two(int index, int parent, int child, const Joint& both) {
    const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(index)];
    const std::array<const FileNode*, 2> axes = {axis_of(frame, "axis"), axis_of(frame, "axis2")};
    if (axes[0] == nullptr || axes[1] == nullptr) return;
    if (frame.element->child("drake:rotor_inertia") != nullptr) {
      diagnostics_.unsupported(both.place, name_of(frame) + " has two axes: whose rotor is meant is not clear",
                               "delete <drake:rotor_inertia>");
    }
    std::vector<Joint> parts = {part_of_joint(both, ".axis", JointType::revolute),
                                part_of_joint(both, ".axis2", JointType::revolute)};
    hold_parts(both.name, parts, context_);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      builder_.set_type(JointType::revolute, parts[k]);
      const Displacements turn = turn_of(index, *axes[k]);
      parts[k].origin.displacements = turn;
      parts[k].link_offset.displacements = inverse(turn);
      read_sdf_axis(tree_, frame, *axes[k], context_, parts[k]);
    }
    add_parts(index, parent, child, both, parts);
  }

  // The rotation from the joint's frame to the one that its axis is written in, so that the axis keeps its decimals.
  Displacements turn_of(int joint, const FileNode& axis) {
    return rotations_in(relative_pose(tree_, joint, frame_of_axis(tree_, joint, axis, diagnostics_)));
  }

  const FileNode* axis_of(const SdfFrame& frame, const char* tag) {
    const FileNode* axis = frame.values->child(*frame.element, tag, name_of(frame));
    if (axis == nullptr) {
      diagnostics_.error(frame.element->place, name_of(frame) + " has no <" + tag + ">",
                         std::string("write <") + tag + "> <xyz>0 0 1</xyz> </" + tag + ">");
    }
    return axis;
  }

  // The one place where types are refused that the model does not have yet.
  void refuse_type(const SdfFrame& frame, const std::string& type) {
    static const std::vector<std::string> kNotYet = {"piston", "planar", "floating"};
    const Place place = frame.element->place;
    if (std::find(kNotYet.begin(), kNotYet.end(), type) != kNotYet.end()) {
      diagnostics_.unsupported(place, name_of(frame) + ": type \"" + type + "\" is not supported yet",
                               "hold it still: make it type=\"fixed\", or give the option --fix " + frame.name);
      return;
    }
    const std::string hint = hint_for_unknown(
        type, {"revolute", "continuous", "prismatic", "fixed", "universal", "revolute2", "screw", "gearbox", "ball"},
        "types");
    diagnostics_.error(place, name_of(frame) + ": unknown type \"" + type + "\"", hint);
  }

  const SdfTree& tree_;
  std::vector<int> links_;
  ReadContext& context_;
  Diagnostics& diagnostics_;
  Robot& robot_;
  RobotBuilder builder_;
  std::vector<int> gearboxes_;  // frames
};

}  // namespace

void read_sdf_joints(const SdfTree& tree, std::vector<int> links, ReadContext& context, Robot& robot) {
  JointReader(tree, std::move(links), context, robot).read();
}

}  // namespace flatdyn
