// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/scatter_plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/plot/gnuplot.hpp"
#include "report/plot/label_layout.hpp"

namespace flatdyn {
namespace {

constexpr double kSheetWidth = 860, kSheetTitle = 44, kSheetPanel = 350;
// The distances, in pixels, of a panel's frame from the panel's edges.
constexpr double kLeft = 78, kRight = 90, kTop = 34, kBottom = 62;

// An axis: decimal logarithms of its ends, of the least number that is marked, and of the place where zero is shown.
struct Axis {
  double low = 0, high = 1, first = low, zero = low;
  double part(double value) const { return (std::log10(value) - low) / (high - low); }
};

// An axis for all values with some room around them, at least `least` decades long.
Axis axis_of(const std::vector<double>& values, double least) {
  Axis axis{1e300, -1e300, 0, 0};
  for (const double value : values) {
    if (!(value > 0)) continue;
    axis.low = std::min(axis.low, std::log10(value));
    axis.high = std::max(axis.high, std::log10(value));
  }
  if (axis.low > axis.high) return {-1, 1, 2, -0.9};
  const double room = std::max(0.08 * (axis.high - axis.low), (least - (axis.high - axis.low)) / 2);
  const double first = axis.low - room;
  return {first, axis.high + room, first, first};
}

// Adds room for zero below the numbers, if there are any.
void add_zero(Axis& axis) {
  if (axis.first > axis.high) return;
  const double room = 0.12 * (axis.high - axis.first);
  axis.low = axis.first - room;
  axis.zero = axis.first - room / 2;
}

// Whether the point is within the numbers that axes with room around them can represent.
bool point_has_place(const ScatterPoint& point) {
  constexpr double kLeast = 1e-250, kMost = 1e250;
  return point.x > kLeast && point.x < kMost && (point.y == 0 || (point.y > kLeast && point.y < kMost));
}

// The marks: one, two and five of each decade; for many decades only the powers of ten. "2e1" is written as 20.
std::string ticks(const Axis& axis) {
  std::vector<std::string> marks;
  const bool few = axis.high - axis.first < 4;
  const int stride = axis.high - axis.first > 10 ? 2 : 1;
  if (axis.low < axis.first) marks.push_back(fmt::format("'exact' {:.10g}", std::pow(10.0, axis.zero)));
  for (int decade = static_cast<int>(std::floor(axis.first)); decade <= axis.high; ++decade) {
    for (const int digit : {1, 2, 5}) {
      const double value = digit * std::pow(10.0, decade);
      if (std::log10(value) < axis.first || std::log10(value) > axis.high) continue;
      if (digit > 1 ? !few : (!few && decade % stride != 0)) continue;
      const std::string text = std::abs(decade) < 4 ? fmt::format("{:g}", value) : fmt::format("{}e{}", digit, decade);
      marks.push_back(fmt::format("'{}' {:.10g}", text, value));
    }
  }
  return fmt::format("({})", fmt::join(marks, ", "));
}

class PanelWriter {
 public:
  explicit PanelWriter(const ScatterPanel& panel) : panel_(panel) {
    for (const ScatterPoint& point : panel.points) {
      if (point_has_place(point)) points_.push_back(point);
    }
    std::stable_sort(points_.begin(), points_.end(),
                     [](const ScatterPoint& a, const ScatterPoint& b) { return a.x < b.x; });
    std::vector<double> x, y;
    for (const ScatterPoint& point : points_) {
      x.push_back(point.x);
      y.push_back(point.y);
    }
    x_ = axis_of(x, 1);
    y_ = axis_of(y, 2);
    if (std::find(y.begin(), y.end(), 0) != y.end()) add_zero(y_);
    for (ScatterPoint& point : points_) point.y = std::max(point.y, std::pow(10.0, y_.zero));
    frame_ = {kLeft, kTop, kSheetWidth - kRight, kSheetPanel - kBottom};
    for (const Box& flag : flags()) headroom_ = std::max(headroom_, frame_.top - flag.top);
  }

  double height() const { return kSheetPanel + headroom_; }

  // The commands for panel `index` at distance `top` from the top of a sheet of this height.
  std::string text(std::size_t index, double top, double sheet_height) {
    height_ = sheet_height;
    frame_.top = top + headroom_ + kTop;
    frame_.bottom = top + height() - kBottom;
    if (points_.empty()) return heading(top) + axes() + nothing();
    return heading(top) + axes() + labels() + data_block(index, "points", points_) +
           data_block(index, "front", front()) + plot(index);
  }

 private:
  double pixel_x(const ScatterPoint& p) const { return frame_.left + x_.part(p.x) * (frame_.right - frame_.left); }
  double pixel_y(const ScatterPoint& p) const { return frame_.bottom - y_.part(p.y) * (frame_.bottom - frame_.top); }
  // A position for gnuplot, which counts from the lower left corner in fractions of the sheet.
  std::string screen(double x, double y) const {
    return fmt::format("screen {:.5f}, screen {:.5f}", x / kSheetWidth, 1 - y / height_);
  }

