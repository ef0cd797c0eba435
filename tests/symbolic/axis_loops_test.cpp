// SPDX-License-Identifier: GPL-2.0-or-later
// Loops that are closed by an axis on an axis: against the same mechanism cut elsewhere, in other units, and at its
// centre.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "flatdyn/reference/closed_loops.hpp"
#include "functions/planning/formulations.hpp"
#include "support/robot_models.hpp"
#include "support/spatial_loops.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using reference::VectorX;

VectorX<double> as_vector(const std::vector<double>& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

// One model with its emitted formulas.
class Cut {
 public:
  explicit Cut(const std::string& text)
      : model_(testing::model_of_toml(text)), robot_(reference_robot<double>(model_.robot, {})) {}

  const LoopClosure& loop() const { return model_.mechanism.loops.front(); }

  std::optional<VectorX<double>> closed(VectorX<double> q) const {
    if (!reference::close_loops(robot_, q, 1e-13)) return std::nullopt;
    return q;
  }

  VectorX<double> values(const char* function, const VectorX<double>& q, double rate, double acceleration) const {
    State state;
    state.q.assign(q.begin(), q.end());
    state.qd = {rate};
    state.qdd = state.tau = {acceleration};
    const auto found = GraphEvaluator<double>(derive_function(model_.mechanism, function))(state);
    return found ? as_vector(*found) : VectorX<double>();
  }

 private:
  LoadedRobot model_;
  reference::Robot<double> robot_;
};

// Where crank, rod and bar of the one cut are at the other one's positions, if the rocker can be there.
std::optional<VectorX<double>> same_position(const Cut& other, const VectorX<double>& q) {
  for (double rocker = -3; rocker < 3; rocker += 0.5) {
    VectorX<double> tried(4);
    tried << q.head(3), rocker;
    const auto closed = other.closed(tried);
    if (closed && (closed->head(3) - q.head(3)).norm() < 1e-10) return closed;
  }
  return std::nullopt;
}

// Five equations of the hinge, three of the ball: the crank feels the same, and takes rod and bar along alike.
TEST(LoopsAlongAxes, AreThoseThatAreCutAtAnotherJoint) {
  const Cut hinge(testing::kCutAtHinge), ball(testing::kCutAtBall);
  EXPECT_EQ(hinge.loop().rows.size(), 5U);
  EXPECT_EQ(ball.loop().rows.size(), 3U);
  VectorX<double> assembled(6);
  assembled << 0.5, 0.196, -1.627, -0.14, 0.616, -1.179;
  for (const double crank : {0.4, 0.5, 0.55}) {
    assembled[0] = crank;
    const auto q = hinge.closed(assembled);
    ASSERT_TRUE(q);
    const auto same = same_position(ball, *q);
    ASSERT_TRUE(same);
    for (const char* function :
         {"inertia_matrix", "gravity", "bias", "coriolis_matrix", "inverse_dynamics", "forward_dynamics"}) {
      const VectorX<double> a = hinge.values(function, *q, 1.3, -0.7), b = ball.values(function, *same, 1.3, -0.7);
      ASSERT_EQ(a.size(), 1) << function;
      EXPECT_NEAR(a[0], b[0], 1e-12 * (1 + std::abs(b[0]))) << function;
    }
    const VectorX<double> a = hinge.values("loop_motion", *q, 1.3, -0.7),
                          b = ball.values("loop_motion", *same, 1.3, -0.7);
    EXPECT_LT((a.head(3) - b.head(3)).norm(), 1e-12 * b.norm());
    EXPECT_LT((a.segment(6, 3) - b.segment(4, 3)).norm(), 1e-12 * b.norm());
  }
}

// Lengths a thousand times smaller make the rows of points small beside those of axes, and the loop no more singular.
TEST(LoopsAlongAxes, AreNoMoreSingularWhenSmall) {
  std::string text = testing::kCutAtHinge;
  text.insert(text.find("[[link]]"), "lengths = \"mm\"\n");
  const Cut large(testing::kCutAtHinge), small(text);
  VectorX<double> q(6);
  q << 0.5, 0.196, -1.627, -0.14, 0.616, -1.179;
  const VectorX<double> a = large.values("loop_motion", *large.closed(q), 1, 0),
                        b = small.values("loop_motion", *small.closed(q), 1, 0);
  ASSERT_EQ(b.size(), 12);
  EXPECT_LT((a - b).norm(), 1e-9 * a.norm());
}

Eigen::Vector3d turned(double x, double y, double z, double angle, const Eigen::Vector3d& v) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(x, y, z).normalized()) * v;
}

// Between the coupler's axis and the rocker's where they meet, as the links are written.
double sine_between_axes(const VectorX<double>& q) {
  const Eigen::Vector3d coupler = turned(0, 0, 1, q[0], turned(0.5, 0, 1, q[1], Eigen::Vector3d(0, 0.5, 1))),
                        rocker = turned(0.6, 0, 1, q[2], Eigen::Vector3d(0, 0.3, 0.7));
  return coupler.normalized().cross(rocker.normalized()).norm();
}

// Moved to the centre, the cut leaves two equations, of directions.
TEST(LoopsAlongAxes, HaveTwoEquationsWhereAllGoThroughOnePoint) {
  const Cut cut(testing::kSphericalFourBar);
  EXPECT_EQ(cut.loop().rows, (std::vector<std::size_t>{3, 4}));
  VectorX<double> q(3);
  for (const double crank : {0.5, 0.9, 2.0}) {
    q << crank, 1, 1;
    const auto closed = cut.closed(q);
    ASSERT_TRUE(closed) << crank;
    EXPECT_LT(sine_between_axes(*closed), 1e-12);
    constexpr double kStep = 1e-6;
    const VectorX<double> rates = cut.values("loop_motion", *closed, 1, 0).head(3);
    EXPECT_LT(sine_between_axes(*closed + kStep * rates), 100 * kStep * kStep);
  }
}

}  // namespace
}  // namespace flatdyn
