// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/links_in_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "derivation/notation/number_text.hpp"
#include "flatdyn/reference/kinematics.hpp"
#include "report/number_json.hpp"
#include "robot/model/physical_inertia.hpp"
#include "robot/model/spherical_joint.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using Vector = reference::Vector3<double>;
using NumericRobot = reference::Robot<double>;
using NumericJoint = reference::Joint<double>;

const LinkFrame& frame_of(const Mechanism& mechanism, int body) {
  const std::string& link = mechanism.bodies[static_cast<std::size_t>(body)].link;
  return *std::find_if(mechanism.links.begin(), mechanism.links.end(),
                       [&](const LinkFrame& frame) { return frame.body == body && frame.link == link; });
}

// Points of the numeric robot in the links' frames: each link's own joint, the joints on it, and the tip.
class Lengths {
 public:
  explicit Lengths(const NumericRobot& robot) : robot_(robot) {}

  const NumericJoint* joint_of(int link) const {
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [link](const NumericJoint& joint) { return joint.child == link; });
    return found == robot_.joints.end() ? nullptr : &*found;
  }

  // The length of a link, m; none if it carries neither a moving joint nor the tip.
  std::optional<double> of(int link) const {
    const NumericJoint* joint = joint_of(link);
    farthest_.reset();
    from_ = joint == nullptr ? Vector(Vector::Zero()) : Vector(-joint->R_1.transpose() * joint->p_1);
    visit(link, reference::Matrix3<double>::Identity(), Vector::Zero());
    return farthest_;
  }

 private:
  void visit(int link, const reference::Matrix3<double>& R, const Vector& p) const {
    if (link == robot_.tip) measure(p + R * robot_.p_tip);
    for (const NumericJoint& joint : robot_.joints) {
      if (joint.parent != link) continue;
      if (joint.index >= 0) {
        measure(p + R * joint.p_0);
      } else {
        const reference::Matrix3<double> R_0 = R * joint.R_0;
        visit(joint.child, R_0 * joint.R_1, p + R * joint.p_0 + R_0 * joint.p_1);
      }
    }
  }
  void measure(const Vector& point) const { farthest_ = std::max(farthest_.value_or(0), (point - from_).norm()); }

  const NumericRobot& robot_;
  mutable Vector from_ = Vector::Zero();
  mutable std::optional<double> farthest_;
};

int written_link(const Robot& robot, const std::string& name) {
  const auto found =
      std::find_if(robot.links.begin(), robot.links.end(), [&](const Link& link) { return link.name == name; });
  return static_cast<int>(found - robot.links.begin());
}

// The summed mass of all links, including those that do not move.
Number total_mass(const Mechanism& mechanism) {
  Number mass = mechanism.base.mass;
  for (const Body& body : mechanism.bodies) mass += body.inertia.mass;
  return mass.expand();
}

bool has_values(const LoadedRobot& model) { return model.robot.symbols.empty(); }

std::string moment_text(const Mat3& I, const NumberText& number) {
  return fmt::format("xx {}, yy {}, zz {}, xy {}, xz {}, yz {} kg m^2", number(I[0][0]), number(I[1][1]),
                     number(I[2][2]), number(I[0][1]), number(I[0][2]), number(I[1][2]));
}

// With symbols, the centre of mass would be a quotient of sums; its product with the mass is easier to read.
std::string inertia_text(const InertialParameters& b, const NumberText& number) {
  if (has_symbols(b.mass)) {
    return fmt::format("  m = {} kg, m r = {} kg m\n  I = {} about the link's origin\n", number(b.mass),
                       number(b.first_moment), moment_text(b.inertia, number));
  }
  return fmt::format("  m = {} kg, com = {} m\n  I = {} about com\n", number(b.mass), number(centre_of_mass(b)),
                     moment_text(central_tensor(b), number));
}