  // The heading above the names.
  std::string heading(double top) const {
    return fmt::format("set label {} at {} center noenhanced textcolor rgb '{}'\n", gnuplot_string(panel_.title),
                       screen((frame_.left + frame_.right) / 2, top + 0.4 * kTop), kPlotInk);
  }

  // The frame with a text in it, for a panel without points.
  std::string nothing() const {
    return fmt::format("set label 'nothing to plot' at {} center textcolor rgb '{}'\nplot [1:10] [1:10] NaN notitle\n",
                       screen((frame_.left + frame_.right) / 2, (frame_.top + frame_.bottom) / 2), kPlotInk);
  }

  std::string axes() const {
    return fmt::format(
               "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
               "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
               "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {}\nset ytics {}\n"
               "unset arrow\n",
               frame_.left / kSheetWidth, frame_.right / kSheetWidth, 1 - frame_.top / height_,
               1 - frame_.bottom / height_, std::pow(10.0, x_.low), std::pow(10.0, x_.high), std::pow(10.0, y_.low),
               std::pow(10.0, y_.high), ticks(x_), ticks(y_)) +
           gnuplot_label("xlabel", panel_.x_label, "offset 0,0.4") + gnuplot_label("ylabel", panel_.y_label);
  }

  std::vector<Box> flags() const {
    std::vector<LabelledPoint> wanted;
    for (const ScatterPoint& p : points_) wanted.push_back({pixel_x(p), pixel_y(p), p.name});
    return placed_labels(wanted, frame_);
  }

  std::string labels() const {
    const std::vector<Box> placed = flags();
    std::string text;
    for (std::size_t k = 0; k < placed.size(); ++k) {
      const Box& flag = placed[k];
      const double middle = (flag.top + flag.bottom) / 2;
      text +=
          fmt::format("set label {} at {} left noenhanced font ',11' textcolor rgb '{}' front\n",
                      gnuplot_string(points_[k].name), screen(flag.left + 4, middle), kPlotColours[points_[k].colour]);
      text += fmt::format("set arrow from {} to {} nohead linewidth 0.6 linecolor rgb '{}'\n",
                          screen(flag.left, pixel_y(points_[k])), screen(flag.left, middle),
                          kPlotColours[points_[k].colour]);
    }
    return text;
  }

  std::vector<ScatterPoint> front() const {
    std::vector<ScatterPoint> on_it;
    std::copy_if(points_.begin(), points_.end(), std::back_inserter(on_it),
                 [](const ScatterPoint& p) { return p.on_front; });
    return on_it;
  }

  static std::string data_block(std::size_t index, const std::string& name, const std::vector<ScatterPoint>& points) {
    std::string text = fmt::format("${}{} << EOD\n", name, index);
    for (const ScatterPoint& p : points) {
      text += fmt::format("{:.6g} {:.6g} {} {}\n", p.x, p.y, std::string(kPlotColours[p.colour]).replace(0, 1, "0x"),
                          p.is_hollow ? 12 : 7);
    }
    return text + "EOD\n";
  }

  // Points on the front have a ring.
  static std::string plot(std::size_t index) {
    return fmt::format(
        "plot $points{0} using 1:2:4:3 with points pointtype variable pointsize 0.7 linecolor rgb variable notitle, "
        "$front{0} using 1:2:3 with points pointtype 6 pointsize 1.4 linewidth 1.2 linecolor rgb variable notitle\n",
        index);
  }

  const ScatterPanel& panel_;
  double height_ = 1;    // height of the sheet
  double headroom_ = 0;  // height of the names above the frame
  std::vector<ScatterPoint> points_;
  Axis x_, y_;
  Box frame_;
};

}  // namespace

std::string svg_scatter(const std::string& title, const std::vector<ScatterPanel>& panels) {
  const std::vector<ScatterPanel> drawn = panels.empty() ? std::vector<ScatterPanel>(1) : panels;
  std::vector<PanelWriter> writers(drawn.begin(), drawn.end());
  double height = kSheetTitle;
  for (const PanelWriter& writer : writers) height += writer.height();
  const auto script = [&](const std::filesystem::path& output) {
    std::string text = fmt::format(
        "set terminal svg size {},{} dynamic rounded font 'sans-serif,12'\nset output {}\nset encoding utf8\n"
        "set border 3 linecolor rgb '{}'\nset tics nomirror out scale 0.5 textcolor rgb '{}'\n"
        "set grid linecolor rgb '{}' linewidth 0.4 dashtype 3\nset logscale xy\nset multiplot\n",
        kSheetWidth, height, gnuplot_string(output.string()), kPlotInk, kPlotInk, kPlotInk);
    text += fmt::format("set label 1 {} at screen 0.5, screen {:.5f} center noenhanced font ',15' textcolor rgb '{}'\n",
                        gnuplot_string(title), 1 - 0.5 * kSheetTitle / height, kPlotInk);
    double top = kSheetTitle;
    for (std::size_t k = 0; k < writers.size(); ++k) {
      text += writers[k].text(k, top, height) + "unset label\n";
      top += writers[k].height();
    }
    return text + "unset multiplot\n";
  };
  return gnuplot_picture(script);
}

}  // namespace flatdyn
