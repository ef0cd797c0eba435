// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/reader.hpp"

#include <algorithm>

#include "robot/input/common/robot_builder.hpp"
#include "robot/input/sdf/bodies.hpp"
#include "robot/input/sdf/choice.hpp"
#include "robot/input/sdf/files.hpp"
#include "robot/input/sdf/joints.hpp"
#include "robot/input/sdf/mimic_plugins.hpp"
#include "robot/input/sdf/placing.hpp"

namespace flatdyn {

namespace {

class SdfReader {
 public:
  SdfReader(ReadContext& context, Robot& robot)
      : context_(context),
        diagnostics_(context.diagnostics),
        robot_(robot),
        unknown_(context),
        declarer_(tree_, unknown_, robot) {}

  void read(const std::string& text, const std::string& file) {
    const SdfFile* sdf = parse_sdf(text, file, context_, tree_);
    if (sdf == nullptr) return;
    unknown_.check(sdf->root, "sdf");
    const std::optional<SdfChoice> choice = choose_sdf_model(*sdf, tree_, robot_);
    if (!choice) return;
    robot_.name = name_of(choice->model);
    declarer_.declare_world(choice->world, sdf->values, robot_.name);
    declarer_.declare_robot(choice->model);
    if (!place_sdf_frames(diagnostics_, tree_)) return;
    if (choice->world != nullptr) read_gravity(*choice->world, sdf->values);
    read_links();
    apply_sdf_gravity_flags(tree_, diagnostics_, robot_);
    read_sdf_joints(tree_, links_, context_, robot_);
    read_sdf_mimic_plugins(tree_, diagnostics_, robot_);
    if (!diagnostics_.has_errors()) stand_on_ground();
  }

 private:
  void read_links() {
    for (const SdfFrame& frame : tree_.frames) {
      links_.push_back(frame.kind == SdfFrame::Kind::link ? static_cast<int>(robot_.links.size()) : -1);
      if (frame.kind == SdfFrame::Kind::link) robot_.links.push_back(read_sdf_link(frame));
    }
  }

  // Up to 1.5, gravity was in <physics>.
  void read_gravity(const FileNode& world, const SdfValues& values) {
    const FileNode* holder = values.version() <= 5 ? world.child("physics") : nullptr;
    const FileNode* gravity = values.child(world, "gravity", "world");
    if (gravity == nullptr && holder != nullptr) gravity = values.child(*holder, "gravity", "physics");
    const Vec3 usual = {0, 0, exact_decimal("-9.8")};  // SDF's default, of worlds
    robot_.gravity = gravity == nullptr ? usual : values.vector(*gravity, "world, gravity").value_or(usual);
  }

  // A model that no joint fixes to the world is taken for one that stands on it.
  void stand_on_ground() {
    std::vector<bool> is_child(robot_.links.size(), false);
    bool has_world = false;
    for (const Joint& joint : robot_.joints) {
      is_child[static_cast<std::size_t>(joint.child)] = true;
      has_world = has_world || robot_.links[static_cast<std::size_t>(joint.parent)].name == "world";
    }
    std::vector<int> free;  // frames of links
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (links_[i] >= 0 && !is_child[static_cast<std::size_t>(links_[i])]) free.push_back(static_cast<int>(i));
    }
    if (free.empty()) return;
    if (has_world || free.size() > 1) {
      const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(free[has_world ? 0 : 1])];
      diagnostics_.unsupported(frame.element->place,
                               name_of(frame) + " is joined to nothing: bodies that move freely are not supported yet",
                               "join it by a joint (type=\"fixed\" if it does not move), or delete it");
      robot_.links.clear();
      robot_.joints.clear();
      return;
    }
    fix_base(free.front());
  }

  // Gravity is that of the world: a base that is turned in it needs the world as the root.
  void fix_base(int frame_of_link) {
    const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(frame_of_link)];
    const Place place = frame.element->place;
    if (!context_.options.floating_base.value_or(false)) {
      diagnostics_.note(place, name_of(frame) + " is joined to nothing: it is taken for a base that does not move",
                        "write a joint of type=\"fixed\" with <parent>world</parent> to say so");
    }
    const Displacements pose = relative_pose(tree_, 0, frame_of_link);
    if (rotations_in(pose).empty()) return;
    RobotBuilder(context_, robot_).fix_to_world(links_[static_cast<std::size_t>(frame_of_link)], pose, place);
  }

  ReadContext& context_;
  Diagnostics& diagnostics_;
  Robot& robot_;
  SdfTree tree_;
  SdfUnknown unknown_;
  SdfDeclarer declarer_;
  std::vector<int> links_;  // by frame
};

}  // namespace

void read_sdf(const std::string& text, const std::string& file, ReadContext& context, Robot& robot) {
  SdfReader(context, robot).read(text, file);
}

}  // namespace flatdyn
