// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/as_read_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graph/field_arithmetic.hpp"
#include "truth/definition/as_read.hpp"
#include "truth/definition/as_read_bodies.hpp"

namespace flatdyn {
namespace {

using Real = Digits100;
using RealPose = Pose3<Real>;

Real length_sum(const Vector3<Real>& v) { return abs(v[0]) + abs(v[1]) + abs(v[2]); }

// The motion about or along z at a position.
RealPose motion_along_z(bool slides, const JointPoint<Real>& q) {
  RealPose pose = identity_pose<Real>();
  if (slides) {
    pose.p[2] = q.d;
  } else {
    pose.R = rotation_about(2, q);
  }
  return pose;
}

RealPose motion_along(const Vector3<Real>& axis, bool slides, const JointPoint<Real>& q) {
  RealPose pose = identity_pose<Real>();
  if (slides) {
    pose.p = scaled(q.d, axis);
  } else {
    pose.R = rotation_about(axis, q);
  }
  return pose;
}

class NumberComparison {
 public:
  NumberComparison(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed)
      : robot_(robot),
        mechanism_(mechanism),
        arithmetic_(drawn_reals(seed)),
        numbers_(robot, arithmetic_),
        found_(mechanism_over(mechanism, arithmetic_)),
        moving_(moving_joints(robot)) {
    std::size_t count = base_bodies();
    for (const int j : moving_) {
      count += flatdyn::bodies_of(robot.joints[static_cast<std::size_t>(j)]);
      last_bodies_.push_back(count - 1);
    }
    body_count_ = count;
  }

  Differences run() {
    if (!has_same_parts()) return std::move(differences_);
    find_reach();
    compare_motion_of_base();
    compare_base();
    compare_couplings();
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) compare_place(j);
    for (std::size_t i = 0; i < moving_.size(); ++i) compare_joint(i);
    compare_bodies({robot_, mechanism_, numbers_, arithmetic_, found_, moving_, last_bodies_, reach_}, differences_);
    return std::move(differences_);
  }

 private:
  void require(bool holds, const std::string& subject) { differences_.require(holds, subject); }

  // The joint of this index among the moving ones, and the body that it moves.
  const Joint& written(std::size_t moving) const { return robot_.joints[static_cast<std::size_t>(moving_[moving])]; }
  std::size_t body_of(std::size_t moving) const { return last_bodies_[moving]; }
  // The first of the three bodies of a spherical joint; for other joints, their only one.
  std::size_t first_body_of(std::size_t moving) const { return body_of(moving) + 1 - bodies_of(written(moving)); }
  std::size_t base_bodies() const { return robot_.floating_base ? 6 : 0; }
  // The body that the base link is part of.
  int base_body() const { return static_cast<int>(base_bodies()) - 1; }
  const FieldFrame<Real>& place(int link) const { return found_.links[static_cast<std::size_t>(link)]; }

