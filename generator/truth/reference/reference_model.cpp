// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/reference_model.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <type_traits>

#include "robot/model/coupling.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

namespace {

// Whether a symbol is in a load_friction, which has to be less than 1.
bool is_share(const FreeSymbol& symbol, const Robot& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(), [&symbol](const Joint& joint) {
    return joint.law.load && joint.law.load->number.has(symbol.symbol);
  });
}

}  // namespace

SymbolValues random_symbol_values(const Robot& robot, unsigned seed) {
  std::mt19937 engine(seed);
  SymbolValues values;
  for (std::size_t k = 0; k < robot.symbols.size(); ++k) {
    const long denominator = is_share(robot.symbols[k], robot) ? 2048 : 512;
    values.push_back(GiNaC::numeric(long(engine() % 900 + 100), denominator));
  }
  return values;
}

template <class S>
S to_scalar(const Number& a, const GiNaC::exmap& values) {
  constexpr int kDigits = 60;
  if (a.is_zero()) return S(0);  // most numbers of a robot are zero
  const std::string text = to_decimal(a.subs(values), kDigits);
  if constexpr (std::is_floating_point_v<S>) {
    return Real50(text).convert_to<S>();
  } else {
    return S(text);
  }
}

namespace {

// The state of one conversion from the written robot.
template <class S>
class Converter {
 public:
  Converter(const Robot& robot, const SymbolValues& symbol_values) : robot_(robot), position_(joint_positions(robot)) {
    for (std::size_t k = 0; k < robot.symbols.size(); ++k) values_[robot.symbols[k].symbol] = symbol_values[k];
  }

  reference::Robot<S> run() {
    result_.root = robot_.root;
    result_.floating_base = robot_.floating_base;
    if (robot_.floating_base) {
      result_.base_armature = number(robot_.base_joint.armature.number);
      result_.base_viscous = number(robot_.base_joint.viscous.number);
      result_.base_coulomb = number(robot_.base_joint.coulomb.number);
    }
    next_index_ = result_.base_size();
    result_.gravity = vector(robot_.gravity);
    for (const Link& link : robot_.links) add_link(link);
    attach_joints_of(robot_.root);
    add_motors();
    if (has_coupled_joints(robot_) || !robot_.loops.empty()) couple();
    if (!robot_.loops.empty()) close_loops();
    result_.tip = robot_.tip;
    std::tie(result_.R_tip, result_.p_tip) = pose(robot_.tip_offset);
    for (const SceneContact& contact : robot_.scene.contacts) {
      result_.contacts.push_back(
          {contact.index, vector(contact.position), contact.is_surface, cone_of(contact), contact.is_against_gravity});
    }
    result_.contact_damping = number(to_number(robot_.scene.contact_damping));
    return result_;
  }

 private:
  using Vector = reference::Vector3<S>;
  using Matrix = reference::Matrix3<S>;

  std::vector<std::array<S, 6>> cone_of(const SceneContact& contact) const {
    std::vector<std::array<S, 6>> rows;
    for (const ConeRow& row : flatdyn::cone_of(contact)) {
      rows.emplace_back();
      for (std::size_t k = 0; k < row.size(); ++k) rows.back()[k] = number(row[k]);
    }
    return rows;
  }

  S number(const Number& a) const { return to_scalar<S>(a, values_); }
  Vector vector(const Vec3& v) const { return {number(v[0]), number(v[1]), number(v[2])}; }
  Matrix matrix(const Mat3& m) const {
    Matrix result;
    for (int i = 0; i < 3; ++i) result.row(i) = vector(m[static_cast<std::size_t>(i)]).transpose();
    return result;
  }
  Vector unit(const Vec3& v) const { return vector(v).normalized(); }

