// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of the motions of links, against observed values.
#include "proof/certify/motion_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "graph/arithmetic.hpp"
#include "support/fast_states.hpp"
#include "support/limited_robots.hpp"

namespace flatdyn {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSmall = 1e-9;  // slack for the rounding of observed values

class MotionsOfLinks {
 public:
  explicit MotionsOfLinks(const Mechanism& mechanism) {
    RealArithmetic<double> numbers([](const Input&) { return 0.0; });
    mechanism_ = mechanism_over(mechanism, numbers);
    base_bodies_ = mechanism.base_bodies();
  }

  std::vector<FieldMotion<double>> operator()(const State& state) const {
    MechanismOver<double> here = mechanism_;
    if (base_bodies_ > 0) here.gravity = {state.g_b[0], state.g_b[1], state.g_b[2]};
    return field_motions(here, points(state), state.qd, state.qdd, base_bodies_);
  }
  // The vectors (u, u × r) of a joint's axis, one per link.
  std::vector<FieldMotion<double>> of_joint(const State& state, int joint) const {
    MechanismOver<double> weightless = mechanism_;
    weightless.gravity = {0, 0, 0};
    std::vector<double> rest(state.qd.size(), 0.0), alone = rest;
    alone[static_cast<std::size_t>(joint)] = 1;
    return field_motions(weightless, points(state), rest, alone, base_bodies_);
  }

 private:
  std::vector<JointPoint<double>> points(const State& state) const {
    std::vector<JointPoint<double>> result(static_cast<std::size_t>(base_bodies_));
    for (const double q : state.q) result.push_back({std::cos(q), std::sin(q)});
    return result;
  }

  MechanismOver<double> mechanism_;
  int base_bodies_ = 0;
};

// The bodies that are links: of the motion of a floating base, the last.
int first_link(const Mechanism& mechanism) { return std::max(0, mechanism.base_bodies() - 1); }

MatrixXd random_rows(int rows, int columns, std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(engine); });
}

VectorXd vector_of(const std::vector<double>& entries) {
  return VectorXd::Map(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

class BoundsOfMotions : public ::testing::TestWithParam<const char*> {
 protected:
  const Mechanism mechanism_ = testing::limited_robot(GetParam());
  const MotionBounds bounds_{mechanism_, input_limits(mechanism_)};
  const MotionsOfLinks motions_{mechanism_};
  std::mt19937 random_{1};
};

TEST_P(BoundsOfMotions, AreAboveAllThatLinksDo) {
  const std::vector<State> states = testing::fast_states(mechanism_, 400);
  for (int link = first_link(mechanism_); link < mechanism_.size(); ++link) {
    for (int rows = 1; rows <= 3; ++rows) {
      // Only some rows are used, so that none hides the others.
      MatrixXd M = random_rows(rows, MotionBasis::kSize, random_);
      for (Eigen::Index k = 0; k < M.cols(); ++k) M.col(k) *= random_() % 3 == 0 ? 1 : 0;
      double seen = 0;
      for (const State& state : states) {
        const auto motion = motions_(state)[static_cast<std::size_t>(link)];
        seen = std::max(seen, (M * vector_of(entries_of(motion))).norm());
      }
      EXPECT_LE(seen, bounds_.of_motion(link, M) + kSmall) << "link " << link;
      EXPECT_LE(bounds_.of_motion(link, M), 10 * seen + kSmall) << "link " << link;
    }
  }
}

TEST_P(BoundsOfMotions, AreAboveWhatOneJointDoes) {
  const std::vector<State> states = random_states(mechanism_, 400, 2);
  for (int link = first_link(mechanism_); link < mechanism_.size(); ++link) {
    for (int joint = link; joint >= 0; joint = mechanism_.bodies[static_cast<std::size_t>(joint)].parent) {
      const MatrixXd M = random_rows(1 + link % 3, MotionBasis::kSizeOfAxis, random_);
      double seen = 0;
      for (const State& state : states) {
        const FieldMotion<double> motion = motions_.of_joint(state, joint)[static_cast<std::size_t>(link)];
        VectorXd axis(MotionBasis::kSizeOfAxis);
        axis << vector_of({motion.domega.begin(), motion.domega.end()}),
            vector_of({motion.ddp.begin(), motion.ddp.end()});
        seen = std::max(seen, (M * axis).norm());
      }
      EXPECT_LE(seen, bounds_.of_axis(joint, link, M) + kSmall) << "joint " << joint << ", link " << link;
      // The axes of a base reach a link near it in few directions.
      const double loosest = mechanism_.floating_base ? 8 : 3;
      EXPECT_LE(bounds_.of_axis(joint, link, M), loosest * seen + kSmall) << "joint " << joint << ", link " << link;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, BoundsOfMotions,
                         ::testing::Values("panda.urdf", "rx90.toml", "planar_2r_example_7_2.toml", "humanoid32.urdf",
                                           "floating quadruped12.urdf", "floating rx90.toml"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace flatdyn
