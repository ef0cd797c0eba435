// SPDX-License-Identifier: GPL-2.0-or-later
// Arms with their dynamic manipulability ellipsoids as pictures, as in Figure 7.15.
#pragma once

#include "plot/plot.hpp"
#include "plot/view.hpp"
#include "report/manipulability_report.hpp"

namespace flatdyn {

// Outlines of the ellipsoids at the arm's tip, of the accelerations along x, y, z, in each view; of spatial ones also
// the three ellipses through two of their axes. Of more poses than can be told apart, some, evenly spaced, with the
// tip's path, and all half axes and measures as curves.
std::string manipulability_plot(const std::string& robot, const std::vector<int>& task,
                                const std::vector<ManipulablePose>& poses, const std::vector<View>& views,
                                PictureFormat format);

// Poses at places of a square grid in the view's plane, `spacing` m apart, the first one the start: the measure as
// colour, some ellipsoids about their places, and the arm where it starts.
std::string workspace_plot(const std::string& robot, const std::vector<int>& task,
                           const std::vector<ManipulablePose>& poses, const View& view, double spacing,
                           PictureFormat format);

}  // namespace flatdyn
