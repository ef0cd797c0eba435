// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/convert/plain_robot.hpp"

#include <algorithm>
#include <cmath>

#include "robot/model/pose_product.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

namespace {

using DisplacementKind = Displacement::Kind;

constexpr int kDigitsOfAngle = 60;

// The angle of a direction (x, y), a whole number of quarter turns exactly.
Number angle_of(const Number& y, const Number& x) {
  if (vanishes(x) && vanishes(y)) return 0;
  const Number angle = GiNaC::atan2(y, x);
  if (has_symbols(angle)) return angle;  // no robot file can say it
  const Number quarters = Number(2 * angle / GiNaC::Pi).expand();
  if (quarters.info(GiNaC::info_flags::integer)) return angle;
  const Number decimal = exact_decimal(to_decimal(angle, kDigitsOfAngle));
  // Rotations of the model are rational: an angle that was a multiple of pi/12 is so no longer.
  const Number twelfth = exact_decimal(to_decimal(GiNaC::Pi / 12, kDigitsOfAngle));
  const GiNaC::numeric multiple =
      GiNaC::ex_to<GiNaC::numeric>(exact_decimal(to_decimal(decimal / twelfth, kDigitsOfAngle)));
  const int nearest = static_cast<int>(std::lround(multiple.to_double()));
  const bool is_multiple = magnitude(decimal - nearest * twelfth) < magnitude(exact_decimal("1e-30"));
  return is_multiple ? Number(nearest * GiNaC::Pi / 12) : decimal;
}

// The angles of Rz Ry Rx, if the rotations are these, in this order, each at most once.
std::optional<Vec3> angles_as_written(const Displacements& rotations) {
  Vec3 rpy = zero_vector();
  int next = 2;
  for (const Displacement& each : rotations) {
    const int about = each.kind == DisplacementKind::rotation_x ? 0 : each.kind == DisplacementKind::rotation_y ? 1 : 2;
    if (about > next) return std::nullopt;
    rpy[static_cast<std::size_t>(about)] = each.angle;
    next = about - 1;
  }
  return rpy;
}

Vec3 angles_of(const Displacements& displacements) {
  const Displacements rotations = rotations_in(displacements);
  if (const auto written = angles_as_written(rotations)) return *written;
  const Mat3 R = exact_rotation(Pose{rotations, {}});
  const Number cosine_squared = Number(R[0][0] * R[0][0] + R[1][0] * R[1][0]).expand();
  if (vanishes(cosine_squared)) return {0, angle_of(-R[2][0], 0), angle_of(-R[0][1], R[1][1])};
  return {angle_of(R[2][1], R[2][2]), angle_of(-R[2][0], GiNaC::sqrt(cosine_squared)), angle_of(R[1][0], R[0][0])};
}

PlainPose plain_pose(const Displacements& displacements) {
  PlainPose pose;
  Mat3 R = identity_matrix();
  for (const Displacement& each : displacements) {
    if (each.kind == DisplacementKind::translation) {
      pose.xyz = expanded(pose.xyz + R * each.translation);
    } else {
      R = expanded(R * exact_rotation(each));
    }
  }
  pose.rpy = angles_of(displacements);
  return pose;
}

bool is_turned(const PlainPose& pose) {
  return std::any_of(pose.rpy.begin(), pose.rpy.end(), [](const Number& angle) { return !vanishes(angle); });
}

bool has_quarter_turns_only(const Displacements& displacements) {
  const Displacements rotations = rotations_in(displacements);
  return std::all_of(rotations.begin(), rotations.end(), [](const Displacement& each) {
    return Number(2 * each.angle / GiNaC::Pi).expand().info(GiNaC::info_flags::integer);
  });
}

// About the centre of mass.
PlainBody plain_body(const Inertial& inertial) {
  Displacements frame = inertial.frame.displacements;
  const Vec3& c = inertial.centre_of_mass;
  PlainBody body;
  body.mass = inertial.mass.number;
  body.tensor = inertial.tensor;
  if (inertial.about == Inertial::About::frame_origin) {
    body.tensor = expanded(inertial.tensor - steiner(inertial.mass.number, c));
  }
  frame = product(frame, {{DisplacementKind::translation, c, 0}});
  body.pose = plain_pose(frame);
  return body;
}

// The same body with axes along those of the link, exact for quarter turns.
PlainBody unturned(PlainBody body, const Inertial& inertial) {
  const Mat3 R = exact_rotation(inertial.frame);
  body.tensor = expanded(R * body.tensor * transpose(R));
  body.pose.rpy = zero_vector();
  return body;
}

class Maker {
 public:
  Maker(const Robot& robot, const PlainForm& form) : robot_(robot), form_(form) {
    for (const Link& link : robot.links) plain_.links.push_back({link.name, {}});
  }

