// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Mechanism in three steps: merge links that fixed joints join; put z of a raw frame on every moving axis
// (raw_tree.hpp); use the remaining freedom so that constant transforms become modified DH (frame_placement.hpp).
#include <algorithm>
#include <map>

#include "robot/model/angles.hpp"
#include "robot/model/coordinate_limits.hpp"
#include "robot/model/floating_base.hpp"
#include "robot/model/frame_placement.hpp"
#include "robot/model/loop_closure.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The parameters of an inertial as written, in the frame of its link.
InertialParameters in_link_frame(const Inertial& inertial) {
  const Number m = rationalised(inertial.mass.number);
  const Vec3 r = rationalised(inertial.centre_of_mass);
  InertialParameters body{m, expanded(m * r), zero_matrix()};
  for (std::size_t i = 0; i < 3; ++i) body.inertia[i] = rationalised(inertial.tensor[i]);
  if (inertial.about == Inertial::About::centre_of_mass) body.inertia = body.inertia + steiner(m, r);
  const Transform frame = exact_transform(inertial.frame);
  return transformed(body, frame.R, frame.p);
}

// The parameters of a rotor held still, in the frame of the link that carries it, (7.63), (7.66).
InertialParameters still_rotor(const Motor& motor) {
  const Number m = rationalised(motor.mass.number);
  const Number across = rationalised(motor.inertia_transverse.number);
  const Number along = rationalised(motor.inertia_axial.number) - across;
  const Vec3 z = unit(motor.axis), r = rationalised(motor.position);
  InertialParameters rotor{m, expanded(m * r), steiner(m, r)};
  for (std::size_t i = 0; i < 3; ++i) {
    rotor.inertia[i][i] += across;
    for (std::size_t j = 0; j < 3; ++j) rotor.inertia[i][j] += along * z[i] * z[j];
  }
  return rotor;
}

InertialParameters without_residues(InertialParameters body, const Number& reach) {
  const Number of_moments = body.mass * reach;
  const Number of_inertia = of_moments * reach + body.inertia[0][0] + body.inertia[1][1] + body.inertia[2][2];
  body.first_moment = snap_residue_to_zero(body.first_moment, of_moments);
  for (Vec3& row : body.inertia) row = snap_residue_to_zero(row, of_inertia);
  return body;
}

// F_s and how friction depends on the rate.
void set_dry_friction(const Joint& joint, Body& body) {
  const DryFrictionLaw& law = joint.law;
  const auto number = [](const std::optional<Value>& value) { return value ? rationalised(value->number) : Number(0); };
  body.coulomb = rationalised(joint.coulomb.number);
  if (law.backward) {
    body.dry.asymmetry = ((body.coulomb - number(law.backward)) / 2).expand();
    body.coulomb = ((body.coulomb + number(law.backward)) / 2).expand();
  }
  body.dry.speed = number(law.speed);
  body.dry.offset = number(law.offset);
  if (law.offset && law.speed) body.dry.at_rest = rationalised(GiNaC::tanh(body.dry.offset / body.dry.speed));
  if (law.static_friction) body.dry.excess = (number(law.static_friction) - body.coulomb).expand();
  body.dry.stribeck_speed = number(law.stribeck_speed);
  body.dry.load = number(law.load);
}

Body make_body(const RawTree& tree, const std::vector<Placement>& placements, std::size_t i) {
  const Joint& joint = tree.robot.joints[static_cast<std::size_t>(tree.joint_of[i])];
  Body body;
  body.joint = joint.name;
  body.link = tree.robot.links[static_cast<std::size_t>(joint.child)].name;
  body.parent = tree.parent[i];
  body.prismatic = joint.type == JointType::prismatic;
  body.continuous = joint.type == JointType::continuous;
  body.is_tendon = joint.is_tendon;
  const ZxzAngles angles = zxz_angles(tree.frames[i].R);
  body.beta = angles.beta;
  if (body.parent >= 0) {
    body.beta = snap_residue_to_zero(inverse(placements[static_cast<std::size_t>(body.parent)].phase) * angles.beta);
  }
  body.alpha = angles.alpha;
  body.theta = snap_residue_to_zero(angles.theta * placements[i].phase);
  if (vanishes(body.alpha.s) && body.alpha.c.is_equal(1)) {
    body.theta = snap_residue_to_zero(body.beta * body.theta);  // for parallel axes one phase is enough
    body.beta = {};
  }
  body.p = displacement(tree, placements, i);
  body.armature = rationalised(joint.armature.number);
  body.viscous = rationalised(joint.viscous.number);
  set_dry_friction(joint, body);
  body.limits = joint.limits;
  if (joint.current_to_torque) body.current_to_torque = rationalised(joint.current_to_torque->number);
  body.stiffness = rationalised(joint.stiffness.number);
  if (!vanishes(body.stiffness)) {
    const LinearPosition& position = tree.positions[static_cast<std::size_t>(tree.joint_of[i])];
    body.spring_reference = (rationalised(joint.spring_reference.number) - rationalised(position.offset)).expand();
  }
  return body;
}