  std::pair<Matrix, Vector> pose(const Pose& written) const {
    Matrix R = Matrix::Identity();
    Vector p = Vector::Zero();
    for (const Displacement& step : written.displacements) {
      if (step.kind == Displacement::Kind::translation) {
        p += R * vector(step.translation);
        continue;
      }
      const Vector axis = step.kind == Displacement::Kind::rotation_x   ? Vector(Vector::UnitX())
                          : step.kind == Displacement::Kind::rotation_y ? Vector(Vector::UnitY())
                                                                        : Vector(Vector::UnitZ());
      R = Matrix(R * reference::rotation_about(axis, number(step.angle)));
    }
    return {R, p};
  }

  // m S(r)ᵀ S(r), (7.60).
  static Matrix point_inertia(const S& m, const Vector& r) {
    return m * (r.dot(r) * Matrix::Identity() - r * r.transpose());
  }

  void add_link(const Link& link) {
    reference::Link<S> result;
    for (const Inertial& inertial : link.inertials) {
      const auto [R, p] = pose(inertial.frame);
      const Vector r = vector(inertial.centre_of_mass);
      const S m = number(inertial.mass.number);
      Matrix I = matrix(inertial.tensor);
      if (inertial.about == Inertial::About::frame_origin) I -= point_inertia(m, r);
      result.inertials.push_back({m, p + R * r, R * I * R.transpose()});
    }
    result_.links.push_back(std::move(result));
  }

  void attach_joints_of(int link) {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const Joint& joint = robot_.joints[j];
      if (joint.parent != link) continue;
      reference::Joint<S> result;
      result.parent = joint.parent;
      result.child = joint.child;
      std::tie(result.R_0, result.p_0) = pose(joint.origin);
      std::tie(result.R_1, result.p_1) = pose(joint.link_offset);
      if (joint.type != JointType::fixed) {
        result.type =
            joint.type == JointType::prismatic ? reference::JointType::prismatic : reference::JointType::revolute;
        if (joint.type == JointType::spherical) result.type = reference::JointType::spherical;
        result.index = next_index_;
        next_index_ += result.size();
        result.axis = unit(joint.axis);
        add_offset(j, result);
        result.viscous = number(joint.viscous.number);
        add_dry_friction(joint, result);
        result.armature = number(joint.armature.number);
        result.stiffness = number(joint.stiffness.number);
        result.spring_q_0 = number(joint.spring_reference.number) - number(position_[j].offset);
        if (joint.motor) result.rotor = rotor(joint);
      } else if (joint.held) {
        hold(joint, result);
      }
      result_.joints.push_back(std::move(result));
      attach_joints_of(joint.child);
    }
  }

  // F_s, and how friction depends on the rate, as the file gives it.
  void add_dry_friction(const Joint& joint, reference::Joint<S>& result) const {
    const auto value = [this](const std::optional<Value>& given) { return given ? number(given->number) : S(0); };
    const DryFrictionLaw& law = joint.law;
    const S forward = number(joint.coulomb.number), backward = law.backward ? value(law.backward) : forward;
    result.coulomb = (forward + backward) / S(2);
    result.dry = {value(law.speed),          value(law.offset),           S(0),
                  value(law.stribeck_speed), (forward - backward) / S(2), value(law.load)};
    if (law.static_friction) result.dry.excess = value(law.static_friction) - result.coulomb;
  }

  // Makes the motion of a joint that is held still a part of the transform before it.
  void hold(const Joint& joint, reference::Joint<S>& result) const {
    displace(joint.held->type, joint.held->position, joint, result);
  }

  void displace(JointType type, const Number& by, const Joint& joint, reference::Joint<S>& result) const {
    const S position = number(by);
    if (position == 0) return;
    const Vector axis = unit(joint.axis);
    if (type == JointType::prismatic) {
      result.p_0 += result.R_0 * axis * position;
    } else {
      result.R_0 = Matrix(result.R_0 * reference::rotation_about(axis, position));
    }
  }

  void couple() {
    const std::vector<int> joints = moving_joints(robot_), owners = joints_with_coordinates(robot_);
    result_.coupling =
        reference::MatrixX<S>::Zero(static_cast<Eigen::Index>(joints.size()), static_cast<Eigen::Index>(owners.size()));
    std::map<int, Eigen::Index> column;
    for (const int owner : owners) column.emplace(owner, static_cast<Eigen::Index>(column.size()));
    for (std::size_t i = 0; i < joints.size(); ++i) {
      for (const auto& [owner, factor] : position_[static_cast<std::size_t>(joints[i])].factors) {
        result_.coupling(static_cast<Eigen::Index>(i), column.at(owner)) = number(factor);
      }
    }
  }

