// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/manipulability/workspace_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "support/robot_models.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

using testing::model_of_toml;

std::string two_links(const std::string& limits) {
  std::string text = "name = \"planar_2r\"\ndh = \"standard\"\n";
  for (const auto& [joint, length] : {std::pair{"shoulder", "1"}, std::pair{"elbow", "0.6"}}) {
    text += std::string("[[link]]\njoint = \"") + joint + "\"\na = " + length + "\nmass = 1\n";
    if (joint == std::string("elbow")) text += limits;
  }
  return text;
}

class WorkspaceMap : public ::testing::Test {
 protected:
  std::vector<Eigen::VectorXd> places(const LoadedRobot& model, bool holds_orientation = false) {
    tip.emplace(model.robot);
    WorkspaceGrid grid{Eigen::Matrix<double, 3, 2>::Identity(), kSpacing, holds_orientation};
    return map_workspace(*tip, model.mechanism, kStart, grid);
  }

  static constexpr double kSpacing = 0.05;
  const Eigen::Vector2d kStart = {0.2, 1};
  std::optional<TipKinematics> tip;
};

// The annulus between 0.4 and 1.6 m has this many places on the grid, and the tip is at a different one each time.
void expect_annulus(const TipKinematics& tip, const std::vector<Eigen::VectorXd>& q, double spacing) {
  const Eigen::Vector3d start = tip.pose(q.front()).p;
  std::set<std::pair<long, long>> cells;
  for (const Eigen::VectorXd& each : q) {
    const Eigen::Vector3d way = (tip.pose(each).p - start) / spacing;
    EXPECT_NEAR(way.z(), 0, 1e-6);
    EXPECT_NEAR(way.x(), std::round(way.x()), 1e-6);
    EXPECT_NEAR(way.y(), std::round(way.y()), 1e-6);
    EXPECT_TRUE(cells.emplace(std::lround(way.x()), std::lround(way.y())).second);
  }
  long inside = 0;
  for (int i = -kFarthestCell; i <= kFarthestCell; ++i) {
    for (int j = -kFarthestCell; j <= kFarthestCell; ++j) {
      const double r = (start + spacing * Eigen::Vector3d(i, j, 0)).norm();
      const bool is_clear = std::abs(r - 0.4) > 1e-3 && std::abs(r - 1.6) > 1e-3;
      if (!is_clear) continue;
      const bool is_reachable = 0.4 < r && r < 1.6;
      EXPECT_EQ(cells.count({i, j}), is_reachable ? 1U : 0U) << i << ", " << j << ": " << r;
      inside += is_reachable;
    }
  }
  EXPECT_NEAR(static_cast<double>(inside) * spacing * spacing, std::numbers::pi * (1.6 * 1.6 - 0.4 * 0.4), 0.1);
}

TEST_F(WorkspaceMap, IsAllThatTheTipGetsTo) {
  const std::vector<Eigen::VectorXd> q = places(model_of_toml(two_links("")));
  expect_annulus(*tip, q, kSpacing);
  EXPECT_EQ(q.front(), kStart);
}

// With balls for hinges the tip gets to the same places, and postures stay quaternions.
TEST_F(WorkspaceMap, TurnsBalls) {
  std::string text = "name = \"balls\"\n";
  for (const char* place : {"[0, 0, 0]", "[1, 0, 0]"}) {
    text += std::string("[[link]]\ntype = \"spherical\"\nmass = 1\nxyz = ") + place + "\n";
  }
  const LoadedRobot model = model_of_toml(text + "[tip]\nlink = \"link2\"\nxyz = [0.6, 0, 0]\n");
  tip.emplace(model.robot);
  Eigen::VectorXd start(8);
  start << std::cos(0.1), 0, 0, std::sin(0.1), std::cos(0.5), 0, 0, std::sin(0.5);
  const std::vector<Eigen::VectorXd> q =
      map_workspace(*tip, model.mechanism, start, {Eigen::Matrix<double, 3, 2>::Identity(), kSpacing});
  expect_annulus(*tip, q, kSpacing);
  for (const Eigen::VectorXd& each : q) {
    EXPECT_NEAR(each.head<4>().norm(), 1, 1e-14);
    EXPECT_NEAR(each.tail<4>().norm(), 1, 1e-14);
  }
}

TEST_F(WorkspaceMap, StaysWithinLimits) {
  const LoadedRobot model =
      model_of_toml(two_links("limits = { lower = 0.5, upper = 1.5, velocity = 1, effort = 1 }\n"));
  const std::vector<Eigen::VectorXd> q = places(model), all = places(model_of_toml(two_links("")));
  EXPECT_GT(q.size(), 100U);
  EXPECT_LT(q.size(), all.size() * 3 / 4);
  for (const Eigen::VectorXd& each : q) {
    EXPECT_TRUE(is_within_limits(model.mechanism, each));
    EXPECT_GE(each[1], 0.5);
    EXPECT_LE(each[1], 1.5);
  }
  EXPECT_FALSE(is_within_limits(model.mechanism, Eigen::Vector2d(0, 1.6)));
}

// Two joints in a plane have no place beside the start at which the tip keeps its orientation.
TEST_F(WorkspaceMap, HoldsAnOrientation) { EXPECT_EQ(places(model_of_toml(two_links("")), true).size(), 1U); }

// The workspace of a gantry without limits is infinite; the map is not.
TEST_F(WorkspaceMap, EndsWhereTheWorkspaceDoesNot) {
  const LoadedRobot gantry = model_of_toml(
      "name = \"gantry\"\n[[link]]\njoint = \"x\"\ntype = \"prismatic\"\naxis = [1, 0, 0]\nmass = 1\n"
      "[[link]]\njoint = \"y\"\ntype = \"prismatic\"\naxis = [0, 1, 0]\nmass = 1\n");
  constexpr std::size_t kSide = 2 * kFarthestCell + 1;
  EXPECT_EQ(places(gantry).size(), kSide * kSide);
}

}  // namespace
}  // namespace flatdyn
