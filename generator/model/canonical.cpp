// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Mechanism in three steps: merge links that fixed joints join; put z of a raw frame on every moving axis; use
// the remaining freedom (phase about z, place of the origin on the axis) so that constant transforms become modified
// DH.
#include <algorithm>
#include <map>
#include <optional>

#include "model/angles.hpp"
#include "model/coordinate_limits.hpp"
#include "model/floating_base.hpp"
#include "model/loop_closure.hpp"
#include "model/mechanism.hpp"
#include "model/rational_rotation.hpp"
#include "model/spherical_joint.hpp"

namespace flatdyn {
namespace {

struct Transform {
  Mat3 R = identity_matrix();
  Vec3 p = zero_vector();
};

Transform compose(const Transform& a, const Transform& b) { return {expanded(a.R * b.R), expanded(a.p + a.R * b.p)}; }

Transform exact_transform(const Displacement& displacement) {
  return {exact_rotation(displacement), rationalised(displacement.translation)};
}

Transform exact_transform(const Pose& pose) {
  Transform result;
  for (const Displacement& displacement : pose.displacements) result = compose(result, exact_transform(displacement));
  return result;
}

// The constant transform of a joint that is held still.
Transform held_motion(const Joint& joint) {
  if (!joint.held || vanishes(joint.held->position)) return {};
  if (joint.held->type == JointType::prismatic) {
    return {identity_matrix(), expanded(rationalised(joint.held->position) * unit(joint.axis))};
  }
  const Mat3 onto_axis = rotation_onto(joint.axis);
  return {expanded(onto_axis * rotation_z(planar_rotation(joint.held->position)) * transpose(onto_axis)),
          zero_vector()};
}

// The constant transform along or about z of a coupled joint when all coordinates are zero.
Transform offset_motion(const Joint& joint, const Number& offset) {
  if (!joint.coupled || vanishes(offset)) return {};
  if (joint.type == JointType::prismatic) return {identity_matrix(), {0, 0, rationalised(offset)}};
  return {rotation_z(planar_rotation(offset)), zero_vector()};
}

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

void add_lengths(const Vec3& p, Number& sum) {
  for (const Number& each : p) {
    const Number length = rationalised(each);
    if (is_rational(length)) sum += GiNaC::abs(length);
  }
}

void add_lengths(const Pose& pose, Number& sum) {
  for (const Displacement& displacement : pose.displacements) add_lengths(displacement.translation, sum);
}

// The sum of the robot's numeric lengths: where some of them cancel, rounding residues are small beside it.
Number reach_of(const Robot& robot) {
  Number reach = 0;
  for (const Joint& joint : robot.joints) {
    add_lengths(joint.origin, reach);
    add_lengths(joint.link_offset, reach);
    if (joint.motor) add_lengths(joint.motor->position, reach);
    if (joint.held && joint.held->type == JointType::prismatic) add_lengths({joint.held->position, 0, 0}, reach);
  }
  for (const Link& link : robot.links) {
    for (const Inertial& inertial : link.inertials) {
      add_lengths(inertial.frame, reach);
      add_lengths(inertial.centre_of_mass, reach);
    }
  }
  add_lengths(robot.tip_offset, reach);
  return reach;
}

Mat3 rotation_by(const ZxzAngles& angles) {
  return expanded(rotation_z(angles.beta) * rotation_x(angles.alpha) * rotation_z(angles.theta));
}

// A rotation in which entries that are 0 or 1 up to a rounding residue are exactly 0 or 1.
Mat3 snap_residues_to_zero(const Mat3& R) {
  for (const Vec3& row : R) {
    const Vec3 cleared = snap_residue_to_zero(row, 1);
    if (row[0].is_equal(cleared[0]) && row[1].is_equal(cleared[1]) && row[2].is_equal(cleared[2])) continue;
    return rotation_by(zxz_angles(R));
  }
  return R;
}

InertialParameters snap_residues_to_zero(InertialParameters body, const Number& reach) {
  const Number of_moments = body.mass * reach;
  const Number of_inertia = of_moments * reach + body.inertia[0][0] + body.inertia[1][1] + body.inertia[2][2];
  body.first_moment = snap_residue_to_zero(body.first_moment, of_moments);
  for (Vec3& row : body.inertia) row = snap_residue_to_zero(row, of_inertia);
  return body;
}

// The rotation by the ZXZ angles of R, which are made rational again. So the frames that it places, and the distances
// to axes, are exactly zero where they have to be.
Mat3 from_zxz(const Mat3& R) { return rotation_by(zxz_angles(R)); }

bool is_along_z(const Mat3& R) {
  const Vec3 axis = snap_residue_to_zero(Vec3{R[0][2], R[1][2], R[2][2]}, 1);
  return vanishes(axis[0]) && vanishes(axis[1]);
}

bool is_across_z(const Mat3& R) { return vanishes(snap_residue_to_zero(R[2][2], 1)); }

bool is_symbolic(const Mat3& R) {
  return std::any_of(R.begin(), R.end(), [](const Vec3& row) {
    return std::any_of(row.begin(), row.end(), [](const Number& entry) { return has_symbols(entry); });
  });
}

bool has_rational_angles(const Mat3& R) {
  const Mat3 again = from_zxz(R);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!again[i][j].is_equal(R[i][j])) return false;
    }
  }
  return true;
}

