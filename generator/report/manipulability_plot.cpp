// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/manipulability_plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace flatdyn {
namespace {

constexpr std::size_t kEllipsoidsDrawn = 12, kEllipsoidsAcrossMap = 14;
constexpr std::size_t kJointsInNames = 3;
constexpr int kOutlinePoints = 120, kOutlinePointsOfMap = 40;
// The largest half axis in the picture, as a share of the arm's length.
constexpr double kDrawnPart = 0.35, kDrawnPartOfPath = 0.12;
// The distance from the sides and the length of the base frame's axes, as shares of a view's side; their names are a
// little beyond their ends.
constexpr double kTriadCorner = 0.14, kTriadLength = 0.11, kBeyond = 1.35;
constexpr double kMargin = 1.06, kFar = std::numeric_limits<double>::infinity();
// Near singular postures of light wrists, ellipsoids are many times as long as elsewhere. In a map, this share of them
// is drawn as large as the grid allows, and those more than kUncommon times as long are left out; measures that differ
// by more than kUncommonMeasure get logarithmic colours.
constexpr double kCommonPart = 0.9, kUncommon = 3, kUncommonMeasure = 20;
constexpr double kBreak = std::numeric_limits<double>::quiet_NaN();

// The projection from the task's directions to the picture; rotations are not shown.
Eigen::MatrixXd projection(const std::vector<int>& task, const View& view) {
  Eigen::MatrixXd onto = Eigen::MatrixXd::Zero(2, static_cast<Eigen::Index>(task.size()));
  for (std::size_t i = 0; i < task.size(); ++i) {
    if (task[i] < 3) onto.col(static_cast<Eigen::Index>(i)) = view.onto.col(task[i]);
  }
  return onto;
}

// The ellipses to draw, with half axes as columns: the outline, and for an ellipsoid in space also those through two of
// its axes.
std::vector<Eigen::Matrix2d> ellipses(const Ellipsoid& ellipsoid, const Eigen::MatrixXd& onto, const View& view) {
  std::vector<Eigen::Matrix2d> all = {projected_axes(ellipsoid, onto)};
  const Eigen::MatrixXd half = onto * ellipsoid.axes * ellipsoid.lengths.asDiagonal();
  if (!view.is_oblique || half.cols() != 3) return all;
  for (Eigen::Index k = 0; k < 3; ++k) {
    all.push_back((Eigen::Matrix2d() << half.col(k), half.col((k + 1) % 3)).finished());
  }
  return all;
}

double longest_axis(const Eigen::Matrix2d& axes) { return axes.colwise().norm().maxCoeff(); }

void add_point(Series& series, const Eigen::Vector2d& point) {
  series.x.push_back(point.x());
  series.y.push_back(point.y());
}

void add_line(Series& series, const std::vector<Eigen::Vector3d>& points, const View& view) {
  for (const Eigen::Vector3d& point : points) add_point(series, view.onto * point);
  add_point(series, {kBreak, kBreak});
}

Series arm_line(const ManipulablePose& pose, const View& view) {
  Series line{"", {}, {}, SeriesKind::arm};
  add_line(line, pose.skeleton, view);
  return line;
}

std::string pose_name(const std::vector<ManipulablePose>& poses, std::size_t k) {
  const ManipulablePose& pose = poses[k];
  if (pose.t) return fmt::format("t = {:.3g} s", *pose.t);
  if (pose.q.size() > kJointsInNames) return fmt::format("pose {}", k + 1);
  std::vector<std::string> numbers;
  for (const double q : pose.q) numbers.push_back(fmt::format("{:.3g}", q));
  return fmt::format("q = {}", fmt::join(numbers, ", "));
}

void add_outline(Series& curve, const Eigen::Vector2d& centre, const Eigen::Matrix2d& axes, int points) {
  for (int k = 0; k <= points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points;
    add_point(curve, centre + axes * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  add_point(curve, {kBreak, kBreak});
}

// Indices of poses, evenly spaced, ends included.
std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (count <= most) most = count;
  for (std::size_t k = 0; k < most; ++k) chosen.push_back(most == 1 ? 0 : k * (count - 1) / (most - 1));
  return chosen;
}

struct EllipsoidDrawing {
  const std::vector<int>& task;
  const std::vector<ManipulablePose>& poses;
  std::vector<std::size_t> chosen;
  double reach = 0, scale = 1;  // m; m per m/s^2

  bool is_path() const { return chosen.size() < poses.size(); }
};

EllipsoidDrawing drawing_of(const std::vector<int>& task, const std::vector<ManipulablePose>& poses,
                            const std::vector<View>& views) {
  EllipsoidDrawing drawing{task, poses, evenly(poses.size(), kEllipsoidsDrawn)};
  double largest = 0;
  for (const std::size_t k : drawing.chosen) {
    drawing.reach = std::max(drawing.reach, length_of(poses[k].skeleton));
    for (const View& view : views) {
      const Eigen::MatrixXd onto = projection(task, view);
      const Ellipsoid& ellipsoid = poses[k].ellipsoid;
      largest =
          std::max({largest, longest_axis(projected_axes(ellipsoid, onto)), (onto * ellipsoid.centre).norm() / 2});
    }
  }
  const double part = drawing.is_path() ? kDrawnPartOfPath : kDrawnPart;
  if (largest > 0) drawing.scale = part * drawing.reach / largest;
  return drawing;
}

// The note in a title that the base floats, whose axes the pictures have.
std::string base_note(const std::vector<ManipulablePose>& poses) { return poses.front().g_b ? ", free base" : ""; }

std::string label_of(const std::string& axis) { return axis.empty() ? "m" : axis + " in m"; }

Panel view_panel(const EllipsoidDrawing& drawing, const View& view, bool is_half) {
  Panel panel{is_half ? view.name : "", label_of(view.across), label_of(view.up), {}, PanelStyle::plane};
  panel.is_half = is_half;
  const Eigen::MatrixXd onto = projection(drawing.task, view);
  for (const std::size_t k : drawing.chosen) {
    const ManipulablePose& pose = drawing.poses[k];
    const Eigen::Vector2d centre = view.onto * pose.skeleton.back() + drawing.scale * (onto * pose.ellipsoid.centre);
    Series curve{pose_name(drawing.poses, k), {}, {}};
    for (const auto& axes : ellipses(pose.ellipsoid, onto, view))
      add_outline(curve, centre, drawing.scale * axes, kOutlinePoints);
    panel.series.push_back(std::move(curve));
  }
  for (const std::size_t k : drawing.chosen) {
    const bool is_end = k == drawing.chosen.front() || k == drawing.chosen.back();
    if (!drawing.is_path() || is_end) panel.series.push_back(arm_line(drawing.poses[k], view));
  }
  if (drawing.is_path()) {
    Series path{"", {}, {}, SeriesKind::guide};
    for (const ManipulablePose& pose : drawing.poses) add_point(path, view.onto * pose.skeleton.back());
    panel.series.push_back(std::move(path));
  }
  return panel;
}

Window bounds(const Panel& panel) {
  Window window{kFar, -kFar, kFar, -kFar};
  for (const Series& series : panel.series) {
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (!std::isfinite(series.x[k])) continue;
      window = {std::min(window.left, series.x[k]), std::max(window.right, series.x[k]),
                std::min(window.bottom, series.y[k]), std::max(window.top, series.y[k])};
    }
  }
  return window;
}

// Gives all panels squares of one size, so that they share one scale.
void share_scale(std::vector<Panel>& panels) {
  double half = 0;
  for (const Panel& panel : panels) {
    const Window window = bounds(panel);
    half = std::max({half, (window.right - window.left) / 2, (window.top - window.bottom) / 2});
  }
  half = half > 0 ? half * kMargin : 1;  // at one point only
  for (Panel& panel : panels) {
    const Window window = bounds(panel);
    const double x = (window.left + window.right) / 2, y = (window.bottom + window.top) / 2;
    panel.window = {x - half, x + half, y - half, y + half};
  }
}

// The number of points within half a side of a square's middle.
std::size_t points_near(const Panel& panel, const Eigen::Vector2d& middle, double half) {
  std::size_t count = 0;
  for (const Series& series : panel.series) {
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      const Eigen::Vector2d way = Eigen::Vector2d(series.x[k], series.y[k]) - middle;
      if (way.cwiseAbs().maxCoeff() < half) ++count;  // false for breaks
    }
  }
  return count;
}

