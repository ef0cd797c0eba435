// SPDX-License-Identifier: GPL-2.0-or-later
// Random robots, from file to emitted text and compiled code, against the recursive reference and, chains without
// rotors and friction, against Orocos KDL. More of them: flatdyn stress --family random --robots 100000 --seed 1001.
#include <gtest/gtest.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "report/random_robots_report.hpp"
#include "stress/random_robots.hpp"
#include "support/kdl_chain.hpp"
#include "verify/expected.hpp"
#include "verify/values.hpp"

namespace flatdyn {
namespace {

using testing::kdl;

bool is_for_kdl(const Robot& robot) {
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    const Joint& joint = robot.joints[k];
    if (joint.parent != static_cast<int>(k) || joint.motor) return false;
    if (!vanishes(joint.viscous.number) || !vanishes(joint.coulomb.number)) return false;
  }
  return true;
}

std::vector<double> entries_of(const KDL::JntArray& array) { return {array.data.begin(), array.data.end()}; }

// What KDL makes of a function of the table, at the state. Of coupled joints it knows nothing: it is given the motion
// of all of them, and A brings the result to the coordinates.
std::vector<double> kdl_values(const reference::Robot<double>& robot, const std::string& function, const State& state) {
  const KDL::Chain chain = testing::kdl_chain(robot);
  const KDL::Vector gravity = kdl(robot.gravity);
  reference::VectorX<double> room;
  const auto given = [&](const std::vector<double>& v) {
    return kdl(reference::of_joints<double>(robot, vector_of(v), room));
  };
  const auto joints = static_cast<unsigned>(robot.joint_count());
  const KDL::Wrenches none(chain.getNrOfSegments(), KDL::Wrench::Zero());
  KDL::JntArray result(joints);
  if (function == "inertia_matrix") {
    KDL::JntSpaceInertiaMatrix B(joints);
    KDL::ChainDynParam(chain, gravity).JntToMass(given(state.q), B);
    if (robot.coupling.size() == 0) return row_by_row(B.data);
    return row_by_row(reference::MatrixX<double>(robot.coupling.transpose() * B.data * robot.coupling));
  }
  if (function == "gravity") {
    KDL::ChainDynParam(chain, gravity).JntToGravity(given(state.q), result);
  } else if (function == "inverse_dynamics") {
    KDL::ChainIdSolver_RNE solver(chain, gravity);
    solver.CartToJnt(given(state.q), given(state.qd), given(state.qdd), none, result);
  } else {
    KDL::ChainFdSolver_RNE solver(chain, gravity);
    solver.CartToJnt(given(state.q), given(state.qd), given(state.tau), none, result);
    return entries_of(result);
  }
  return row_by_row(reference::at_coordinates<double>(robot, vector_of<double>(state.q), result.data));
}

// The largest scaled difference between the robot's values and KDL's.
double difference_from_kdl(const RandomRobotValues& all, int& compared) {
  if (!is_for_kdl(all.model.robot)) return 0;
  const reference::Robot<double> robot = reference_robot<double>(all.model.robot, {});
  double largest = 0;
  for (std::size_t k = 0; k < all.functions.size(); ++k) {
    const std::string& name = all.functions[k].name;
    if (robot.coupling.size() > 0 && name == "forward_dynamics") continue;
    const std::vector<double> peer = kdl_values(robot, name, all.state);
    const std::vector<Real50> truth(peer.begin(), peer.end());
    largest = std::max(largest, scaled_error(all.values[k], truth, magnitudes(all.functions[k], robot, all.state)));
    ++compared;
  }
  return largest;
}

TEST(RandomRobots, AThousandAgreeWithTheReferenceAndKdl) {
  RandomRobotsOptions options;
  int compared = 0;
  options.witness = [&compared](const RandomRobotValues& all) { return difference_from_kdl(all, compared); };
  Progress quiet(true);
  const RandomRobotsReport report = stress_random_robots(options, quiet);
  EXPECT_TRUE(report.passed()) << random_robots_text(report);
  EXPECT_EQ(report.robots, 1000);
  EXPECT_EQ(report.compiled, 100);
  EXPECT_GT(compared, 1000);
  EXPECT_GT(report.worst_witnessed, 0);
  for (const double worst : report.worst) {
    EXPECT_GT(worst, 0);
    EXPECT_LE(worst, 16);
  }
}

}  // namespace
}  // namespace flatdyn
