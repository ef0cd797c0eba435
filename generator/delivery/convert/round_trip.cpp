// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/convert/round_trip.hpp"

#include <algorithm>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"
#include "flatdyn/reference/newton_euler.hpp"
#include "robot/input/reader.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

namespace {

struct NamedNumber {
  std::string name;
  Number number;
};

// Tables of TOML have no order.
std::vector<JointPosition> in_order_of_names(std::vector<JointPosition> positions) {
  std::sort(positions.begin(), positions.end(),
            [](const JointPosition& a, const JointPosition& b) { return a.joint < b.joint; });
  return positions;
}

class NumberCollector {
 public:
  NumberCollector(const Mechanism& mechanism, const Robot& robot) {
    add("gravity", mechanism.gravity);
    for (const Body& body : mechanism.bodies) add(body);
    add("tip", mechanism.tip.p);
    for (const Vec3& row : mechanism.tip.R) add("tip", row);
    for (const auto& row : mechanism.coupling) {
      for (const Number& entry : row) add("coupling", entry);
    }
    for (const Number& offset : mechanism.offsets) add("offset of a coupling", offset);
    add("base", mechanism.base);
    for (const Loop& loop : robot.loops) add(loop);
    for (const JointPosition& each : in_order_of_names(robot.assembly)) {
      add("assembly, joint \"" + each.joint + "\"", each.position);
    }
  }

  std::vector<NamedNumber> all;

 private:
  void add(const std::string& name, const Number& number) { all.push_back({name, number}); }
  void add(const std::string& name, const Vec3& v) {
    for (const Number& entry : v) add(name, entry);
  }
  void add(const std::string& name, const std::optional<Value>& value) {
    add(name + (value ? "" : ", none"), value ? value->number : Number(0));
  }
  void add(const std::string& name, const InertialParameters& inertia) {
    add(name + ", mass", inertia.mass);
    add(name + ", first moment", inertia.first_moment);
    for (const Vec3& row : inertia.inertia) add(name + ", inertia", row);
  }

  void add(const Loop& loop) {
    std::string name = "loop between \"" + loop.links[0].name + "\" and \"" + loop.links[1].name + "\"";
    for (const Reference& joint : loop.dependent) name += ", " + joint.name;
    for (const Vec3& point : loop.points) add(name + ", points", point);
    if (!loop.axes) return;
    for (const Vec3& axis : *loop.axes) add(name + ", axes", axis);
  }

  void add_dry_friction(const std::string& name, const DryFriction& dry) {
    add(name + "speed", dry.speed);
    add(name + "offset", dry.offset);
    add(name + "excess", dry.excess);
    add(name + "Stribeck speed", dry.stribeck_speed);
    add(name + "asymmetry", dry.asymmetry);
    add(name + "share of the load", dry.load);
  }

  void add(const Body& body) {
    // The name has all that is no number.
    const std::string name = "joint \"" + body.joint + "\" on body " + std::to_string(body.parent) +
                             (body.prismatic ? ", prismatic" : "") + (body.continuous ? ", continuous" : "") +
                             (body.is_tendon ? ", tendon" : "");
    for (const PlanarRotation& rotation : {body.beta, body.alpha, body.theta}) {
      add(name + ", orientation", rotation.c);
      add(name + ", orientation", rotation.s);
    }
    add(name + ", position", body.p);
    add(name, body.inertia);
    add(name + ", armature", body.armature);
    add(name + ", friction", body.viscous);
    add(name + ", friction", body.coulomb);
    add_dry_friction(name + ", friction, ", body.dry);
    add(name + ", spring", body.stiffness);
    add(name + ", spring", body.spring_reference);
    const Limits& limits = body.limits;
    for (const auto* limit : {&limits.lower, &limits.upper, &limits.velocity, &limits.acceleration, &limits.effort}) {
      add(name + ", limits", *limit);
    }
    if (!body.rotor) return;
    add(name + ", rotor on body " + std::to_string(body.rotor->carrier), body.rotor->axis);
    add(name + ", rotor", body.rotor->gear_ratio);
    add(name + ", rotor", body.rotor->inertia);
  }
};

// In a folder of its own, under the name that the file will have.
Robot read_back(const std::string& text, const std::string& path) {
  const TemporaryFolder folder;
  const std::filesystem::path copy = folder.path() / std::filesystem::path(path).filename();
  write_file(copy, text);
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_robot(copy, {}, diagnostics);
  if (robot) return *std::move(robot);
  for (const Diagnostic& each : diagnostics.all()) {
    if (each.severity != Severity::error) continue;
    throw Failure(FailureKind::unsupported, "what would be written cannot be read: " + each.message, each.hint);
  }
  throw Failure(FailureKind::bug, "what would be written cannot be read");
}

// The symbols of one reading as those of the other.
GiNaC::exmap same_symbols(const Robot& from, const Robot& to) {
  GiNaC::exmap same;
  for (const FreeSymbol& symbol : from.symbols) {
    for (const FreeSymbol& other : to.symbols) {
      if (symbol.name == other.name) same[symbol.symbol] = other.symbol;
    }
  }
  return same;
}

using Torques = reference::VectorX<Real50>;

// Canonical frames may be chosen otherwise when a last digit changes; torques are those of the robot.
double difference_of_torques(Robot before, Robot after) {
  constexpr int kStates = 4;
  before.loops.clear();  // of the tree, whose joints all move
  after.loops.clear();
  const auto a = reference_robot<Real50>(before, {}), b = reference_robot<Real50>(after, {});
  const Eigen::Index n = a.size();
  Real50 largest = 0, torque = 0;
  for (int state = 1; state <= kStates; ++state) {
    Torques q(n), qd(n), qdd(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      q[i] = Real50((7 * i + 3 * state) % 11 - 5) / 4;
      qd[i] = Real50((5 * i + 4 * state) % 9 - 4) / 3;
      qdd[i] = Real50((3 * i + 8 * state) % 13 - 6) / 2;
    }
    const Torques tau = reference::inverse_dynamics<Real50>(a, q, qd, qdd);
    const Torques again = reference::inverse_dynamics<Real50>(b, q, qd, qdd);
    for (Eigen::Index i = 0; i < n; ++i) {
      largest = std::max(largest, Real50(abs(tau[i] - again[i])));
      torque = std::max(torque, Real50(abs(tau[i])));
    }
  }
  return torque == 0 ? 0 : Real50(largest / torque).convert_to<double>();
}

}  // namespace

RoundTrip round_trip(const std::string& text, const std::string& path, const LoadedRobot& model) {
  const Robot robot = read_back(text, path);
  const Mechanism again = make_mechanism(robot);
  const std::vector<NamedNumber> before = NumberCollector(model.mechanism, model.robot).all,
                                 after = NumberCollector(again, robot).all;
  const GiNaC::exmap same = same_symbols(robot, model.robot);
  RoundTrip result;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i >= after.size() || before[i].name != after[i].name) {
      throw Failure(FailureKind::unsupported,
                    "the file would be read as another mechanism, from " + before[i].name + " on",
                    "joints may come in another order, or names mean something else in that format");
    }
    if (!result.is_exact || vanishes(Number(before[i].number - after[i].number.subs(same)).normal())) continue;
    result.is_exact = false;
    result.where = before[i].name;
  }
  if (!result.is_exact && !model.robot.symbols.empty()) {
    throw Failure(FailureKind::unsupported, "the file would be read as another robot: " + result.where + " differs",
                  "give the symbols values in the file");
  }
  if (!result.is_exact) result.largest = difference_of_torques(model.robot, robot);
  return result;
}

}  // namespace flatdyn