// The place for the base frame's axes: the corner with the fewest points, the lower left one if there is a choice.
Eigen::Vector2d empty_corner(const Panel& panel) {
  const Window& window = *panel.window;
  const double side = window.right - window.left, margin = kTriadCorner * side;
  const double left = window.left + margin, right = window.right - margin;
  const double bottom = window.bottom + margin, top = window.top - margin;
  Eigen::Vector2d best(left, bottom);
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(right, bottom), Eigen::Vector2d(left, top), Eigen::Vector2d(right, top)}) {
    if (points_near(panel, corner, margin) < points_near(panel, best, margin)) best = corner;
  }
  return best;
}

// Adds the base frame's axes in a corner, without which a view in space cannot be read.
void add_triad(Panel& panel, const View& view) {
  const double side = panel.window->right - panel.window->left;
  const Eigen::Vector2d corner = empty_corner(panel);
  Series axes{"", {}, {}, SeriesKind::guide};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d axis = kTriadLength * side * view.onto.col(k), at = corner + kBeyond * axis;
    for (const Eigen::Vector2d& point : {corner, Eigen::Vector2d(corner + axis)}) add_point(axes, point);
    add_point(axes, {kBreak, kBreak});
    panel.notes.push_back({at.x(), at.y(), std::string(1, "xyz"[k])});
  }
  panel.series.push_back(std::move(axes));
}