// The tree with raw frames: z is on each axis, origin and phase are wherever the file put them.
class RawTree {
 public:
  explicit RawTree(const Robot& robot)
      : robot_(robot),
        reach_(reach_of(robot)),
        position_(joint_positions(robot)),
        link_pose_(robot.links.size()),
        body_of_(robot.links.size(), -1) {
    walk(robot.root);
  }

  const Robot& robot_;
  Number reach_;
  std::vector<LinearPosition> position_;  // by written joint
  std::vector<Transform> link_pose_;      // by written link: its pose in its body's raw frame
  std::vector<int> body_of_;              // by written link: its body; -1: the base
  std::vector<Transform> raw_;            // by body: its raw frame in its parent's raw frame
  std::vector<int> joint_of_;             // by body: the joint as written that moves it
  std::vector<int> parent_;
  std::vector<std::string> merged_;

 private:
  void walk(int link) {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      if (robot_.joints[j].parent == link) attach(static_cast<int>(j));
    }
  }

  void attach(int joint_index) {
    const Joint& joint = robot_.joints[static_cast<std::size_t>(joint_index)];
    const auto parent = static_cast<std::size_t>(joint.parent), child = static_cast<std::size_t>(joint.child);
    const Transform frame = compose(link_pose_[parent], exact_transform(joint.origin));
    const Transform offset = exact_transform(joint.link_offset);
    if (joint.type == JointType::fixed) {
      body_of_[child] = body_of_[parent];
      link_pose_[child] = compose(compose(frame, held_motion(joint)), offset);
      merged_.push_back(robot_.links[child].name);
    } else if (joint.type == JointType::spherical) {
      attach_spherical(joint_index, frame, offset);
    } else {
      const Transform onto_axis{rotation_onto(joint.axis), zero_vector()};
      const Transform raw = compose(compose(frame, onto_axis),
                                    offset_motion(joint, position_[static_cast<std::size_t>(joint_index)].offset));
      raw_.push_back(
          {from_zxz(without_rest_past_slides(raw.R, body_of_[parent])), snap_residue_to_zero(raw.p, reach_)});
      parent_.push_back(body_of_[parent]);
      joint_of_.push_back(joint_index);
      body_of_[child] = static_cast<int>(raw_.size()) - 1;
      link_pose_[child] = compose({transpose(onto_axis.R), zero_vector()}, offset);
    }
    walk(joint.child);
  }

  // Three frames at one point: that of the joint, and two with their axes in another order, of which the last has the
  // joint's axes again.
  void attach_spherical(int joint_index, const Transform& frame, const Transform& offset) {
    const Joint& joint = robot_.joints[static_cast<std::size_t>(joint_index)];
    const auto parent = static_cast<std::size_t>(joint.parent), child = static_cast<std::size_t>(joint.child);
    const Transform cycled{with_columns_cycled(identity_matrix()), zero_vector()};
    for (int k = 0; k < kSphericalBodies; ++k) {
      raw_.push_back(k == 0 ? Transform{from_zxz(frame.R), snap_residue_to_zero(frame.p, reach_)} : cycled);
      parent_.push_back(k == 0 ? body_of_[parent] : static_cast<int>(raw_.size()) - 2);
      joint_of_.push_back(joint_index);
    }
    body_of_[child] = static_cast<int>(raw_.size()) - 1;
    link_pose_[child] = offset;
  }

  bool is_slide(int body) const {
    return robot_.joints[static_cast<std::size_t>(joint_of_[static_cast<std::size_t>(body)])].type ==
           JointType::prismatic;
  }

  // The rotation R of a body in the frame of `parent`, without rounding residues. A prismatic joint does not turn its
  // descendants, so an axis beyond it is parallel or perpendicular to one before it if the robot's axes are; but since
  // the angles between them have been made rational one by one, a residue may be left.
  Mat3 without_rest_past_slides(const Mat3& R, int parent) const {
    for (const auto fits : {is_along_z, is_across_z}) {
      if (const std::optional<Mat3> found = placed_past_slides(R, parent, fits)) return *found;
    }
    return R;
  }

  // R corrected by the nearest axis before prismatic joints to which the body's axis `fits`; nothing if there is none,
  // or if the corrected angles are not rational. They are rational if all axes between lie in one plane, or if one
  // prismatic joint is between two parallel axes.
  std::optional<Mat3> placed_past_slides(const Mat3& R, int parent, bool (*fits)(const Mat3&)) const {
    Mat3 way = identity_matrix();  // rotation from the parent to `body`
    for (int body = parent; body >= 0 && is_slide(body); body = parent_[static_cast<std::size_t>(body)]) {
      way = expanded(raw_[static_cast<std::size_t>(body)].R * way);
      const Mat3 turned = expanded(way * R);
      if (is_symbolic(turned) || !fits(turned)) continue;
      const Mat3 placed = expanded(transpose(way) * from_zxz(turned));
      if (has_rational_angles(placed)) return placed;
    }
    return std::nullopt;
  }
};

