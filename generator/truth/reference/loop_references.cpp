// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/loop_references.hpp"

#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn::references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;

// The entries of the independent joints, without those of a floating base.
template <class S>
ref::VectorX<S> of_independent(const ReferencePoint<S>& at, const ref::VectorX<S>& values) {
  return values.tail(static_cast<Eigen::Index>(at.robot.independent.size()));
}

template <class S>
std::vector<S> motion_entries(const ReferencePoint<S>& at) {
  const ref::MatrixX<S> G = ref::loop_motion(at.robot, at.q);
  return one_after_the_other<S>(
      {G * of_independent(at, at.qd), G * of_independent(at, at.qdd) + ref::loop_drift(at.robot, at.q, at.qd)});
}

std::vector<double> motion_magnitude(const At& at) {
  const ref::MatrixX<double> G = ref::loop_motion_magnitude(at.robot, at.q);
  const ref::VectorX<double> rates = of_independent(at, at.qd).cwiseAbs(),
                             accelerations = of_independent(at, at.qdd).cwiseAbs();
  return one_after_the_other<double>({G * rates, G * accelerations + ref::loop_drift_magnitude(at.robot, at.q, at.qd)});
}

}  // namespace

constinit const NumericReference loop_closure =
    computed_by([](const auto& at) { return row_by_row(ref::loop_closure(at.robot, at.q)); },
                [](const At& at) { return row_by_row(ref::loop_closure_magnitude(at.robot, at.q)); });

constinit const NumericReference loop_jacobian =
    computed_by([](const auto& at) { return row_by_row(ref::loop_jacobian(at.robot, at.q)); },
                [](const At& at) { return row_by_row(ref::loop_jacobian_magnitude(at.robot, at.q)); });

constinit const NumericReference loop_step =
    computed_by([](const auto& at) { return row_by_row(ref::loop_step(at.robot, at.q)); },
                [](const At& at) { return row_by_row(ref::loop_step_magnitude(at.robot, at.q)); });

constinit const NumericReference loop_motion =
    computed_by([](const auto& at) { return motion_entries(at); }, [](const At& at) { return motion_magnitude(at); });

}  // namespace flatdyn::references
