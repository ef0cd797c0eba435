// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/manipulability/workspace_map.hpp"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <optional>
#include <set>
#include <utility>

#include "robot/model/number.hpp"

namespace flatdyn {
namespace {

using Cell = std::pair<int, int>;

struct Reached {
  Cell cell;
  Eigen::VectorXd q;
};

std::optional<Eigen::VectorXd> reached(const TipKinematics& tip, const Mechanism& mechanism, const TipGoal& goal,
                                       const Eigen::VectorXd& guess) {
  try {
    Eigen::VectorXd q = inverse_kinematics(tip, goal, guess);
    if (is_within_limits(mechanism, q)) return q;
  } catch (const Unreachable&) {  // being out of reach is a valid answer
  }
  return std::nullopt;
}

}  // namespace

bool is_within_limits(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  for (int p = 0; p < mechanism.position_count(); ++p) {
    if (mechanism.is_of_quaternion(p)) continue;  // spherical joints have no limits of position
    const Body& body = mechanism.joint_at(p);
    const double position = q[p];
    if (body.limits.lower && position < nearest_double(body.limits.lower->number)) return false;
    if (body.limits.upper && position > nearest_double(body.limits.upper->number)) return false;
  }
  return true;
}

std::vector<Eigen::VectorXd> map_workspace(const TipKinematics& tip, const Mechanism& mechanism,
                                           const Eigen::VectorXd& start, const WorkspaceGrid& grid) {
  const reference::Pose<double> origin = tip.pose(start);
  std::set<Cell> known = {{0, 0}};
  std::deque<Reached> front = {{{0, 0}, start}};
  std::vector<Eigen::VectorXd> places;
  while (!front.empty()) {
    const Reached here = std::move(front.front());
    front.pop_front();
    places.push_back(here.q);
    for (const Cell& step : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
      const Cell next = {here.cell.first + step.first, here.cell.second + step.second};
      const bool is_near = std::max(std::abs(next.first), std::abs(next.second)) <= kFarthestCell;
      if (!is_near || known.count(next) > 0) continue;
      TipGoal goal{origin.p + grid.spacing * (grid.directions * Eigen::Vector2d(next.first, next.second)), {}};
      if (grid.holds_orientation) goal.R = origin.R;
      if (auto q = reached(tip, mechanism, goal, here.q)) {
        known.insert(next);
        front.push_back({next, std::move(*q)});
      }
    }
  }
  return places;
}

}  // namespace flatdyn