// The pose of a body's final frame in its raw frame: turned by `phase` about z, then shifted by `shift`.
struct Placement {
  PlanarRotation phase;
  Vec3 shift = zero_vector();
};

// Chooses the placements from the base outwards, so that the placement of a body's parent is known.
class Placer {
 public:
  explicit Placer(const RawTree& tree) : tree_(tree), placements_(tree.raw_.size()) {
    for (std::size_t i = 0; i < placements_.size(); ++i) place(i);
  }

  const Placement& operator[](std::size_t i) const { return placements_[i]; }

  // The displacement of body i's final origin (at q = 0) in its parent's final frame.
  Vec3 displacement(std::size_t i) const {
    const Vec3 raw = raw_displacement(i) + tree_.raw_[i].R * placements_[i].shift;
    const int parent = tree_.parent_[i];
    if (parent < 0) return snap_residue_to_zero(expanded(raw), tree_.reach_);
    const Mat3 back = rotation_z(inverse(placements_[static_cast<std::size_t>(parent)].phase));
    return snap_residue_to_zero(expanded(back * raw), tree_.reach_);
  }

 private:
  // The displacement from the parent's final origin to body i's raw origin, along the parent's raw axes.
  Vec3 raw_displacement(std::size_t i) const {
    const int parent = tree_.parent_[i];
    const Vec3 origin = parent < 0 ? zero_vector() : placements_[static_cast<std::size_t>(parent)].shift;
    return tree_.raw_[i].p - origin;
  }

