// SPDX-License-Identifier: GPL-2.0-or-later
// Random robots, from file to emitted text and compiled code, against the recursive reference and, without rotors and
// friction, against Orocos KDL (chains) and MuJoCo (trees). More of them, against the reference: flatdyn stress
// --family random --robots 100000 --seed 1001.
#include <gtest/gtest.h>

#include "deviation/expected.hpp"
#include "functions/function_table.hpp"
#include "report/random_robots_report.hpp"
#include "stress/random_robots.hpp"
#include "support/kdl_chain.hpp"
#include "support/mujoco_tree.hpp"

namespace flatdyn {
namespace {

using testing::JointDynamicsPeer;
using Vector = JointDynamicsPeer::Vector;

bool is_chain(const Robot& robot) {
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    if (robot.joints[k].parent != static_cast<int>(k)) return false;
  }
  return true;
}

// Peers define rotors and friction differently.
bool is_for_peers(const Robot& robot) {
  return std::none_of(robot.joints.begin(), robot.joints.end(), [](const Joint& joint) {
    return joint.motor || !vanishes(joint.viscous.number) || !vanishes(joint.coulomb.number);
  });
}

bool has_quasi_velocities(const Robot& robot) {
  return robot.floating_base || std::any_of(robot.joints.begin(), robot.joints.end(),
                                            [](const Joint& joint) { return joint.type == JointType::spherical; });
}

bool is_for_kdl(const Robot& robot) { return is_chain(robot) && !has_quasi_velocities(robot); }

// A peer's values of a function of the table at the state. Peers do not know coupled joints: they are given the motion
// of all joints, and A transforms the result to the coordinates.
std::vector<double> values_of(JointDynamicsPeer& peer, const reference::Robot<double>& robot,
                              const std::string& function, const State& state) {
  const Vector q = vector_of(state.q);
  Vector room;
  const Vector positions = reference::of_joints<double>(robot, q, room);
  const auto given = [&](const std::vector<double>& v) {
    return Vector(reference::rates_of_joints<double>(robot, q, vector_of(v), room));
  };
  if (function == "inertia_matrix") {
    const JointDynamicsPeer::Matrix B = peer.inertia_matrix(positions);
    if (robot.coupling.size() == 0) return row_by_row(B);
    const JointDynamicsPeer::Matrix A = reference::rate_coupling(robot);
    return row_by_row(JointDynamicsPeer::Matrix(A.transpose() * B * A));
  }
  if (function == "forward_dynamics") {
    const Vector qdd = peer.forward_dynamics(positions, given(state.qd), given(state.tau));
    return {qdd.begin(), qdd.end()};
  }
  const Vector tau = function == "gravity" ? peer.gravity(positions)
                                           : peer.inverse_dynamics(positions, given(state.qd), given(state.qdd));
  return row_by_row(reference::at_coordinates<double>(robot, q, tau));
}

// Another library as a witness. MuJoCo rounds relative to everything that moves the whole tree, about its centre of
// mass: an entry whose own terms are all zero may contain rounding errors of other terms there.
struct Witness {
  std::unique_ptr<JointDynamicsPeer> (*peer)(const reference::Robot<double>&);
  bool (*knows)(const Robot&);
  bool rounds_by_the_largest_entry;
  int compared = 0;  // number of functions times states
  double worst = 0;  // largest scaled difference

  double difference(const RandomRobotValues& all) {
    if (!is_for_peers(all.model.robot) || !knows(all.model.robot)) return 0;
    const reference::Robot<double> robot = reference_robot<double>(all.model.robot, {});
    reference::Robot<double> at_state = robot;
    if (robot.floating_base) at_state.gravity = vector_of(all.state.g_b);
    const std::unique_ptr<JointDynamicsPeer> other = peer(at_state);
    double largest = 0;
    for (std::size_t k = 0; k < all.functions.size(); ++k) {
      const std::string& name = all.functions[k].name;
      if (robot.coupling.size() > 0 && name == "forward_dynamics") continue;
      const std::vector<double> found = values_of(*other, robot, name, all.state);
      const std::vector<Real50> truth(found.begin(), found.end());
      const NumericReference& reference = row_of(all.functions[k]).reference;
      std::vector<double> scale = reference.magnitude({all.model.mechanism, robot, {}}, all.functions[k])(all.state);
      if (rounds_by_the_largest_entry) scale.assign(scale.size(), *std::max_element(scale.begin(), scale.end()));
      largest = std::max(largest, scaled_error(all.values[k], truth, scale));
      ++compared;
    }
    worst = std::max(worst, largest);
    return largest;
  }
};

template <class Peer>
std::unique_ptr<JointDynamicsPeer> make_peer(const reference::Robot<double>& robot) {
  return std::make_unique<Peer>(robot);
}

TEST(RandomRobots, AThousandAgreeWithTheReferenceWithKdlAndWithMujoco) {
  RandomRobotsOptions options;
  const auto moves_by_joints = [](const Robot& robot) { return !is_chain(robot) && !has_quasi_velocities(robot); };
  Witness kdl{make_peer<testing::KdlChainPeer>, is_for_kdl, false};
  Witness mujoco{make_peer<testing::MujocoTree>, moves_by_joints, true};
  Witness floating{make_peer<testing::MujocoTree>, has_quasi_velocities, true};  // or with spherical joints
  options.witness = [&](const RandomRobotValues& all) {
    return std::max({kdl.difference(all), mujoco.difference(all), floating.difference(all)});
  };
  Progress quiet(true);
  const RandomRobotsReport report = stress_random_robots(options, quiet);
  EXPECT_TRUE(report.passed()) << random_robots_text(report);
  EXPECT_EQ(report.robots, 1000);
  EXPECT_EQ(report.compiled, 100);
  EXPECT_GT(kdl.compared, 1000);
  EXPECT_GT(mujoco.compared, 150);
  EXPECT_GT(floating.compared, 300);
  EXPECT_GT(kdl.worst, 0);
  EXPECT_GT(mujoco.worst, 0);
  EXPECT_GT(floating.worst, 0);
  for (const double worst : report.worst) {
    EXPECT_GT(worst, 0);
    EXPECT_LE(worst, 32);
  }
}

}  // namespace
}  // namespace flatdyn