// Adds body i of the raw tree, and with the first body of a spherical joint all three.
void add_bodies(const RawTree& tree, const std::vector<Placement>& placements, std::size_t i, Mechanism& mechanism) {
  if (i < mechanism.bodies.size()) return;
  const Body body = make_body(tree, placements, i);
  if (tree.robot.joints[static_cast<std::size_t>(tree.joint_of[i])].type != JointType::spherical) {
    mechanism.bodies.push_back(body);
    return;
  }
  const auto parts = bodies_of_spherical_joint(body);
  mechanism.spherical.push_back(static_cast<int>(i));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    mechanism.bodies.push_back(parts[k]);
    mechanism.bodies.back().parent = tree.parent[i + k];
  }
}

// The pose of a written link in the final frame of its body.
Transform final_pose(const RawTree& tree, const std::vector<Placement>& placements, int link) {
  const Transform& raw = tree.link_pose[static_cast<std::size_t>(link)];
  const int body = tree.body_of[static_cast<std::size_t>(link)];
  if (body < 0) return raw;
  const Placement& placement = placements[static_cast<std::size_t>(body)];
  const Mat3 back = rotation_z(inverse(placement.phase));
  return {snap_residues_to_zero(expanded(back * raw.R)),
          snap_residue_to_zero(expanded(back * (raw.p - placement.shift)), tree.reach)};
}

bool carries(const Mechanism& mechanism, int carrier, int body) {
  if (carrier < 0) return true;
  int ancestor = mechanism.bodies[static_cast<std::size_t>(body)].parent;
  while (ancestor > carrier) ancestor = mechanism.bodies[static_cast<std::size_t>(ancestor)].parent;
  return ancestor == carrier;
}

void add_motor(const RawTree& tree, const std::vector<Placement>& placements, int body_index, Mechanism& mechanism) {
  Body& body = mechanism.bodies[static_cast<std::size_t>(body_index)];
  const Joint& joint = tree.robot.joints[static_cast<std::size_t>(tree.joint_of[static_cast<std::size_t>(body_index)])];
  if (!joint.motor) return;
  const int link = joint.motor->carrier >= 0 ? joint.motor->carrier : joint.parent;
  const Transform pose = final_pose(tree, placements, link);
  const int carrier = tree.body_of[static_cast<std::size_t>(link)];
  if (!carries(mechanism, carrier, body_index)) {
    throw Failure(FailureKind::unsupported,
                  joint.motor->place.file + ":" + std::to_string(joint.motor->place.line) + ": motor of joint \"" +
                      joint.name + "\" is carried by link \"" + tree.robot.links[static_cast<std::size_t>(link)].name +
                      "\", which is not between the base and the joint",
                  "carry it on the joint's parent link or on a link before it");
  }
  const InertialParameters still = still_rotor(*joint.motor);
  WrittenLink& written = mechanism.links[static_cast<std::size_t>(link)];
  written.inertia = written.inertia + still;
  InertialParameters& carrying =
      carrier < 0 ? mechanism.base : mechanism.bodies[static_cast<std::size_t>(carrier)].inertia;
  carrying = carrying + transformed(still, pose.R, pose.p);
  body.rotor =
      Rotor{carrier, rationalised(joint.motor->gear_ratio.number), rationalised(joint.motor->inertia_axial.number),
            snap_residue_to_zero(expanded(pose.R * unit(joint.motor->axis)), 1)};
}

