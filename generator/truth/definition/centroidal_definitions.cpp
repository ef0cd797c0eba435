// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/centroidal_definitions.hpp"

#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {
namespace {

constexpr int kLinear = 3, kTwist = 6;

// The mass of the robot, and its first moment about the base frame's origin.
template <class F>
struct WholeRobot {
  F mass = F(0);
  Vector3<F> moment = {F(0), F(0), F(0)};

  Vector3<F> centre() const { return scaled(F(1) / mass, moment); }
};

template <class Point, class F = typename Point::F>
WholeRobot<F> whole_robot(const Point& at) {
  WholeRobot<F> result;
  const MechanismOver<F>& mechanism = at.lagrangian.mechanism();
  const std::vector<Pose3<F>> poses = body_poses(mechanism, at.q);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const FieldInertia<F>& body = mechanism.bodies[i].inertia;
    result.mass += body.mass;
    result.moment = plus(result.moment, plus(scaled(body.mass, poses[i].p), times(poses[i].R, body.first_moment)));
  }
  return result;
}

// Moves the moments in rows 3 to 5 from the base frame's origin to the centre of mass: n - r_G × f.
template <class F>
void move_to_centre(const Vector3<F>& centre, Matrix<F>& rows) {
  for (int k = 0; k < rows.cols(); ++k) {
    const Vector3<F> shift = cross(centre, Vector3<F>{rows(0, k), rows(1, k), rows(2, k)});
    for (int i = 0; i < kLinear; ++i) rows(i + kLinear, k) += -shift[static_cast<std::size_t>(i)];
  }
}

template <class F>
Matrix<F> first_rows(const Matrix<F>& m, int count) {
  Matrix<F> result(count, m.cols());
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < m.cols(); ++k) result(i, k) = m(i, k);
  }
  return result;
}

// The first rows of B without the base's armature, which is a diagonal that no link has.
template <class Point, class F = typename Point::F>
Matrix<F> momentum_rows(Point& at, int count) {
  Matrix<F> result = first_rows(at.lagrangian.inertia(), count);
  for (int i = 0; i < count; ++i) {
    result(i, i) += -at.lagrangian.mechanism().bodies[static_cast<std::size_t>(i)].armature;
  }
  return result;
}

template <class Point>
auto momentum_matrix(Point& at) {
  auto A = momentum_rows(at, kTwist);
  move_to_centre(whole_robot(at).centre(), A);
  return A.entries();
}

template <class Point>
auto momentum_bias(Point& at) {
  using F = typename Point::F;
  const auto torques = times(at.coriolis_matrix(), at.qd());
  const auto turning = base_drift(at.qd());  // first ω × v, which the armature takes part in
  Matrix<F> b(kTwist, 1);
  for (int i = 0; i < kTwist; ++i) {
    const auto row = static_cast<std::size_t>(i);
    b(i, 0) = torques[row];
    if (i < kLinear) b(i, 0) += -(at.lagrangian.mechanism().bodies[row].armature * turning[row]);
  }
  move_to_centre(whole_robot(at).centre(), b);
  return b.entries();
}

template <class Point>
auto centre(Point& at, const Output& output) {
  using F = typename Point::F;
  const WholeRobot<F> robot = whole_robot(at);
  const Vector3<F> r = robot.centre();
  if (output.name == "r_G") return std::vector<F>(r.begin(), r.end());
  std::vector<F> J = momentum_rows(at, kLinear).entries();
  for (F& entry : J) entry = entry / robot.mass;
  return J;
}

// Divisions by the mass, which may have symbols.
constexpr double kDivided = 4;

template <class Generic>
constexpr Definition divided_by_mass(Generic expected) {
  return {rules(expected), kOwnValues, [](const Mechanism&, const Function&) { return kDivided; }};
}

}  // namespace

constinit const Definition centroidal_momentum_matrix =
    divided_by_mass([](auto& at, const Output&) { return momentum_matrix(at); });

constinit const Definition centroidal_bias = divided_by_mass([](auto& at, const Output&) { return momentum_bias(at); });

constinit const Definition centre_of_mass =
    divided_by_mass([](auto& at, const Output& output) { return centre(at, output); });

}  // namespace flatdyn::definitions