// Curves of all half axes and measures, by time or by number of the pose.
std::vector<Panel> curves_along(const EllipsoidDrawing& drawing) {
  const bool is_timed = drawing.poses.front().t.has_value();
  const std::string across = is_timed ? "t in s" : "pose";
  Panel lengths{"half axes", across, "m/s^2", {}}, measure{"measure", across, "", {}};
  const Eigen::Index axes = drawing.poses.front().ellipsoid.lengths.size();
  for (Eigen::Index i = 0; i < axes; ++i) lengths.series.push_back({fmt::format("axis {}", i + 1), {}, {}});
  measure.series.push_back({"", {}, {}});
  for (std::size_t k = 0; k < drawing.poses.size(); ++k) {
    const ManipulablePose& pose = drawing.poses[k];
    const double at = is_timed ? *pose.t : static_cast<double>(k + 1);
    for (Eigen::Index i = 0; i < axes; ++i) {
      add_point(lengths.series[static_cast<std::size_t>(i)], {at, pose.ellipsoid.lengths(i)});
    }
    add_point(measure.series.front(), {at, pose.ellipsoid.measure});
  }
  return {std::move(lengths), std::move(measure)};
}

// The indices of a pose's cell in the grid that starts at the first pose.
Eigen::Vector2i cell_of(const ManipulablePose& pose, const ManipulablePose& first, const View& view, double spacing) {
  const Eigen::Vector2d way = view.onto * (pose.skeleton.back() - first.skeleton.back());
  return (way / spacing).array().round().cast<int>();
}

double quantile(std::vector<double> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The number of cells between drawn ellipsoids, such that several stand side by side across the map.
int stride_of(const std::vector<Eigen::Vector2i>& cells) {
  Eigen::Vector2i low = cells.front(), high = cells.front();
  for (const Eigen::Vector2i& cell : cells) {
    low = low.cwiseMin(cell);
    high = high.cwiseMax(cell);
  }
  return std::max(1, ((high - low).maxCoeff() + 1) / static_cast<int>(kEllipsoidsAcrossMap));
}

}  // namespace

std::string manipulability_plot(const std::string& robot, const std::vector<int>& task,
                                const std::vector<ManipulablePose>& poses, const std::vector<View>& views,
                                PictureFormat format) {
  const EllipsoidDrawing drawing = drawing_of(task, poses, views);
  std::vector<Panel> panels;
  for (const View& view : views) panels.push_back(view_panel(drawing, view, views.size() > 1));
  std::string title = robot + ": dynamic manipulability" + base_note(poses);
  const std::string scale = fmt::format("1 m is {:.3g} m/s^2", 1 / drawing.scale);
  if (views.size() == 1) {
    panels.front().title = "accelerations at the tip: " + scale;
  } else {
    title += ", " + scale;
    share_scale(panels);
  }
  for (std::size_t k = 0; k < views.size(); ++k) {
    if (!views[k].is_oblique) continue;
    if (!panels[k].window) share_scale(panels);
    add_triad(panels[k], views[k]);
  }
  if (drawing.is_path()) {
    for (Panel& panel : curves_along(drawing)) panels.push_back(std::move(panel));
  }
  return plot(title, panels, format);
}

std::string workspace_plot(const std::string& robot, const std::vector<int>& task,
                           const std::vector<ManipulablePose>& poses, const View& view, double spacing,
                           PictureFormat format) {
  const Eigen::MatrixXd onto = projection(task, view);
  Series measure{"", {}, {}, SeriesKind::cells}, outlines{"", {}, {}};
  std::vector<Eigen::Vector2i> cells;
  std::vector<double> longest;
  for (const ManipulablePose& pose : poses) {
    cells.push_back(cell_of(pose, poses.front(), view, spacing));
    add_point(measure, view.onto * pose.skeleton.back());
    measure.value.push_back(pose.ellipsoid.measure);
    longest.push_back(longest_axis(projected_axes(pose.ellipsoid, onto)));
  }
  const int stride = stride_of(cells);
  const double common = quantile(longest, kCommonPart), scale = common > 0 ? 0.5 * stride * spacing / common : 1;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const bool is_drawn = cells[k].x() % stride == 0 && cells[k].y() % stride == 0;
    if (!is_drawn || longest[k] > kUncommon * common) continue;
    add_outline(outlines, view.onto * poses[k].skeleton.back(), scale * projected_axes(poses[k].ellipsoid, onto),
                kOutlinePointsOfMap);
  }
  const double middle = quantile(measure.value, 0.5);
  Panel panel{fmt::format("ellipsoids about places of the tip: 1 m is {:.3g} m/s^2", 1 / scale),
              label_of(view.across),
              label_of(view.up),
              {},
              PanelStyle::plane};
  panel.has_logarithmic_values = quantile(measure.value, 1) > kUncommonMeasure * middle && middle > 0;
  for (double& value : measure.value) {
    if (panel.has_logarithmic_values) value = std::max(value, middle / kUncommonMeasure);
  }
  panel.series = {std::move(measure), std::move(outlines), arm_line(poses.front(), view)};
  panel.cell = spacing;
  panel.value_label = "measure";
  return plot(robot + ": dynamic manipulability in the workspace" + base_note(poses), {panel}, format);
}

}  // namespace flatdyn