  // The child that the frame of body i is fitted to: the first of those with the most descendants.
  std::optional<std::size_t> main_child(std::size_t i) const {
    std::vector<int> weight(tree_.raw_.size(), 1);
    std::optional<std::size_t> best;
    for (std::size_t k = tree_.raw_.size(); k-- > i + 1;) {
      const int parent = tree_.parent_[k];
      if (parent < 0) continue;
      weight[static_cast<std::size_t>(parent)] += weight[k];
      if (parent == static_cast<int>(i) && (!best || weight[k] >= weight[*best])) best = k;
    }
    return best;
  }

  JointType type_of_joint(std::size_t i) const {
    return tree_.robot_.joints[static_cast<std::size_t>(tree_.joint_of_[i])].type;
  }
  bool is_prismatic(std::size_t i) const { return type_of_joint(i) == JointType::prismatic; }
  bool is_spherical(std::size_t i) const { return type_of_joint(i) == JointType::spherical; }

  void place(std::size_t i) {
    if (is_spherical(i)) return;  // its point and its axes are given
    const std::optional<std::size_t> child = main_child(i);
    Placement& placement = placements_[i];
    if (child) {
      const ZxzAngles angles = zxz_angles(tree_.raw_[*child].R);
      const bool is_plain_turn = is_spherical(*child) && vanishes(angles.alpha.s) && angles.alpha.c.is_equal(1);
      placement.phase = is_plain_turn ? angles.theta : angles.beta;
    } else if (const PlanarRotation theta = zxz_angles(tree_.raw_[i].R).theta; !is_quarter_turn(theta)) {
      placement.phase = inverse(theta);
    }
    if (is_prismatic(i)) {
      // Only the direction of a prismatic axis matters: the frame's origin is put at the parent's.
      placement.shift = expanded(Number(-1) * (transpose(tree_.raw_[i].R) * raw_displacement(i)));
    } else {
      placement.shift = {0, 0, child ? foot_of_common_normal(i, *child) : nearest_to_parent(i)};
    }
    placement.shift = snap_residue_to_zero(placement.shift, tree_.reach_);
  }

  // The point on the axis of body i, measured from its raw origin, where the common normal to the child's axis meets
  // it.
  Number foot_of_common_normal(std::size_t i, std::size_t child) const {
    const Mat3& R = tree_.raw_[child].R;
    const Vec3 u = {R[0][2], R[1][2], R[2][2]};
    const Number across = (u[0] * u[0] + u[1] * u[1]).expand();
    const Vec3& p = tree_.raw_[child].p;
    if (is_spherical(child)) return p[2];
    if (vanishes(across) || is_prismatic(child)) return nearest_to_parent(i);
    const Number foot = (p[2] - u[2] * (p[0] * u[0] + p[1] * u[1]) / across).expand();
    return is_far(foot, p) ? nearest_to_parent(i) : foot;
  }

  // The point on the axis of body i, measured from its raw origin, to which the transform from the parent's frame needs
  // the fewest numbers.
  Number nearest_to_parent(std::size_t i) const {
    const Mat3& R = tree_.raw_[i].R;
    const Vec3 u = {R[0][2], R[1][2], R[2][2]};
    const Vec3 d = raw_displacement(i);
    const Number nearest = (-dot(d, u)).expand();
    const Number across = (u[0] * u[0] + u[1] * u[1]).expand();
    if (vanishes(across)) return nearest;
    const Number foot = (-(d[0] * u[0] + d[1] * u[1]) / across).expand();
    return is_far(foot, d) ? nearest : foot;
  }

  // Whether the foot of the common normal is too far away, as with nearly parallel axes: moments about an origin there
  // lose digits.
  static bool is_far(const Number& foot, const Vec3& between) {
    constexpr int kFar = 30;
    const Number excess = foot * foot - kFar * kFar * dot(between, between);
    return !has_symbols(excess) && nearest_double(excess) > 0;
  }

