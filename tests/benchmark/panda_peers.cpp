// SPDX-License-Identifier: GPL-2.0-or-later
#include <vector>

#include "benchmark/harness.hpp"
#include "flatdyn/reference/newton_euler.hpp"
#include "functions/load/load_robot.hpp"
#include "truth/reference/reference_model.hpp"
#ifdef FLATDYN_KDL
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "support/kdl_chain.hpp"
#endif

namespace flatdyn {
namespace {

using Vector = reference::VectorX<double>;

const reference::Robot<double>& robot() {
  static const reference::Robot<double> panda =
      reference_robot<double>(load_robot(FLATDYN_SOURCE_DIR "/robots/panda.urdf", {}).robot, {});
  return panda;
}

std::vector<Vector> vectors(const States& states) {
  std::vector<Vector> result;
  for (std::size_t k = 0; k < kStates; ++k) result.push_back(Eigen::Map<const Vector>(states.of(k), kJoints));
  return result;
}

void add_reference() {
  static const std::vector<Vector> q_ = vectors(q()), qd_ = vectors(qd()), qdd_ = vectors(qdd());
  add("inverse_dynamics/reference", [](benchmark::State& s) {
    run(s,
        [](std::size_t k) { benchmark::DoNotOptimize(reference::inverse_dynamics(robot(), q_[k], qd_[k], qdd_[k])); });
  });
  add("inertia_matrix/reference", [](benchmark::State& s) {
    run(s, [](std::size_t k) { benchmark::DoNotOptimize(reference::inertia_matrix(robot(), q_[k])); });
  });
}

#ifdef FLATDYN_KDL
std::vector<KDL::JntArray> kdl_arrays(const States& states) {
  std::vector<KDL::JntArray> result;
  for (const Vector& v : vectors(states)) result.push_back(testing::kdl(v));
  return result;
}

void add_kdl() {
  static const KDL::Chain chain = testing::kdl_chain(robot());
  static const KDL::Vector g = testing::kdl(robot().gravity);
  static const KDL::Wrenches none(chain.getNrOfSegments(), KDL::Wrench::Zero());
  static const std::vector<KDL::JntArray> q_ = kdl_arrays(q()), qd_ = kdl_arrays(qd()), qdd_ = kdl_arrays(qdd());
  add("inverse_dynamics/kdl", [](benchmark::State& s) {
    KDL::ChainIdSolver_RNE solver(chain, g);
    KDL::JntArray tau(kJoints);
    run(s, [&](std::size_t k) { solver.CartToJnt(q_[k], qd_[k], qdd_[k], none, tau); });
  });
  add("inertia_matrix/kdl", [](benchmark::State& s) {
    KDL::ChainDynParam solver(chain, g);
    KDL::JntSpaceInertiaMatrix B(kJoints);
    run(s, [&](std::size_t k) { solver.JntToMass(q_[k], B); });
  });
  add("gravity/kdl", [](benchmark::State& s) {
    KDL::ChainDynParam solver(chain, g);
    KDL::JntArray torque(kJoints);
    run(s, [&](std::size_t k) { solver.JntToGravity(q_[k], torque); });
  });
  add("forward_dynamics/kdl", [](benchmark::State& s) {
    KDL::ChainFdSolver_RNE solver(chain, g);
    KDL::JntArray found(kJoints);
    run(s, [&](std::size_t k) { solver.CartToJnt(q_[k], qd_[k], qdd_[k], none, found); });
  });
}
#endif

}  // namespace

void add_peers() {
  add_reference();
#ifdef FLATDYN_KDL
  add_kdl();
#endif
}

}  // namespace flatdyn