// Says what friction is beyond F_s sgn(q̇).
std::string dry_friction_text(const Body& body, const NumberText& number) {
  const DryFriction& dry = body.dry;
  const std::string unit = torque_unit(body), speed = body.prismatic ? "m/s" : "rad/s";
  std::string text;
  const auto add = [&](const char* what, const Number& value, const std::string& of) {
    if (!vanishes(value)) text += fmt::format(", {} {} {}", what, number(value), of);
  };
  add("smooth around", dry.speed, speed);
  add("offset by", dry.offset, speed);
  if (dry.has_excess()) add("static", body.coulomb + dry.excess, unit);
  add("Stribeck speed", dry.stribeck_speed, speed);
  add("of loads", dry.load, "|tau|");
  if (!vanishes(dry.asymmetry)) {
    text += fmt::format(": {} forward, {} backward", number(body.coulomb + dry.asymmetry),
                        number(body.coulomb - dry.asymmetry));
  }
  return text;
}

std::string friction_text(const Body& body, const Mechanism& mechanism, const NumberText& number) {
  const std::string unit = torque_unit(body), rate = body.prismatic ? " s/m" : " s/rad";
  std::string text = fmt::format("  friction F_v = {} {}{}, F_s = {} {}{}\n", number(body.viscous), unit, rate,
                                 number(body.coulomb), unit, dry_friction_text(body, number));
  if (!vanishes(body.armature)) text += fmt::format("  reflected inertia {}\n", number(body.armature));
  if (!vanishes(body.stiffness)) {
    text += fmt::format("  spring k = {} {}{}, q_0 = {} {}{}\n", number(body.stiffness), unit,
                        body.prismatic ? "/m" : "/rad", number(body.spring_reference), body.prismatic ? "m" : "rad",
                        mechanism.is_coupled() ? ", less the constant part of a coupled joint's position" : "");
  }
  if (!body.rotor) return text;
  const int carrier = body.rotor->carrier;
  const Mat3 R = carrier < 0 ? identity_matrix() : frame_of(mechanism, carrier).R;
  return text + fmt::format("  rotor: k_r = {}, I_m = {} kg m^2, axis {} on {}\n", number(body.rotor->gear_ratio),
                            number(body.rotor->inertia), number(expanded(transpose(R) * body.rotor->axis)),
                            carrier < 0 ? "the base" : mechanism.bodies[static_cast<std::size_t>(carrier)].link);
}

std::string mass_text(const Mechanism& mechanism, const NumberText& number) {
  const Number& still = mechanism.base.mass;
  std::string text = fmt::format("total mass {} kg", number(total_mass(mechanism)));
  if (!vanishes(still)) text += fmt::format(", of which {} kg do not move", number(still));
  return text + "\n";
}

std::string reach_text(const Reach& reach, const std::string& tip) {
  const auto& [x, y, z] = reach.at_zero;
  std::string text = fmt::format("tip {}: at ({:.6g}, {:.6g}, {:.6g}) m at q = 0, within {:.6g} m of joint {}", tip, x,
                                 y, z, reach.links, reach.first_joint);
  if (!reach.without.empty()) text += fmt::format(", beside the strokes of {}", fmt::join(reach.without, ", "));
  return text + "\n";
}

// The first body that is a link: with a floating base, that is the base.
int first_link(const Mechanism& mechanism) { return std::max(0, mechanism.base_bodies() - 1); }

// Sets sums to 0 that are only rounding errors.
double without_dust(double x) {
  constexpr double kDust = 1e-12;  // m
  return std::abs(x) < kDust ? 0 : x;
}

}  // namespace

