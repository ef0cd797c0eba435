// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/as_read_bodies.hpp"

#include <map>

#include "truth/definition/as_read.hpp"
#include "truth/definition/quadratic_form.hpp"

namespace flatdyn {
namespace {

using Real = Digits100;
using RealForm = QuadraticForm<Real>;
using RealPose = Pose3<Real>;

Real magnitudes_of(const Vector3<Real>& v) { return abs(v[0]) + abs(v[1]) + abs(v[2]); }

class BodyComparison {
 public:
  BodyComparison(const BothSides& sides, Differences& differences)
      : sides_(sides), map_(sides.mechanism.symbols, sides.arithmetic), differences_(differences) {}

  void run() {
    std::map<int, Sum> bodies;  // by body, -1: the base
    std::vector<Sum> links(sides_.robot.links.size());
    const int base = sides_.mechanism.base_bodies() - 1;
    bodies[base] = {};
    const auto add_to_link = [&](int link, const WrittenBody<Real>& body) {
      add(identity_pose<Real>(), body, links[static_cast<std::size_t>(link)]);
      add(RealPose{place(link).R, place(link).p}, body, bodies[place(link).body]);
    };
    for (std::size_t l = 0; l < sides_.robot.links.size(); ++l) {
      for (const Inertial& inertial : sides_.robot.links[l].inertials)
        add_to_link(static_cast<int>(l), body_of(inertial));
    }
    for (const int j : sides_.moving) {
      const Joint& joint = sides_.robot.joints[static_cast<std::size_t>(j)];
      if (joint.motor) add_to_link(carrier_of(joint), body_of(*joint.motor));
    }
    compare_form("the base: its",
                 base < 0 ? sides_.found.base : sides_.found.bodies[static_cast<std::size_t>(base)].inertia,
                 bodies[base]);
    for (std::size_t i = 0; i < sides_.moving.size(); ++i) {
      compare_form(
          "what joint \"" + sides_.robot.joints[static_cast<std::size_t>(sides_.moving[i])].name + "\" moves: its",
          sides_.found.bodies[sides_.last_bodies[i]].inertia, bodies[static_cast<int>(sides_.last_bodies[i])]);
    }
    for (std::size_t l = 0; l < links.size(); ++l) {
      const InertialParameters& own = sides_.mechanism.links[l].inertia;
      const auto vector = [this](const Vec3& v) { return Vector3<Real>{map_(v[0]), map_(v[1]), map_(v[2])}; };
      compare_form("link \"" + sides_.robot.links[l].name + "\": its",
                   {map_(own.mass),
                    vector(own.first_moment),
                    {vector(own.inertia[0]), vector(own.inertia[1]), vector(own.inertia[2])}},
                   links[l]);
    }
  }

 private:
  const FieldFrame<Real>& place(int link) const { return sides_.found.links[static_cast<std::size_t>(link)]; }

  // The sum of the forms of all that moves with a body, or is fixed to one link, and the scales of its rounding.
  struct Sum {
    RealForm form = {};
    Real mass = 0, inertia = 0;
  };

  void add(const RealPose& frame, const WrittenBody<Real>& body, Sum& sum) const {
    WrittenBody<Real> placed = body;
    placed.frame = composed(frame, body.frame);
    add_body(placed, sum.form);
    sum.mass += abs(body.mass);
    for (const Vector3<Real>& row : body.tensor) sum.inertia += magnitudes_of(row);
  }

  WrittenBody<Real> body_of(const Inertial& inertial) const {
    WrittenBody<Real> body{pose_over(sides_.numbers, inertial.frame), sides_.numbers.number(inertial.mass.number),
                           vector_over(sides_.numbers, inertial.centre_of_mass),
                           matrix_over(sides_.numbers, inertial.tensor)};
    if (inertial.about == Inertial::About::frame_origin) return body;
    body.frame.p = plus(body.frame.p, times(body.frame.R, body.centre));
    body.centre = {0, 0, 0};
    return body;
  }

  // A rotor held still: I_t 1 + (I_m - I_t) z zᵀ about its centre of mass.
  WrittenBody<Real> body_of(const Motor& motor) const {
    const Vector3<Real> z = sides_.numbers.unit(motor.axis);
    const Real across = sides_.numbers.number(motor.inertia_transverse.number),
               along = sides_.numbers.number(motor.inertia_axial.number);
    WrittenBody<Real> body{identity_pose<Real>(), sides_.numbers.number(motor.mass.number), {0, 0, 0}, {}};
    body.frame.p = vector_over(sides_.numbers, motor.position);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) body.tensor[i][j] = (along - across) * z[i] * z[j];
      body.tensor[i][i] += across;
    }
    return body;
  }

  void compare_form(const std::string& subject, const FieldInertia<Real>& found, const Sum& expected) {
    RealForm form = {};
    add_body({identity_pose<Real>(), found.mass, {0, 0, 0}, found.inertia}, form);
    const Vector3<Real>& h = found.first_moment;
    const Matrix3<Real> S = {Vector3<Real>{0, -h[2], h[1]}, Vector3<Real>{h[2], 0, -h[0]},
                             Vector3<Real>{-h[1], h[0], 0}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) form[i][j + 3] = form[j + 3][i] = -S[i][j];
    }
    const Real scales[] = {expected.mass, expected.mass * sides_.reach,
                           expected.mass * sides_.reach * sides_.reach + expected.inertia};
    static const char* const kNames[] = {" mass", " first moment", " inertia"};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        const std::size_t kind = i / 3 + j / 3;
        differences_.compare(subject + kNames[kind], form[i][j], expected.form[i][j], scales[kind]);
      }
    }
  }

  const BothSides& sides_;
  NumberMap<RealArithmetic<Real>> map_;
  Differences& differences_;
};

}  // namespace

void compare_bodies(const BothSides& sides, Differences& differences) { BodyComparison(sides, differences).run(); }

}  // namespace flatdyn
