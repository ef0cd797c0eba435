// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/centroidal_references.hpp"

#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn::references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

// The robot whose links alone have momentum: the armature of a floating base has no part in it.
template <class S>
ref::Robot<S> links_of(const ReferencePoint<S>& at) {
  ref::Robot<S> links = at.robot;
  links.base_armature = S(0);
  return links;
}

template <class S>
struct WholeRobot {
  S mass = S(0);
  ref::Vector3<S> centre = ref::Vector3<S>::Zero();
};

// Link by link, from the written bodies.
template <class S>
WholeRobot<S> whole_robot(const ReferencePoint<S>& at) {
  WholeRobot<S> result;
  const std::vector<ref::Pose<S>> poses = ref::link_poses(at.robot, at.q);
  for (std::size_t l = 0; l < at.robot.links.size(); ++l) {
    for (const ref::Inertial<S>& body : at.robot.links[l].inertials) {
      result.mass += body.mass;
      result.centre += body.mass * (poses[l].p + poses[l].R * body.r_C);
    }
  }
  result.centre /= result.mass;
  return result;
}

// Moves the moments in rows 3 to 5 from the base frame's origin to the centre of mass.
template <class S>
void move_to_centre(const ref::Vector3<S>& centre, ref::MatrixX<S>& rows) {
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    const ref::Vector3<S> f = rows.col(k).template head<3>();
    rows.col(k).template tail<3>() -= centre.cross(f);
  }
}

template <class S>
std::vector<S> momentum_matrix(const ReferencePoint<S>& at) {
  ref::MatrixX<S> A = ref::inertia_matrix(links_of(at), at.q).topRows(6);
  move_to_centre(whole_robot(at).centre, A);
  return row_by_row(A);
}

template <class S>
std::vector<S> momentum_bias(const ReferencePoint<S>& at) {
  const ref::VectorX<S> none = ref::VectorX<S>::Zero(at.robot.size());
  ref::MatrixX<S> b =
      ref::inverse_dynamics(links_of(at), at.q, at.qd, none, {.gravity = false, .friction = false, .springs = false})
          .head(6);
  move_to_centre(whole_robot(at).centre, b);
  return row_by_row(b);
}

template <class S>
std::vector<S> centre(const ReferencePoint<S>& at) {
  const WholeRobot<S> robot = whole_robot(at);
  std::vector<S> entries(robot.centre.data(), robot.centre.data() + 3);
  const ref::MatrixX<S> J = ref::inertia_matrix(links_of(at), at.q).topRows(3) / robot.mass;
  const std::vector<S> more = row_by_row(J);
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

// The size of the centre's terms: B's entries of turns about the base's origin, per mass.
double length_of_centre(const At& at) {
  const WholeRobot<double> robot = whole_robot(at);
  return ref::inertia_magnitude(links_of(at), at.q).topRows(3).middleCols<3>(3).maxCoeff() / std::abs(robot.mass);
}

// The same with magnitudes: moments, and forces times the length.
ref::MatrixX<double> about_centre(double length, ref::MatrixX<double> rows) {
  for (Eigen::Index k = 0; k < rows.cols(); ++k) rows.col(k).tail<3>().array() += length * rows.col(k).head<3>().sum();
  return rows;
}

std::vector<double> momentum_magnitude(const At& at) {
  return row_by_row(about_centre(length_of_centre(at), ref::inertia_magnitude(links_of(at), at.q).topRows(6)));
}

std::vector<double> bias_magnitude(const At& at) {
  const ref::VectorX<double> none = ref::VectorX<double>::Zero(at.robot.size());
  const ref::MatrixX<double> n =
      ref::torque_magnitude(links_of(at), at.q, at.qd, none, {.gravity = false, .friction = false, .springs = false})
          .head(6);
  return row_by_row(about_centre(length_of_centre(at), n));
}

std::vector<double> centre_magnitude(const At& at) {
  std::vector<double> entries(3, length_of_centre(at));
  const ref::MatrixX<double> J = ref::inertia_magnitude(links_of(at), at.q).topRows(3) / std::abs(whole_robot(at).mass);
  const std::vector<double> more = row_by_row(J);
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

}  // namespace

constinit const NumericReference centroidal_momentum_matrix = computed_by(
    [](const auto& at) { return momentum_matrix(at); }, [](const At& at) { return momentum_magnitude(at); });

constinit const NumericReference centroidal_bias =
    computed_by([](const auto& at) { return momentum_bias(at); }, [](const At& at) { return bias_magnitude(at); });

constinit const NumericReference centre_of_mass =
    computed_by([](const auto& at) { return centre(at); }, [](const At& at) { return centre_magnitude(at); });

}  // namespace flatdyn::references
