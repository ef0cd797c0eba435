// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/drawing.hpp"

#include <algorithm>

#include "derivation/dynamics/derivation_context.hpp"
#include "derivation/dynamics/kinematics.hpp"
#include "graph/passes/passes.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The frame shifted to a point given in it.
LinkFrame moved_by(LinkFrame frame, const Vec3& point) {
  frame.p = frame.p + frame.R * point;
  return frame;
}

class DrawingMaker {
 public:
  DrawingMaker(const Robot& robot, const Mechanism& mechanism)
      : robot_(robot), mechanism_(mechanism), frames_(mechanism.links.begin(), mechanism.links.end()) {
    for (const Joint& joint : robot.joints) {  // the links of tendons are nowhere
      if (joint.is_tendon)
        frames_[static_cast<std::size_t>(joint.child)] = frames_[static_cast<std::size_t>(joint.parent)];
    }
  }

  Drawing make() {
    Drawing drawing;
    for (const Joint& joint : robot_.joints) {
      if (!joint.is_tendon) drawing.lines.emplace_back(joint.parent, joint.child);
    }
    for (const Body& body : mechanism_.joints()) drawing.joints.push_back(point_on_axis(body));
    for (const int i : followers()) {
      const Body& body = mechanism_.bodies[static_cast<std::size_t>(i)];
      drawing.followers.push_back({point_on_axis(body), body.prismatic});
    }
    for (std::size_t link = 0; link < robot_.links.size(); ++link) add_stub(static_cast<int>(link), drawing);
    drawing.points = static_cast<int>(frames_.size());
    drawing.function = run_passes(function());
    return drawing;
  }

 private:
  const Joint* joint_that_moves(int link) const {
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [link](const Joint& joint) { return joint.child == link; });
    return found == robot_.joints.end() ? nullptr : &*found;
  }

  // The bodies whose joints have no coordinate of their own.
  std::vector<int> followers() const {
    std::vector<int> bodies;
    for (int i = 0; i < mechanism_.body_count(); ++i) {
      bool has_coordinate = false;
      for (int k = 0; k < mechanism_.size(); ++k) has_coordinate = has_coordinate || mechanism_.body_of(k) == i;
      if (!has_coordinate && !mechanism_.bodies[static_cast<std::size_t>(i)].is_tendon) bodies.push_back(i);
    }
    return bodies;
  }

  // The index of a point on the joint's axis. In standard DH a link's frame is at its end, so the joint is at the frame
  // of the previous link.
  int point_on_axis(const Body& body) const {
    const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&body](const Joint& each) { return each.name == joint_name(body); });
    return joint->link_offset.displacements.empty() ? joint->child : joint->parent;
  }

  // Adds a line for a link without further joints: to the tip, or else to its centre of mass.
  void add_stub(int link, Drawing& drawing) {
    if (link == robot_.tip && !robot_.tip_offset.displacements.empty()) {
      drawing.lines.emplace_back(link, static_cast<int>(frames_.size()));
      frames_.push_back(mechanism_.tip);
      return;
    }
    const bool is_last = std::none_of(robot_.joints.begin(), robot_.joints.end(),
                                      [link](const Joint& joint) { return joint.parent == link; });
    const Joint* const joint = joint_that_moves(link);
    const Link& last = robot_.links[static_cast<std::size_t>(link)];
    if (!is_last || joint == nullptr || !joint->link_offset.displacements.empty() || last.inertials.empty()) return;
    drawing.lines.emplace_back(link, static_cast<int>(frames_.size()));
    frames_.push_back(moved_by(frames_[static_cast<std::size_t>(link)], last.inertials.front().centre_of_mass));
  }

  Function function() const {
    DerivationContext context(mechanism_);
    std::vector<NodeId> points, axes, gravity;
    const auto add = [&context](std::vector<NodeId>& list, const Number& entry) {
      list.push_back(context.node(entry));
    };
    for (const LinkFrame& frame : frames_) {
      for (const Number& entry : pose(context.frames, frame).p) add(points, entry);
    }
    const auto add_axis = [&](int body) {
      LinkFrame frame;
      frame.body = body;
      for (const Vec3& row : pose(context.frames, frame).R) add(axes, row[2]);
    };
    for (int k = mechanism_.base_bodies(); k < mechanism_.size(); ++k) add_axis(mechanism_.body_of(k));
    for (const int i : followers()) add_axis(i);
    for (const Number& entry : mechanism_.gravity) add(gravity, entry);
    Function drawing = finished(
        context,
        {vector_output("points", points, "where links are, base frame, m"),
         vector_output("axes", axes, "unit vectors along the joints' axes, base frame"),
         vector_output("g_0", gravity,
                       mechanism_.floating_base ? "gravity, world axes, m/s^2" : "gravity, base frame, m/s^2")});
    drawing.name = "drawing";
    drawing.summary = "The points and axes from which the robot is drawn";
    drawing.inputs = {InputKind::q};
    return drawing;
  }

  const Robot& robot_;
  const Mechanism& mechanism_;
  std::vector<LinkFrame> frames_;  // their points are the frames' origins
};

}  // namespace

Drawing drawing_of(const Robot& robot, const Mechanism& mechanism) { return DrawingMaker(robot, mechanism).make(); }

}  // namespace flatdyn
