// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of arms with their dynamic manipulability ellipsoids, as in Figure 7.15. They have the axes of the base
// frame, whose origin is where the arm begins, with a floating base, too.
#pragma once

#include "report/manipulability_report.hpp"
#include "report/plot/plot.hpp"
#include "report/plot/view.hpp"

namespace flatdyn {

// The outlines, in each view, of the ellipsoids of accelerations along x, y, z at the arm's tip; for spatial ones also
// the three ellipses through two of their axes. If there are too many poses to tell apart, some are drawn, evenly
// spaced, with the tip's path, and all half axes and measures as curves.
std::string manipulability_plot(const std::string& robot, const std::vector<int>& task,
                                const std::vector<ManipulablePose>& poses, const std::vector<View>& views,
                                PictureFormat format);

// A map of poses on a square grid in the view's plane, `spacing` m apart, the first one the start: the measure as
// colour, some ellipsoids at their places, and the arm at the start.
std::string workspace_plot(const std::string& robot, const std::vector<int>& task,
                           const std::vector<ManipulablePose>& poses, const View& view, double spacing,
                           PictureFormat format);

}  // namespace flatdyn
