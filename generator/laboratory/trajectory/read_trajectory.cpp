// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/read_trajectory.hpp"

#include "laboratory/identify/motion_stream.hpp"
#include "laboratory/trajectory/plan_motion.hpp"
#include "laboratory/trajectory/plan_reader.hpp"
#include "robot/input/common/context.hpp"

namespace flatdyn {
namespace {

// Requires the log's q̇ and q̈. A filter could compute them, but it loses the ends and smooths the steps of a plan.
void require_derivatives(const LogLayout& layout, const Place& place, Diagnostics& diagnostics) {
  if (layout.has_rates && layout.has_accelerations) return;
  diagnostics.error(place, "no columns for the joints' rates qd and accelerations qdd",
                    "what made the trajectory knows them: write qd1, ... and qdd1, ...; a TOML trajectory "
                    "(docs/trajectory-format.md) needs neither");
}

Trajectory read_samples(const std::filesystem::path& path, const Mechanism& mechanism, Diagnostics& diagnostics) {
  StreamOptions options;
  options.torques = false;
  const StreamPlan plan = plan_stream(path, mechanism, options, diagnostics);
  Trajectory trajectory;
  if (diagnostics.has_errors()) return trajectory;
  require_derivatives(plan.layout(), {path.string(), 1}, diagnostics);
  if (diagnostics.has_errors()) return trajectory;
  const LogLayout& layout = plan.layout();
  const auto numbers = [](const double* from, int count) { return std::vector<double>(from, from + count); };
  const auto add = [&](const double* channels) {
    TrajectoryPoint point{channels[LogLayout::time()],
                          {},
                          numbers(channels + layout.qd(), layout.joints),
                          numbers(channels + layout.qdd(), layout.joints),
                          {}};
    for (int i = 0; i < mechanism.size(); ++i) {
      point.q.push_back(channels[LogLayout::q() + mechanism.position_of(i)]);
    }
    if (layout.has_tip_force) point.h_e = numbers(channels + layout.h_e(), LogLayout::kWrench);
    trajectory.points.push_back(std::move(point));
  };
  stream(path, mechanism, plan, add, diagnostics);
  if (!diagnostics.has_errors()) mark_jumps(trajectory);
  return trajectory;
}

bool is_at_tip(const Posture& posture) { return std::holds_alternative<TipPosture>(posture); }

bool is_at_tip(const Segment& segment) {
  const auto* move = std::get_if<JointMove>(&segment.motion);
  return std::holds_alternative<LineMove>(segment.motion) || (move != nullptr && is_at_tip(move->to));
}

// Refuses moves of the tip for robots with closed loops, which inverse kinematics does not support.
void refuse_tip_moves(const TrajectoryPlan& plan, Diagnostics& diagnostics) {
  const char *what = "places of the tip in robots with closed loops are not supported yet",
             *hint = "say where the independent joints are";
  if (is_at_tip(plan.start)) diagnostics.unsupported(std::get<TipPosture>(plan.start).place, what, hint);
  for (const Segment& segment : plan.segments) {
    if (is_at_tip(segment)) diagnostics.unsupported(segment.place, what, hint);
  }
  if (plan.tip_force && plan.tip_force->in_tip_axes) {
    diagnostics.unsupported({plan.file, 0}, "tip forces in tip axes of robots with closed loops are not supported yet",
                            "give them in base axes");
  }
}

}  // namespace

bool is_plan(const std::filesystem::path& path) { return kind_of(path) == FileKind::toml; }

Trajectory read_trajectory(const std::filesystem::path& path, const Robot& robot, const Mechanism& mechanism,
                           Diagnostics& diagnostics, std::optional<int> intervals) {
  if (!is_plan(path)) return read_samples(path, mechanism, diagnostics);
  const TipKinematics tip(robot);
  const TrajectoryPlan plan = read_plan(path, mechanism, diagnostics);
  if (mechanism.has_loops()) refuse_tip_moves(plan, diagnostics);
  return diagnostics.has_errors() ? Trajectory{} : planned_motion(plan, tip, diagnostics, intervals);
}

}  // namespace flatdyn
