// SPDX-License-Identifier: GPL-2.0-or-later
// Random robots, from file to emitted text and compiled code, against the recursive reference and, without rotors and
// friction, against Orocos KDL (chains), MuJoCo (trees) and, where it is installed, DART (all). More of them, against
// the reference: flatdyn stress --family random --robots 100000 --seed 1001.
#include <gtest/gtest.h>

#include "functions/deviation/expected.hpp"
#include "functions/function_table.hpp"
#include "laboratory/stress/random_robots.hpp"
#include "report/random_robots_report.hpp"
#include "support/kdl_chain.hpp"
#include "support/mujoco_tree.hpp"
#ifdef FLATDYN_DART
#include "support/dart_tree.hpp"
#endif

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
  const char* library;
  std::unique_ptr<JointDynamicsPeer> (*peer)(const reference::Robot<double>&);
  bool (*knows)(const Robot&);
  bool rounds_by_the_largest_entry;
  int least;         // number of comparisons that there are at least
  double bound;      // of scaled differences
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

std::vector<Witness> witnesses() {
  const auto moves_by_joints = [](const Robot& robot) { return !is_chain(robot) && !has_quasi_velocities(robot); };
  std::vector<Witness> all = {
      {"KDL", make_peer<testing::KdlChainPeer>, is_for_kdl, false, 1000, 16},
      {"MuJoCo", make_peer<testing::MujocoTree>, moves_by_joints, true, 150, 16},
      {"MuJoCo, quasi-velocities", make_peer<testing::MujocoTree>, has_quasi_velocities, true, 1000, 16}};
#ifdef FLATDYN_DART
  const auto has_rates = [](const Robot& robot) { return !has_quasi_velocities(robot); };
  all.push_back({"DART", make_peer<testing::DartTree>, has_rates, false, 1000, 8});
  all.push_back({"DART, quasi-velocities", make_peer<testing::DartTree>, has_quasi_velocities, false, 1000, 8});
#endif
  return all;
}

// The report of random robots that the witnesses see, too.
RandomRobotsReport witnessed(RandomRobotsOptions options, std::vector<Witness>& all) {
  options.witness = [&all](const RandomRobotValues& values) {
    double largest = 0;
    for (Witness& witness : all) largest = std::max(largest, witness.difference(values));
    return largest;
  };
  Progress quiet(true);
  const RandomRobotsReport report = stress_random_robots(options, quiet);
  EXPECT_TRUE(report.passed()) << random_robots_text(report);
  EXPECT_EQ(report.robots, options.robots);
  for (const Witness& witness : all) EXPECT_LE(witness.worst, witness.bound) << witness.library;
  return report;
}

TEST(RandomRobots, AFewAgreeWithTheReferenceAndWithOtherLibraries) {
  RandomRobotsOptions options;
  options.robots = 16;
  options.compiled_one_in = 1000;
  std::vector<Witness> all = witnesses();
  witnessed(options, all);
}

TEST(RandomRobots, AThousandAgreeWithTheReferenceAndWithOtherLibraries) {
  std::vector<Witness> all = witnesses();
  const RandomRobotsReport report = witnessed({}, all);
  EXPECT_EQ(report.compiled, 100);
  for (const Witness& witness : all) {
    EXPECT_GT(witness.compared, witness.least) << witness.library;
    EXPECT_GT(witness.worst, 0) << witness.library;
  }
  for (const double worst : report.worst) {
    EXPECT_GT(worst, 0);
    EXPECT_LE(worst, 32);
  }
}

}  // namespace
}  // namespace flatdyn