  const RawTree& tree_;
  std::vector<Placement> placements_;
};

Body make_body(const RawTree& tree, const Placer& placer, std::size_t i) {
  const Joint& joint = tree.robot_.joints[static_cast<std::size_t>(tree.joint_of_[i])];
  Body body;
  body.joint = joint.name;
  body.link = tree.robot_.links[static_cast<std::size_t>(joint.child)].name;
  body.parent = tree.parent_[i];
  body.prismatic = joint.type == JointType::prismatic;
  body.continuous = joint.type == JointType::continuous;
  const ZxzAngles angles = zxz_angles(tree.raw_[i].R);
  body.beta = angles.beta;
  if (body.parent >= 0) {
    body.beta = snap_residue_to_zero(inverse(placer[static_cast<std::size_t>(body.parent)].phase) * angles.beta);
  }
  body.alpha = angles.alpha;
  body.theta = snap_residue_to_zero(angles.theta * placer[i].phase);
  if (vanishes(body.alpha.s) && body.alpha.c.is_equal(1)) {
    body.theta = snap_residue_to_zero(body.beta * body.theta);  // for parallel axes one phase is enough
    body.beta = {};
  }
  body.p = placer.displacement(i);
  body.armature = rationalised(joint.armature.number);
  body.viscous = rationalised(joint.viscous.number);
  body.coulomb = rationalised(joint.coulomb.number);
  body.limits = joint.limits;
  body.stiffness = rationalised(joint.stiffness.number);
  if (!vanishes(body.stiffness)) {
    const LinearPosition& position = tree.position_[static_cast<std::size_t>(tree.joint_of_[i])];
    body.spring_reference = (rationalised(joint.spring_reference.number) - rationalised(position.offset)).expand();
  }
  return body;
}

// Adds body i of the raw tree, and with the first body of a spherical joint all three.
void add_bodies(const RawTree& tree, const Placer& placer, std::size_t i, Mechanism& mechanism) {
  if (i < mechanism.bodies.size()) return;
  const Body body = make_body(tree, placer, i);
  if (tree.robot_.joints[static_cast<std::size_t>(tree.joint_of_[i])].type != JointType::spherical) {
    mechanism.bodies.push_back(body);
    return;
  }
  const auto parts = bodies_of_spherical_joint(body);
  mechanism.spherical.push_back(static_cast<int>(i));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    mechanism.bodies.push_back(parts[k]);
    mechanism.bodies.back().parent = tree.parent_[i + k];
  }
}

// The pose of a written link in the final frame of its body.
Transform final_pose(const RawTree& tree, const Placer& placer, int link) {
  const Transform& raw = tree.link_pose_[static_cast<std::size_t>(link)];
  const int body = tree.body_of_[static_cast<std::size_t>(link)];
  if (body < 0) return raw;
  const Placement& placement = placer[static_cast<std::size_t>(body)];
  const Mat3 back = rotation_z(inverse(placement.phase));
  return {snap_residues_to_zero(expanded(back * raw.R)),
          snap_residue_to_zero(expanded(back * (raw.p - placement.shift)), tree.reach_)};
}

bool carries(const Mechanism& mechanism, int carrier, int body) {
  if (carrier < 0) return true;
  int ancestor = mechanism.bodies[static_cast<std::size_t>(body)].parent;
  while (ancestor > carrier) ancestor = mechanism.bodies[static_cast<std::size_t>(ancestor)].parent;
  return ancestor == carrier;
}