void add_links(const RawTree& tree, const std::vector<Placement>& placements, Mechanism& mechanism) {
  const Robot& robot = tree.robot;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Transform pose = final_pose(tree, placements, static_cast<int>(l));
    const int body = tree.body_of[l];
    InertialParameters link;
    for (const Inertial& inertial : robot.links[l].inertials) link = link + in_link_frame(inertial);
    mechanism.links.push_back({{robot.links[l].name, body, pose.R, pose.p}, link});
    InertialParameters& target = body < 0 ? mechanism.base : mechanism.bodies[static_cast<std::size_t>(body)].inertia;
    target = target + transformed(link, pose.R, pose.p);
  }
  const Transform tip = compose(final_pose(tree, placements, robot.tip), exact_transform(robot.tip_offset));
  const auto tip_link = static_cast<std::size_t>(robot.tip);
  mechanism.tip = {robot.links[tip_link].name, tree.body_of[tip_link], tip.R, tip.p};
}

void add_contacts(const RawTree& tree, const std::vector<Placement>& placements, Mechanism& mechanism) {
  const Scene& scene = tree.robot.scene;
  for (const SceneContact& contact : scene.contacts) {
    const Transform point{identity_matrix(), rationalised(contact.position)};
    const Transform pose = compose(final_pose(tree, placements, contact.index), point);
    const auto link = static_cast<std::size_t>(contact.index);
    mechanism.contacts.push_back({contact.name,
                                  {tree.robot.links[link].name, tree.body_of[link], pose.R, pose.p},
                                  contact.is_surface,
                                  cone_of(contact),
                                  contact.is_against_gravity});
  }
  mechanism.contact_damping = scene.contact_damping;
}

void add_coupling(const RawTree& tree, Mechanism& mechanism) {
  const Robot& robot = tree.robot;
  if (!has_coupled_joints(robot)) return;
  std::map<int, int> body_of_joint;
  for (std::size_t i = 0; i < tree.joint_of.size(); ++i) body_of_joint[tree.joint_of[i]] = static_cast<int>(i);
  std::map<int, std::size_t> column;  // column by the joint that the coordinate belongs to
  for (const int joint : joints_with_coordinates(robot)) {
    column.emplace(joint, mechanism.coordinates.size());
    mechanism.coordinates.push_back(body_of_joint.at(joint));
    mechanism.bodies[static_cast<std::size_t>(body_of_joint.at(joint))].limits =
        coordinate_limits(robot, tree.positions, joint);
  }
  for (const int joint : tree.joint_of) {
    const LinearPosition& position = tree.positions[static_cast<std::size_t>(joint)];
    std::vector<Number> row(mechanism.coordinates.size(), 0);
    for (const auto& [owner, factor] : position.factors) row[column.at(owner)] = factor;
    mechanism.coupling.push_back(std::move(row));
    mechanism.offsets.push_back(position.offset);
  }
  mechanism.angles = further_angles(mechanism);
}

}  // namespace

Mechanism make_mechanism(const Robot& robot) {
  const RawTree tree(robot);
  const std::vector<Placement> placements = frame_placements(tree);
  Mechanism mechanism;
  mechanism.name = robot.name;
  mechanism.gravity = rationalised(robot.gravity);
  mechanism.task = robot.scene.task;
  mechanism.symbols = robot.symbols;
  mechanism.merged = tree.merged;
  for (std::size_t i = 0; i < tree.frames.size(); ++i) add_bodies(tree, placements, i, mechanism);
  add_links(tree, placements, mechanism);
  add_contacts(tree, placements, mechanism);
  for (int i = 0; i < mechanism.body_count(); ++i) add_motor(tree, placements, i, mechanism);
  for (Body& body : mechanism.bodies) body.inertia = without_residues(body.inertia, tree.reach);
  add_coupling(tree, mechanism);
  add_loops(robot, mechanism);
  if (!robot.floating_base) return mechanism;
  return with_base_joint(with_floating_base(std::move(mechanism), robot.scene.base_limits), robot.base_joint);
}

}  // namespace flatdyn