  // Whether links, joints and symbols are the same, by name and order; without that, nothing else can be compared.
  bool has_same_parts() {
    require(mechanism_.floating_base == robot_.floating_base, "whether the base floats");
    require(mechanism_.bodies.size() == body_count_, "the number of moving joints");
    require(mechanism_.links.size() == robot_.links.size(), "the number of links");
    require(mechanism_.symbols.size() == robot_.symbols.size(), "the number of free symbols");
    if (!differences_.first().empty()) return false;
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      const Body& body = mechanism_.bodies[body_of(i)];
      const int index = static_cast<int>(body_of(i));
      const std::string name = joint_name(written(i));
      const bool is_spherical = written(i).type == JointType::spherical;
      require(body.joint == written(i).name + (is_spherical ? ".wz" : ""), name + ": its name");
      require((body.spherical == kSphericalBodies) == is_spherical, name + ": its kind");
      require(body.prismatic == (written(i).type == JointType::prismatic), name + ": its kind");
      require(body.continuous == (written(i).type == JointType::continuous), name + ": its kind");
      require(body.is_tendon == written(i).is_tendon, name + ": its kind");
      require(body.parent < index, name + ": its parent");
      require(!body.rotor || body.rotor->carrier < index, name + ": the carrier of its rotor");
      require(mechanism_.links[static_cast<std::size_t>(written(i).child)].body == index,
              name + ": the link that it moves");
      require(mechanism_.links[static_cast<std::size_t>(written(i).parent)].body ==
                  mechanism_.bodies[first_body_of(i)].parent,
              name + ": its parent");
      for (std::size_t k = first_body_of(i); k < body_of(i); ++k) {
        const Body& before = mechanism_.bodies[k];
        require(before.spherical == static_cast<int>(k - first_body_of(i)) + 1 && before.inertia.is_zero() &&
                    mechanism_.bodies[k + 1].parent == static_cast<int>(k),
                name + ": its bodies");
      }
    }
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      require(mechanism_.links[l].link == robot_.links[l].name, "link \"" + robot_.links[l].name + "\": its name");
    }
    for (std::size_t k = 0; k < robot_.symbols.size(); ++k) {
      require(mechanism_.symbols[k].symbol.is_equal(robot_.symbols[k].symbol),
              "symbol " + robot_.symbols[k].name + ": its name");
    }
    return differences_.first().empty();
  }

  static std::string joint_name(const Joint& joint) { return "joint \"" + joint.name + "\""; }

  void add_lengths(const Pose& pose) {
    for (const Displacement& step : pose.displacements) reach_ += length_sum(vector_over(numbers_, step.translation));
  }

  // The sum of all lengths as written, compared with which rounding is small.
  void find_reach() {
    add_lengths(robot_.tip_offset);
    for (const SceneContact& contact : robot_.scene.contacts) {
      reach_ += length_sum(vector_over(numbers_, contact.position));
    }
    for (const Joint& joint : robot_.joints) {
      add_lengths(joint.origin);
      add_lengths(joint.link_offset);
      if (joint.motor) reach_ += length_sum(vector_over(numbers_, joint.motor->position));
      if (joint.held && joint.held->type == JointType::prismatic) reach_ += abs(numbers_.number(joint.held->position));
      if (joint.coupled && joint.type == JointType::prismatic) reach_ += abs(numbers_.number(joint.coupled->offset));
    }
    for (const Link& link : robot_.links) {
      for (const Inertial& inertial : link.inertials) {
        add_lengths(inertial.frame);
        reach_ += length_sum(vector_over(numbers_, inertial.centre_of_mass));
      }
    }
  }

  void compare_pose(const std::string& subject, const RealPose& found, const RealPose& expected, const Real& length) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) differences_.compare(subject, found.R[i][j], expected.R[i][j], 1);
      differences_.compare(subject, found.p[i], expected.p[i], length);
    }
  }

  void compare_vector(const std::string& subject, const Vector3<Real>& found, const Vector3<Real>& expected,
                      const Real& scale) {
    for (std::size_t k = 0; k < 3; ++k) differences_.compare(subject, found[k], expected[k], scale);
  }

  static RealPose pose_of(const FieldFrame<Real>& frame) { return {frame.R, frame.p}; }

  // The root link, whose frame is the base frame; gravity; the tip.
  void compare_base() {
    require(place(robot_.root).body == base_body(), "the base link: its body");
    compare_pose("the base link: its place", pose_of(place(robot_.root)), identity_pose<Real>(), reach_);
    const Vector3<Real> gravity = vector_over(numbers_, robot_.gravity);
    compare_vector("gravity", found_.gravity, gravity, length_sum(gravity));
    const FieldFrame<Real>& link = place(robot_.tip);
    require(found_.tip.body == link.body, "the tip: its body");
    compare_pose("the tip: its place", pose_of(found_.tip),
                 composed(pose_of(link), pose_over(numbers_, robot_.tip_offset)), reach_);
    compare_contacts();
  }

  void compare_contacts() {
    const std::vector<SceneContact>& written = robot_.scene.contacts;
    require(found_.contacts.size() == written.size(), "contacts: their number");
    for (std::size_t k = 0; k < written.size(); ++k) {
      const FieldFrame<Real>& link = place(written[k].index);
      require(found_.contacts[k].body == link.body, "contact " + written[k].name + ": its body");
      const RealPose point{identity_pose<Real>().R, vector_over(numbers_, written[k].position)};
      compare_pose("contact " + written[k].name, pose_of(found_.contacts[k]), composed(pose_of(link), point), reach_);
    }
  }

  // The chain of a floating base: its bodies' axes are those of the base, in order, through its origin, and all that
  // has inertia is the last one's.
  void compare_motion_of_base() {
    Matrix3<Real> R = identity_pose<Real>().R;
    for (std::size_t k = 0; k < base_bodies(); ++k) {
      const FieldBody<Real>& body = found_.bodies[k];
      const std::string subject = "body " + std::to_string(k) + " of the floating base";
      require(body.parent == static_cast<int>(k) - 1 && body.prismatic == (k < 3), subject);
      R = times(R, body.R);
      Vector3<Real> axis = {0, 0, 0};
      axis[k % 3] = 1;
      compare_vector(subject, {R[0][2], R[1][2], R[2][2]}, axis, 1);
      compare_vector(subject, body.p, {0, 0, 0}, reach_ + 1);
      const bool has_inertia = body.inertia.mass != 0 || length_sum(body.inertia.first_moment) != 0;
      require(!has_inertia || k + 1 == base_bodies(), subject);
      require(body.stiffness == 0 && !body.rotor, subject);
      compare_own(subject + ": its armature", body.armature, robot_.base_joint.armature);
      compare_own(subject + ": its viscous friction", body.viscous, robot_.base_joint.viscous);
      compare_own(subject + ": its Coulomb friction", body.coulomb,
                  body.prismatic ? Value{} : robot_.base_joint.coulomb);
    }
  }

  bool has_coordinate(const Joint& joint) const {
    if (joint.type == JointType::fixed) return false;
    if (!joint.coupled) return true;
    Real own = 0;
    for (const Coupled::Term& term : joint.coupled->terms) {
      if (term.joint.name == joint.name) own += numbers_.number(term.factor);
    }
    return own != 0;
  }

  // The factors of all coordinates in a position, and a constant.
  struct Position {
    std::vector<Real> factors;
    Real offset = 0;
  };

  // The position of the joint of this name, where another one names it, from the mechanism's own couplings.
  Position position_of(const std::string& name) const {
    Position position{std::vector<Real>(mechanism_.coordinates.size(), Real(0)), 0};
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&name](const Joint& joint) { return joint.name == name; });
    if (found == robot_.joints.end()) return position;
    if (found->type == JointType::fixed) {
      if (found->held) position.offset = numbers_.number(found->held->position);
      return position;
    }
    const auto index = static_cast<int>(found - robot_.joints.begin());
    const auto body = static_cast<std::size_t>(std::find(moving_.begin(), moving_.end(), index) - moving_.begin());
    if (has_coordinate(*found)) {
      for (std::size_t k = 0; k < mechanism_.coordinates.size(); ++k) {
        if (mechanism_.coordinates[k] == static_cast<int>(base_bodies() + body)) position.factors[k] = 1;
      }
      return position;
    }
    for (std::size_t k = 0; k < position.factors.size(); ++k) position.factors[k] = coupling_of(body, k);
    return {position.factors, offset_of(body)};
  }

  // The factor of a coordinate in the position of a moving joint.
  const Real& coupling_of(std::size_t moving, std::size_t coordinate) const {
    return found_.coupling[base_bodies() + moving][base_bodies() + coordinate];
  }

  // The positions of coupled joints satisfy the equations as written, which determine them.
  void compare_couplings() {
    if (!mechanism_.is_coupled()) {
      for (const int j : moving_) {
        const Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
        require(!joint.coupled, joint_name(joint) + ": its coupling");
      }
      return;
    }
    std::vector<int> owners;
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      if (has_coordinate(written(i))) owners.push_back(static_cast<int>(base_bodies() + i));
    }
    require(owners == mechanism_.coordinates, "the joints that have coordinates");
    const std::size_t count = base_bodies() + moving_.size();
    require(found_.coupling.size() == count && mechanism_.offsets.size() == count, "the number of couplings");
    for (std::size_t i = 0; i < moving_.size() && differences_.first().empty(); ++i) compare_coupling(i);
  }

  void compare_coupling(std::size_t body) {
    const Joint& joint = written(body);
    const std::string subject = joint_name(joint) + ": its coupling";
    Position expected = position_of(joint.name);
    if (joint.coupled) {
      expected = {std::vector<Real>(mechanism_.coordinates.size(), Real(0)), numbers_.number(joint.coupled->offset)};
      for (const Coupled::Term& term : joint.coupled->terms) {
        const Position leader = position_of(term.joint.name);
        const Real factor = numbers_.number(term.factor);
        for (std::size_t k = 0; k < leader.factors.size(); ++k) expected.factors[k] += factor * leader.factors[k];
        expected.offset += factor * leader.offset;
      }
    }
    for (std::size_t k = 0; k < expected.factors.size(); ++k) {
      differences_.compare(subject, coupling_of(body, k), expected.factors[k], 1 + abs(expected.factors[k]));
    }
    differences_.compare(subject, offset_of(body), expected.offset, 1 + abs(expected.offset));
  }

  Real offset_of(std::size_t body) const {
    return numbers_.number(mechanism_.offset_of(static_cast<int>(base_bodies() + body)));
  }

  // Compares the place of a joint's child link relative to its parent link.
  void compare_place(std::size_t j) {
    const Joint& joint = robot_.joints[j];
    const RealPose before = composed(pose_of(place(joint.parent)), pose_over(numbers_, joint.origin)),
                   after = pose_over(numbers_, joint.link_offset), child = pose_of(place(joint.child));
    const std::string subject = "link \"" + robot_.links[static_cast<std::size_t>(joint.child)].name + "\": its place";
    if (joint.type == JointType::fixed) {
      require(place(joint.child).body == place(joint.parent).body, subject);
      compare_pose(subject, child, composed(composed(before, held_motion(joint)), after), reach_);
      return;
    }
    compare_motion(subject, joint, composed(before, identity_pose<Real>()), after);
  }

  RealPose held_motion(const Joint& joint) const {
    if (!joint.held) return identity_pose<Real>();
    const bool slides = joint.held->type == JointType::prismatic;
    return motion_along(numbers_.unit(joint.axis), slides, point_at(joint.held->position, slides));
  }

  JointPoint<Real> point_at(const Number& position, bool slides) const {
    if (!slides) return numbers_.angle(position);
    return {1, 0, numbers_.number(position)};
  }

  // Both sides are affine in c and s, or in d: three values, of which none needs to be on the circle, or two of d
  // decide.
  void compare_motion(const std::string& subject, const Joint& joint, const RealPose& before, const RealPose& after) {
    const FieldFrame<Real>& child = place(joint.child);
    const auto body = static_cast<std::size_t>(child.body);
    if (joint.type == JointType::spherical) return compare_rotation(subject, child, before, after);
    const bool slides = joint.type == JointType::prismatic;
    const Vector3<Real> axis = numbers_.unit(joint.axis);
    const JointPoint<Real> offset = point_at(mechanism_.offset_of(child.body), slides);
    const RealPose held{found_.bodies[body].R, found_.bodies[body].p};
    using Point = JointPoint<Real>;
    for (const Point& q : {Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 1}}) {
      const Point turned{q.c * offset.c - q.s * offset.s, q.s * offset.c + q.c * offset.s, q.d + offset.d};
      const RealPose found = composed(composed(held, motion_along_z(slides, q)), pose_of(child));
      const RealPose expected = composed(composed(before, motion_along(axis, slides, turned)), after);
      compare_pose(subject, found, expected, reach_ + q.d);
    }
  }

  // Both sides are linear in the rotation by the quaternion, whose numbers are drawn.
  void compare_rotation(const std::string& subject, const FieldFrame<Real>& child, const RealPose& before,
                        const RealPose& after) {
    const auto last = static_cast<std::size_t>(child.body);
    RealPose found = identity_pose<Real>();
    for (std::size_t k = last + 1 - kSphericalBodies; k <= last; ++k) {
      found = composed(found, RealPose{found_.bodies[k].R, found_.bodies[k].p});
    }
    const int q = mechanism_.quaternion_of(static_cast<int>(last));
    const auto entry = [&](int k) { return arithmetic_.input({InputKind::q, q + k}); };
    RealPose turned = identity_pose<Real>();
    turned.R = rotation_of_quaternion<Real>({entry(0), entry(1), entry(2), entry(3)});
    compare_pose(subject, composed(found, pose_of(child)), composed(composed(before, turned), after), reach_);
  }

  void compare_own(const std::string& subject, const Real& found, const Value& expected) {
    const Real value = numbers_.number(expected.number);
    differences_.compare(subject, found, value, abs(value));
  }

  // F_s, the mean of both directions, and how friction depends on the rate.
  void compare_dry_friction(const std::string& name, const FieldBody<Real>& body, const Joint& joint) {
    const DryFrictionLaw& law = joint.law;
    const auto compare = [&](const std::string& what, const Real& found, const Real& expected) {
      differences_.compare(name + ": its " + what, found, expected, abs(expected));
    };
    const auto value = [this](const std::optional<Value>& given) {
      return given ? numbers_.number(given->number) : Real(0);
    };
    const Real forward = numbers_.number(joint.coulomb.number), backward = law.backward ? value(law.backward) : forward;
    const Real mean = (forward + backward) / 2;
    compare("Coulomb friction", body.coulomb, mean);
    compare("asymmetric friction", body.dry.asymmetry, (forward - backward) / 2);
    compare("speed of Coulomb friction", body.dry.speed, value(law.speed));
    compare("offset of Coulomb friction", body.dry.offset, value(law.offset));
    compare("static friction", body.dry.excess + body.coulomb,
            law.static_friction ? value(law.static_friction) : body.coulomb);
    compare("Stribeck speed", body.dry.stribeck_speed, value(law.stribeck_speed));
    compare("friction of loads", body.dry.load, value(law.load));
    if (law.offset) compare("offset's friction", body.dry.at_rest, tanh(value(law.offset) / value(law.speed)));
  }

  void compare_joint(std::size_t i) {
    const Joint& joint = written(i);
    const FieldBody<Real>& body = found_.bodies[body_of(i)];
    const std::string name = joint_name(joint);
    compare_own(name + ": its armature", body.armature, joint.armature);
    compare_own(name + ": its viscous friction", body.viscous, joint.viscous);
    compare_dry_friction(name, body, joint);
    compare_own(name + ": its stiffness", body.stiffness, joint.stiffness);
    if (!vanishes(joint.stiffness.number)) {
      const Real reference = numbers_.number(joint.spring_reference.number);
      differences_.compare(name + ": its spring's reference", body.spring_reference + offset_of(i), reference,
                           1 + abs(reference));
    }
    for (std::size_t k = first_body_of(i); k < body_of(i); ++k) {
      compare_own(name + ": its viscous friction", found_.bodies[k].viscous, joint.viscous);
      compare_limits(name + ": its limits", mechanism_.bodies[k].limits, joint.limits);
    }
    if (!mechanism_.is_coupled())
      compare_limits(name + ": its limits", mechanism_.bodies[body_of(i)].limits, joint.limits);
    require(body.rotor.has_value() == joint.motor.has_value(), name + ": its rotor");
    if (!body.rotor || !joint.motor) return;
    const FieldFrame<Real>& carrier = place(carrier_of(joint));
    require(body.rotor->carrier == carrier.body, name + ": the carrier of its rotor");
    compare_own(name + ": its gear ratio", body.rotor->gear_ratio, joint.motor->gear_ratio);
    compare_own(name + ": the inertia of its rotor", body.rotor->inertia, joint.motor->inertia_axial);
    compare_vector(name + ": the axis of its rotor", body.rotor->axis,
                   times(carrier.R, numbers_.unit(joint.motor->axis)), 1);
  }

  void compare_limits(const std::string& subject, const Limits& found, const Limits& expected) {
    const auto same = [](const std::optional<Value>& a, const std::optional<Value>& b) {
      return a.has_value() == b.has_value() && (!a || vanishes(a->number - b->number));
    };
    require(same(found.lower, expected.lower) && same(found.upper, expected.upper) &&
                same(found.velocity, expected.velocity) && same(found.acceleration, expected.acceleration) &&
                same(found.effort, expected.effort),
            subject);
  }

  const Robot& robot_;
  const Mechanism& mechanism_;
  RealArithmetic<Real> arithmetic_;
  RealNumbers numbers_;
  MechanismOver<Real> found_;
  std::vector<int> moving_;
  std::vector<std::size_t> last_bodies_;  // by moving joint
  std::size_t body_count_ = 0;
  Real reach_ = 0;
  Differences differences_;
};

}  // namespace

RealArithmetic<Digits100> drawn_reals(std::uint64_t seed) {
  return RealArithmetic<Digits100>([seed](const Input& input) {
    const std::uint64_t key = (static_cast<std::uint64_t>(input.kind) << 32U) + static_cast<std::uint64_t>(input.index);
    return Digits100(0.5) + Digits100(splitmix64(seed, key) >> 11U) / Digits100(std::uint64_t{1} << 53U);
  });
}

void Differences::compare(const std::string& subject, const Digits100& found, const Digits100& expected,
                          const Digits100& scale) {
  ++numbers_;
  const Digits100 difference = abs(found - expected);
  if (difference == 0) return;
  const double relative = scale == 0 ? 1 : Digits100(difference / scale).convert_to<double>();
  largest_ = std::max(largest_, relative);
  require(relative <= kAsReadTolerance, subject);
}

Differences compare_numbers(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed) {
  return NumberComparison(robot, mechanism, seed).run();
}

}  // namespace flatdyn
