// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/gearboxes.hpp"

#include <algorithm>

#include "robot/input/common/coupling.hpp"
#include "robot/input/common/poses.hpp"
#include "robot/input/sdf/joint_axis.hpp"
#include "robot/input/sdf/placing.hpp"
#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

class GearboxReader {
 public:
  GearboxReader(const SdfTree& tree, int gearbox, const std::vector<int>& links, ReadContext& context, Robot& robot)
      : tree_(tree),
        gearbox_(gearbox),
        frame_(tree.frames[static_cast<std::size_t>(gearbox)]),
        links_(links),
        context_(context),
        robot_(robot),
        what_(name_of(frame_)),
        place_(frame_.element->place) {}

  void read() {
    const auto ratio = frame_.values->number(*frame_.element, "gearbox_ratio", what_);
    const auto reference = frame_.values->name(*frame_.element, "gearbox_reference_body", what_);
    if (!reference) {
      if (frame_.element->child("gearbox_reference_body") == nullptr) report_missing("gearbox_reference_body");
      return;
    }
    const int found =
        find_sdf_frame(tree_, frame_.scope, *reference, what_ + ", gearbox_reference_body", context_.diagnostics);
    const int parent = frame_of_joint(tree_, frame_, "parent", context_.diagnostics);
    if (found < 0 || parent < 0) return;
    reference_ = body_of(tree_, found);
    const std::optional<Turning> first = turning("axis", body_of(tree_, parent));
    const std::optional<Turning> second = turning("axis2", body_of(tree_, frame_.attached_to));
    if (!first || !second || second->joint->type == JointType::fixed) return;
    const Number factor = -(ratio ? ratio->number : Number(1)) * first->sign * second->sign;
    couple_joint(*second->joint, Coupled{{{{first->joint->name, place_}, factor}}, 0, place_}, what_,
                 context_.diagnostics);
  }

 private:
  // A joint between the reference body and another one, and whether it turns along the gearbox's axis (1) or against
  // it (-1).
  struct Turning {
    Joint* joint = nullptr;
    int sign = 1;
  };

  void report_missing(const char* tag) {
    context_.diagnostics.error(place_, what_ + " has no <" + tag + ">",
                               "write <axis>, <axis2>, <gearbox_ratio> and <gearbox_reference_body>");
  }

  std::optional<Turning> turning(const char* tag, int body) {
    const FileNode* axis = frame_.values->child(*frame_.element, tag, what_);
    if (axis == nullptr) {
      report_missing(tag);
      return std::nullopt;
    }
    Joint* joint = joint_to(body);
    if (joint == nullptr) {
      refuse(std::string("its ") + (std::string_view(tag) == "axis" ? "parent" : "child") +
             " does not turn on its reference body by a joint of one axis");
      return std::nullopt;
    }
    const Vec3 wanted = direction_of(*axis), found = exact_place(joint->origin).R * joint->axis;
    const Vec3 across = cross(wanted, found);
    constexpr double kParallel = 1e-18;  // of the square of the sine
    const double lengths = nearest_double((dot(wanted, wanted) * dot(found, found)).expand());
    if (nearest_double(dot(across, across).expand()) > kParallel * lengths || lengths == 0) {
      refuse(std::string("its <") + tag + "> is not parallel to the axis of joint \"" + joint->name + "\"");
      return std::nullopt;
    }
    return Turning{joint, is_negative(dot(wanted, found)) ? -1 : 1};
  }

  // nullptr if the body is not moved on the reference body by a joint that turns.
  Joint* joint_to(int body) {
    const int link = link_of(body), reference = link_of(reference_);
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(), [&](const Joint& each) {
      const JointType motion = each.held ? each.held->type : each.type;
      const bool turns = motion == JointType::revolute || motion == JointType::continuous;
      return turns && each.child == link && each.parent == reference;
    });
    return link < 0 || found == robot_.joints.end() ? nullptr : &*found;
  }

  // -1 if a frame moves with no link.
  int link_of(int body) const {
    if (body > 0) return links_[static_cast<std::size_t>(body)];
    const auto world =
        std::find_if(robot_.links.begin(), robot_.links.end(), [](const Link& link) { return link.name == "world"; });
    return body < 0 || world == robot_.links.end() ? -1 : static_cast<int>(world - robot_.links.begin());
  }

  // The axis in the reference body's frame, with all joints at 0.
  Vec3 direction_of(const FileNode& axis) {
    Joint joint;
    joint.name = frame_.name;
    joint.type = JointType::revolute;
    read_sdf_axis(tree_, frame_, axis, context_, joint);
    const bool has_forces = !vanishes(joint.viscous.number) || !vanishes(joint.coulomb.number) ||
                            !vanishes(joint.stiffness.number) || joint.coupled;
    if (has_forces) refuse("it has friction, a spring or a mimic");
    const int frame = frame_of_axis(tree_, gearbox_, axis, context_.diagnostics);
    return exact_place({relative_pose(tree_, reference_, frame), place_}).R * joint.axis;
  }

  void refuse(const std::string& why) {
    context_.diagnostics.unsupported(place_, what_ + ": " + why + ", which is not supported",
                                     "write <mimic> in the axis of the joint that follows");
  }

  const SdfTree& tree_;
  int gearbox_;
  const SdfFrame& frame_;
  const std::vector<int>& links_;
  ReadContext& context_;
  Robot& robot_;
  std::string what_;
  Place place_;
  int reference_ = -1;  // frame of the reference body
};

}  // namespace

void read_sdf_gearbox(const SdfTree& tree, int gearbox, const std::vector<int>& links, ReadContext& context,
                      Robot& robot) {
  GearboxReader(tree, gearbox, links, context, robot).read();
}

}  // namespace flatdyn
