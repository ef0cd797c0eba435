// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/snap_axis_angles.hpp"

#include <cln/cln.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/model/rational_rotation.hpp"

namespace flatdyn {
namespace {

constexpr std::uintptr_t kWorkingDigits = 70;  // for angles below 1e-9, so that their error is below 1e-40

// The value to kWorkingDigits digits. `a` must be a real number without symbols.
cln::cl_F float_of(const Number& a) {
  return cln::cl_float(cln::the<cln::cl_R>(GiNaC::ex_to<GiNaC::numeric>(a).to_cl_N()),
                       cln::float_format(kWorkingDigits));
}

Number exact(const cln::cl_F& a) { return GiNaC::numeric(cln::cl_N(cln::rational(a))); }

// The angles of a small rotation R = Rz(yaw) Ry(pitch) Rx(roll).
std::vector<Displacement> small_turn(const Mat3& R) {
  using Kind = Displacement::Kind;
  const auto entry = [&R](std::size_t i, std::size_t j) { return float_of(R[i][j]); };
  const cln::cl_F yaw = cln::atan(entry(0, 0), entry(1, 0)), roll = cln::atan(entry(2, 2), entry(2, 1));
  const cln::cl_F pitch = cln::atan(cln::sqrt(cln::square(entry(0, 0)) + cln::square(entry(1, 0))), -entry(2, 0));
  std::vector<Displacement> turns;
  for (const auto& [kind, angle] :
       {std::pair(Kind::rotation_z, yaw), std::pair(Kind::rotation_y, pitch), std::pair(Kind::rotation_x, roll)}) {
    turns.push_back({kind, zero_vector(), exact(angle)});
  }
  return turns;
}

// The multiple of pi/12 nearest to a rotation in a plane.
Number angle_near(const PlanarRotation& turn) {
  const double angle = std::atan2(nearest_double(turn.s), nearest_double(turn.c));
  return static_cast<int>(std::lround(angle * 12 / std::numbers::pi)) * GiNaC::Pi / 12;
}

// The rotation from `turn` to the angle.
PlanarRotation missing_to(const Number& angle, const PlanarRotation& turn) {
  return planar_rotation(angle) * inverse(turn);
}

bool is_rational_turn(const PlanarRotation& turn) { return is_rational(turn.c) && is_rational(turn.s); }

class AxisAngleSnapper {
 public:
  AxisAngleSnapper(const Number& part, Robot& robot, Mechanism& mechanism)
      : part_(magnitude(part)), robot_(robot), mechanism_(mechanism) {}

  void run() {
    for (std::size_t body = 0; body < mechanism_.bodies.size(); ++body) {
      snap(body, &Body::alpha, "angle to the axis of the joint before");
      snap(body, &Body::theta, "where its angle is 0");
    }
  }

 private:
  bool is_dust(const PlanarRotation& missing) const {
    static const GiNaC::numeric kResidue = GiNaC::numeric(10).power(-kResidueDigits);
    return magnitude(missing.s) < part_ && magnitude(missing.s) > kResidue;
  }

  void snap(std::size_t index, PlanarRotation Body::*turn, const char* what) {
    const Body body = mechanism_.bodies[index];
    if (!is_rational_turn(body.*turn) || !is_rational_turn(body.theta)) return;
    const Number angle = angle_near(body.*turn);
    const PlanarRotation missing = missing_to(angle, body.*turn);
    if (!is_dust(missing)) return;
    const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&body](const Joint& each) { return each.name == body.joint; });
    // The missing rotation in the body's frame.
    const Mat3 by = turn == &Body::theta
                        ? rotation_z(missing)
                        : rotation_z(inverse(body.theta)) * rotation_x(missing) * rotation_z(body.theta);
    const Pose written = joint->origin;
    append(small_turn(in_joint_frame(by, *joint)), joint->origin);
    Mechanism turned = make_mechanism(robot_);
    const PlanarRotation left = missing_to(angle, turned.bodies[index].*turn);
    if (magnitude(left.s) > 0 && !(magnitude(left.s) < magnitude(missing.s) / 1000000)) {
      joint->origin = written;
      return;
    }
    mechanism_ = std::move(turned);
    record(*joint, what, angle, missing, written.displacements.size());
  }

  Mat3 in_joint_frame(const Mat3& by, const Joint& joint) const {
    const Mat3& link = mechanism_.links[static_cast<std::size_t>(joint.child)].R;
    const Mat3 frame = link * transpose(exact_rotation(joint.link_offset));
    return expanded(transpose(frame) * by * frame);
  }

  static void append(const std::vector<Displacement>& turns, Pose& pose) {
    pose.displacements.insert(pose.displacements.end(), turns.begin(), turns.end());
  }

  void record(const Joint& joint, const char* what, const Number& angle, const PlanarRotation& missing,
              std::size_t first) {
    constexpr int kDigitsReported = 50;
    // The sine of so small an angle is the angle.
    const Number difference = exact_decimal(to_decimal(missing.s, kDigitsReported));
    const auto index = static_cast<std::size_t>(&joint - robot_.joints.data());
    robot_.snaps.push_back({joint.place, fmt::format("joint \"{}\", {}", joint.name, what),
                            fmt::format("{}", nearest_double(angle - difference)), angle, difference, Snap::Kind::angle,
                            [index, first](Robot& robot) {
                              for (std::size_t k = 0; k < 3; ++k) {
                                robot.joints[index].origin.displacements[first + k].angle = 0;
                              }
                            }});
  }

  const GiNaC::numeric part_;
  Robot& robot_;
  Mechanism& mechanism_;
};

}  // namespace

void snap_axis_angles(const Number& part, Robot& robot, Mechanism& mechanism) {
  AxisAngleSnapper(part, robot, mechanism).run();
}

}  // namespace flatdyn