  CleanRobot make() {
    for (std::size_t i = 0; i < robot_.links.size(); ++i) add_bodies(static_cast<int>(i));
    for (const Joint& joint : robot_.joints) add_joint(joint);
    return std::move(plain_);
  }

 private:
  void add_bodies(int link) {
    const Link& written = robot_.links[static_cast<std::size_t>(link)];
    for (const Inertial& inertial : written.inertials) {
      PlainBody body = plain_body(inertial);
      const bool turns = is_turned(body.pose) && !form_.bodies_turn;
      if (turns && has_quarter_turns_only(inertial.frame.displacements)) body = unturned(body, inertial);
      std::optional<PlainBody>& own = plain_.links[static_cast<std::size_t>(link)].body;
      if (!own && (form_.bodies_turn || !is_turned(body.pose))) {
        own = body;
      } else {
        add_link_of_body(link, body);
      }
    }
  }

  // A body that does not fit into a link is fixed to it.
  void add_link_of_body(int link, PlainBody body) {
    const std::string name = free_name(plain_.links[static_cast<std::size_t>(link)].name + ".body");
    PlainJoint joint{name, nullptr, link, static_cast<int>(plain_.links.size()), body.pose};
    body.pose = {};
    plain_.links.push_back({name, body});
    plain_.joints.push_back(std::move(joint));
  }

  void add_joint(const Joint& joint) {
    const Displacements &origin = joint.origin.displacements, &offset = joint.link_offset.displacements;
    PlainJoint plain{joint.name, &joint, joint.parent, joint.child, {}};
    plain.axis = joint.axis;
    const JointType motion = joint.held ? joint.held->type : joint.type;
    const bool slides = motion == JointType::prismatic || motion == JointType::fixed;
    const bool is_turn = motion != JointType::spherical && rotations_in(offset).size() == product(offset, {}).size();
    if (slides || is_turn) {
      // The joint's motion commutes with what follows it, if its axis is turned.
      plain.origin = plain_pose(product(origin, offset));
      if (!rotations_in(offset).empty()) {
        plain.axis = expanded(transpose(exact_rotation(joint.link_offset)) * joint.axis);
      }
      plain_.joints.push_back(std::move(plain));
      return;
    }
    plain.origin = plain_pose(origin);
    plain.child = static_cast<int>(plain_.links.size());
    plain_.links.push_back({free_name(robot_.links[static_cast<std::size_t>(joint.child)].name + ".joint"), {}});
    const int between = plain.child;
    plain_.joints.push_back(std::move(plain));
    plain_.joints.push_back({free_name(joint.name + ".frame"), nullptr, between, joint.child, plain_pose(offset)});
  }

  std::string free_name(const std::string& wanted) const {
    std::string name = wanted;
    const auto is_taken = [&name, this] {
      const auto has_name = [&name](const auto& each) { return each.name == name; };
      return std::any_of(plain_.links.begin(), plain_.links.end(), has_name) ||
             std::any_of(plain_.joints.begin(), plain_.joints.end(), has_name) ||
             std::any_of(robot_.joints.begin(), robot_.joints.end(), has_name);
    };
    for (int number = 2; is_taken(); ++number) name = wanted + std::to_string(number);
    return name;
  }

  const Robot& robot_;
  PlainForm form_;
  CleanRobot plain_;
};

}  // namespace

PlainPose plain_pose_of(const Pose& pose) { return plain_pose(pose.displacements); }

CleanRobot plain_robot(const Robot& robot, const PlainForm& form) { return Maker(robot, form).make(); }

}  // namespace flatdyn