void add_motor(const RawTree& tree, const Placer& placer, int body_index, Mechanism& mechanism) {
  Body& body = mechanism.bodies[static_cast<std::size_t>(body_index)];
  const Joint& joint =
      tree.robot_.joints[static_cast<std::size_t>(tree.joint_of_[static_cast<std::size_t>(body_index)])];
  if (!joint.motor) return;
  const int link = joint.motor->carrier >= 0 ? joint.motor->carrier : joint.parent;
  const Transform pose = final_pose(tree, placer, link);
  const int carrier = tree.body_of_[static_cast<std::size_t>(link)];
  if (!carries(mechanism, carrier, body_index)) {
    throw Failure(ExitCode::unsupported,
                  joint.motor->place.file + ":" + std::to_string(joint.motor->place.line) + ": motor of joint \"" +
                      joint.name + "\" is carried by link \"" + tree.robot_.links[static_cast<std::size_t>(link)].name +
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

void add_links(const RawTree& tree, const Placer& placer, Mechanism& mechanism) {
  const Robot& robot = tree.robot_;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Transform pose = final_pose(tree, placer, static_cast<int>(l));
    const int body = tree.body_of_[l];
    InertialParameters link;
    for (const Inertial& inertial : robot.links[l].inertials) link = link + in_link_frame(inertial);
    mechanism.links.push_back({{robot.links[l].name, body, pose.R, pose.p}, link});
    InertialParameters& target = body < 0 ? mechanism.base : mechanism.bodies[static_cast<std::size_t>(body)].inertia;
    target = target + transformed(link, pose.R, pose.p);
  }
  const Transform tip = compose(final_pose(tree, placer, robot.tip), exact_transform(robot.tip_offset));
  const auto tip_link = static_cast<std::size_t>(robot.tip);
  mechanism.tip = {robot.links[tip_link].name, tree.body_of_[tip_link], tip.R, tip.p};
}

void add_contacts(const RawTree& tree, const Placer& placer, Mechanism& mechanism) {
  const Scene& scene = tree.robot_.scene;
  for (const SceneContact& contact : scene.contacts) {
    const Transform point{identity_matrix(), rationalised(contact.position)};
    const Transform pose = compose(final_pose(tree, placer, contact.index), point);
    const auto link = static_cast<std::size_t>(contact.index);
    mechanism.contacts.push_back(
        {contact.name, {tree.robot_.links[link].name, tree.body_of_[link], pose.R, pose.p}, contact.is_surface});
  }
  mechanism.contact_damping = scene.contact_damping;
}

void add_coupling(const RawTree& tree, Mechanism& mechanism) {
  const Robot& robot = tree.robot_;
  if (!has_coupled_joints(robot)) return;
  std::map<int, int> body_of_joint;
  for (std::size_t i = 0; i < tree.joint_of_.size(); ++i) body_of_joint[tree.joint_of_[i]] = static_cast<int>(i);
  std::map<int, std::size_t> column;  // column by the joint that the coordinate belongs to
  for (const int joint : joints_with_coordinates(robot)) {
    column.emplace(joint, mechanism.coordinates.size());
    mechanism.coordinates.push_back(body_of_joint.at(joint));
    mechanism.bodies[static_cast<std::size_t>(body_of_joint.at(joint))].limits =
        coordinate_limits(robot, tree.position_, joint);
  }
  for (const int joint : tree.joint_of_) {
    const LinearPosition& position = tree.position_[static_cast<std::size_t>(joint)];
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
  const Placer placer(tree);
  Mechanism mechanism;
  mechanism.name = robot.name;
  mechanism.gravity = rationalised(robot.gravity);
  mechanism.task = robot.scene.task;
  mechanism.symbols = robot.symbols;
  mechanism.merged = tree.merged_;
  for (std::size_t i = 0; i < tree.raw_.size(); ++i) add_bodies(tree, placer, i, mechanism);
  add_links(tree, placer, mechanism);
  add_contacts(tree, placer, mechanism);
  for (int i = 0; i < mechanism.body_count(); ++i) add_motor(tree, placer, i, mechanism);
  for (Body& body : mechanism.bodies) body.inertia = snap_residues_to_zero(body.inertia, tree.reach_);
  add_coupling(tree, mechanism);
  add_loops(robot, mechanism);
  if (!robot.floating_base) return mechanism;
  return with_floating_base(std::move(mechanism), robot.scene.base_limits);
}

}  // namespace flatdyn