  // Takes from the mechanism where loops are cut and which joints are their coordinates; frames are those of written
  // links.
  void close_loops() {
    const Mechanism mechanism = make_mechanism(robot_);
    for (const LoopClosure& closure : mechanism.loops) {
      reference::Loop<S> loop;
      for (std::size_t e = 0; e < 2; ++e) {
        const WrittenLink& link = link_of(mechanism, closure.ends[e].body);
        loop.links[e] = index_of(mechanism, link);
        loop.points[e] = matrix(link.R).transpose() * (vector(closure.ends[e].p) - vector(link.p));
        if (e == 1) loop.axis = matrix(link.R).transpose() * vector(closure.axis);
        for (std::size_t k = 0; k < 2 && e == 0; ++k) {
          loop.across[k] = matrix(link.R).transpose() * vector(closure.across[k]);
        }
      }
      const WrittenLink& carrier = link_of(mechanism, closure.carrier);
      loop.carrier = index_of(mechanism, carrier);
      loop.axes = matrix(carrier.R).transpose() * matrix(closure.axes);
      loop.rows.assign(closure.rows.begin(), closure.rows.end());
      loop.dependent = closure.dependent;
      result_.loops.push_back(std::move(loop));
    }
    result_.independent = mechanism.independent;
  }

  static const WrittenLink& link_of(const Mechanism& mechanism, int body) {
    return *std::find_if(mechanism.links.begin(), mechanism.links.end(),
                         [body](const WrittenLink& link) { return link.body == body; });
  }
  static int index_of(const Mechanism& mechanism, const WrittenLink& link) {
    return static_cast<int>(&link - mechanism.links.data());
  }

  // Makes the offset of a coupled joint at zero coordinates a part of the transform before it.
  void add_offset(std::size_t written, reference::Joint<S>& result) const {
    const Joint& joint = robot_.joints[written];
    if (joint.coupled) displace(joint.type, position_[written].offset, joint, result);
  }

  static int carrier_of(const Joint& joint) { return joint.motor->carrier >= 0 ? joint.motor->carrier : joint.parent; }

  reference::Rotor<S> rotor(const Joint& joint) const {
    return {carrier_of(joint), number(joint.motor->gear_ratio.number), number(joint.motor->inertia_axial.number),
            unit(joint.motor->axis)};
  }

  // Adds the rotors, held still, as bodies on their carriers, (7.63), (7.66).
  void add_motors() {
    for (const Joint& joint : robot_.joints) {
      if (!joint.motor || joint.type == JointType::fixed) continue;
      const Vector z = unit(joint.motor->axis);
      const S across = number(joint.motor->inertia_transverse.number);
      const S along = number(joint.motor->inertia_axial.number);
      const Matrix I = across * Matrix::Identity() + (along - across) * (z * z.transpose());
      result_.links[static_cast<std::size_t>(carrier_of(joint))].inertials.push_back(
          {number(joint.motor->mass.number), vector(joint.motor->position), I});
    }
  }

  const Robot& robot_;
  std::vector<LinearPosition> position_;  // by written joint
  GiNaC::exmap values_;
  reference::Robot<S> result_;
  int next_index_ = 0;
};

}  // namespace

template <class S>
reference::Robot<S> reference_robot(const Robot& robot, const SymbolValues& values) {
  return Converter<S>(robot, values).run();
}

template double to_scalar<double>(const Number&, const GiNaC::exmap&);
template Real50 to_scalar<Real50>(const Number&, const GiNaC::exmap&);
template reference::Robot<double> reference_robot(const Robot&, const SymbolValues&);
template reference::Robot<Real50> reference_robot(const Robot&, const SymbolValues&);

}  // namespace flatdyn