std::vector<LinkInFile> links_in_file(const LoadedRobot& model) {
  const Mechanism& mechanism = model.mechanism;
  std::vector<LinkInFile> links;
  std::optional<NumericRobot> numeric;
  if (has_values(model)) numeric = reference_robot<double>(model.robot, {});
  for (int i = first_link(mechanism); i < mechanism.body_count(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    if (has_no_link(body)) continue;
    const LinkFrame& frame = frame_of(mechanism, i);
    const Mat3 back = transpose(frame.R);
    LinkInFile link;
    link.body = i;
    link.inertia = transformed(body.inertia, back, expanded(Number(-1) * (back * frame.p)));
    for (const LinkFrame& other : mechanism.links) {
      if (other.body == i && other.link != body.link) link.with.push_back(other.link);
    }
    if (numeric) link.length = Lengths(*numeric).of(written_link(model.robot, body.link));
    links.push_back(std::move(link));
  }
  return links;
}

std::optional<Reach> reach_of(const LoadedRobot& model) {
  const Mechanism& mechanism = model.mechanism;
  if (!has_values(model) || mechanism.has_loops() || mechanism.tip.body < 0 || mechanism.floating_base) {
    return std::nullopt;
  }
  const std::vector<LinkInFile> links = links_in_file(model);
  const std::vector<int> way = path_to(mechanism, mechanism.tip.body);
  Reach reach;
  reach.first_joint = joint_name(mechanism.bodies[static_cast<std::size_t>(way.front())]);
  for (const LinkInFile& link : links) {
    if (std::find(way.begin(), way.end(), link.body) != way.end()) reach.links += link.length.value_or(0);
  }
  for (const int i : way) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    if (!body.prismatic) continue;
    if (body.limits.lower && body.limits.upper) {
      reach.links += std::max(std::abs(nearest_double(body.limits.lower->number)),
                              std::abs(nearest_double(body.limits.upper->number)));
    } else {
      reach.without.push_back(body.joint);
    }
  }
  const NumericRobot numeric = reference_robot<double>(model.robot, {});
  const reference::VectorX<double> zero = reference::VectorX<double>::Zero(numeric.position_count());
  const Vector p = reference::tip_pose(numeric, zero).p;
  reach.at_zero = {without_dust(p.x()), without_dust(p.y()), without_dust(p.z())};
  return reach;
}

std::string describe_links(const LoadedRobot& model) {
  const Mechanism& mechanism = model.mechanism;
  const NumberText number(mechanism);
  std::string text = mass_text(mechanism, number);
  if (const std::optional<Reach> reach = reach_of(model)) text += reach_text(*reach, mechanism.tip.link);
  text +=
      "\nlinks in the file's frames: origin and axes are those of the link in the file; a link is as long as from its\n"
      "joint to the farthest joint on it, or to the tip\n";
  for (const LinkInFile& link : links_in_file(model)) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(link.body)];
    text += mechanism.is_of_base(link.body)
                ? fmt::format("base ({}), which floats", body.link)
                : fmt::format("link {} ({}), moved by {}", link.body + 1 - mechanism.base_bodies(), body.link,
                              joint_name(body));
    if (link.length) text += fmt::format(", {:.6g} m long", *link.length);
    if (!link.with.empty()) text += fmt::format(", with {}", fmt::join(link.with, ", "));
    text += "\n" + inertia_text(link.inertia, number);
    if (!mechanism.is_of_base(link.body)) text += friction_text(body, mechanism, number);
  }
  return text;
}

nlohmann::ordered_json links_json(const LoadedRobot& model) {
  const Mechanism& mechanism = model.mechanism;
  const NumberText text(mechanism);
  nlohmann::ordered_json json;
  json["mass"] = number_json(total_mass(mechanism), text);
  if (const std::optional<Reach> reach = reach_of(model)) {
    json["reach"] = {{"joint", reach->first_joint}, {"at_most", reach->links}, {"without_strokes_of", reach->without}};
    json["tip_at_zero"] = reach->at_zero;
  }
  json["links"] = nlohmann::ordered_json::array();
  for (const LinkInFile& link : links_in_file(model)) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(link.body)];
    nlohmann::ordered_json item = {{"name", body.link}, {"joint", joint_name(body)}, {"with", link.with}};
    if (link.length) item["length"] = *link.length;
    item["mass"] = number_json(link.inertia.mass, text);
    item["first_moment"] = list_json(link.inertia.first_moment, text);
    if (!has_symbols(link.inertia.mass)) {
      item["com"] = list_json(centre_of_mass(link.inertia), text);
      item["inertia_about_com"] = matrix_json(central_tensor(link.inertia), text);
    }
    item["inertia_about_origin"] = matrix_json(link.inertia.inertia, text);
    json["links"].push_back(item);
  }
  return json;
}

}  // namespace flatdyn
